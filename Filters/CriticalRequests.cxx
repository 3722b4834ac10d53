#include "CriticalRequests.h"

#include "FilterRun.h"
#include "NumberText.h"
#include "PointSetInput.h"
#include "Require.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace SurfaceScalars
{
namespace
{

constexpr int MostMultiplicity = 1000000; // far more than any vertex can have

/// The numbers of a point array in all blocks.
/// @param other taken where a block has none; NaN refuses that
Values numbersOf(const std::vector<vtkPointSet*>& blocks, const char* name, double other)
{
  std::vector<double> numbers;
  for (vtkPointSet* block : blocks)
  {
    const auto first = static_cast<std::ptrdiff_t>(numbers.size());
    numbers.resize(numbers.size() + static_cast<std::size_t>(block->GetNumberOfPoints()), other);
    vtkAbstractArray* array = block->GetPointData()->GetAbstractArray(name);
    if (!array)
    {
      continue;
    }
    auto* values = vtkDataArray::SafeDownCast(array);
    require(values && values->GetNumberOfComponents() == 1,
      std::string("one number per point in the array '") + name + "' of CriticalPoints",
      values ? std::to_string(values->GetNumberOfComponents()) : "no numbers",
      "Check what made this array.");
    copyNumbers(values, numbers.data() + first, {});
  }
  return Eigen::Map<const Values>(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
}

bool isAnywhere(const std::vector<vtkPointSet*>& blocks, const char* name)
{
  return std::any_of(blocks.begin(), blocks.end(),
    [name](vtkPointSet* block) { return block->GetPointData()->HasArray(name) != 0; });
}

/// All points of an input with their arrays.
struct GivenPoints
{
  Points places;
  Values types;
  Values multiplicities;
  Values values;
};

GivenPoints readGiven(vtkDataObject* input)
{
  const std::vector<vtkPointSet*> blocks = pointSetsOf(input);
  require(isAnywhere(blocks, "CriticalType"),
    "a point array 'CriticalType' of CriticalPoints: 0 minimum, 1 saddle, 3 maximum", "none",
    "Add one, with Calculator for example, or choose the CriticalPoints output of a filter.");
  GivenPoints given;
  given.types = numbersOf(blocks, "CriticalType", std::numeric_limits<double>::quiet_NaN());
  given.multiplicities = numbersOf(blocks, "Multiplicity", 1.0);
  given.values = numbersOf(blocks, "ScalarValue", std::numeric_limits<double>::quiet_NaN());
  given.places.resize(3, given.types.size());
  Eigen::Index next = 0;
  for (vtkPointSet* block : blocks)
  {
    given.places.middleCols(next, block->GetNumberOfPoints()) = readPoints(block->GetPoints(), {});
    next += block->GetNumberOfPoints();
  }
  return given;
}

std::string pointName(Eigen::Index point)
{
  return "point " + std::to_string(point) + " of CriticalPoints";
}

/// @throws InvalidInput unless it is one that a point can have
CriticalType typeOf(double number, Eigen::Index point)
{
  for (const CriticalType type :
    { CriticalType::Excluded, CriticalType::Minimum, CriticalType::Saddle, CriticalType::Maximum,
      CriticalType::Uncertain, CriticalType::Regular })
  {
    if (number == static_cast<double>(type))
    {
      return type;
    }
  }
  throw InvalidInput("0 (minimum), 1 (saddle) or 3 (maximum) as CriticalType",
    textOf(number) + " at " + pointName(point), "Correct it, or exclude the point with -1.");
}

int multiplicityOf(double number, Eigen::Index point)
{
  require(number >= 1.0 && number <= MostMultiplicity && number == std::floor(number),
    "a whole number from 1 on as Multiplicity of a saddle",
    textOf(number) + " at " + pointName(point), "Correct it.");
  return static_cast<int>(number);
}

CriticalRequest requestOf(const GivenPoints& given, CriticalType type, Eigen::Index point)
{
  CriticalRequest request;
  request.type = type;
  request.multiplicity =
    type == CriticalType::Saddle ? multiplicityOf(given.multiplicities(point), point) : 1;
  const double value = given.values(point);
  require(!std::isinf(value), "finite numbers as ScalarValue, or NaN where it is to be chosen",
    textOf(value) + " at " + pointName(point), "Correct it.");
  if (!std::isnan(value))
  {
    request.value = value;
  }
  require(given.places.col(point).allFinite(), "critical points with finite coordinates",
    "a NaN or infinite one of " + pointName(point), "Correct or remove it.");
  return request;
}

bool asksForNothing(CriticalType type)
{
  return type == CriticalType::Uncertain || type == CriticalType::Regular ||
    type == CriticalType::Excluded;
}

/// Whether any vertex of the closed star is marked.
bool isStarMarked(const MeshTopology& mesh, Index vertex, const std::vector<char>& marks)
{
  const VertexRange link = mesh.link(vertex);
  return marks[vertex] ||
    std::any_of(link.begin(), link.end(), [&](Index neighbor) { return marks[neighbor] != 0; });
}

} // namespace

CriticalRequests readRequests(FilterRun& run, vtkDataObject* input)
{
  CriticalRequests asked;
  if (!input || input->GetNumberOfElements(vtkDataObject::POINT) == 0)
  {
    return asked;
  }
  const GivenPoints given = readGiven(input);
  const Eigen::Index total = given.types.size();
  for (Eigen::Index point = 0; point < total; ++point)
  {
    const CriticalType type = typeOf(given.types(point), point);
    if (!asksForNothing(type))
    {
      asked.requests.push_back(requestOf(given, type, point));
      asked.points.push_back(point);
    }
  }
  asked.places = given.places(Eigen::all, asked.points);
  const Eigen::Index left = total - asked.places.cols();
  if (left > 0)
  {
    run.note("Left out " + std::to_string(left) + " of " + std::to_string(total) +
      " points of CriticalPoints, which are regular, uncertain or excluded (CriticalType 5, 4, "
      "-1).");
  }
  return asked;
}

void snapRequests(
  CriticalRequests& asked, const MeshedSurface& surface, const MeshTopology& mesh, double distance)
{
  const VertexName names = surface.map.names();
  const std::vector<Index> vertices = nearestVertices(
    surface.vertices, mesh, asked.places, distance, namesOf(asked, surface.map), names);
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    asked.requests[i].vertex = vertices[i];
  }
}

void addTemplate(FilterRun& run, const MeshTopology& mesh,
  const std::vector<CriticalRequest>& ofTemplate, CriticalRequests& asked)
{
  std::vector<char> taken(mesh.vertexCount());
  for (const CriticalRequest& request : asked.requests)
  {
    taken[request.vertex] = 1;
    for (const Index neighbor : mesh.link(request.vertex))
    {
      taken[neighbor] = 1;
    }
  }
  const std::size_t before = asked.requests.size();
  std::copy_if(ofTemplate.begin(), ofTemplate.end(), std::back_inserter(asked.requests),
    [&](const CriticalRequest& request) { return !isStarMarked(mesh, request.vertex, taken); });
  const std::size_t left = ofTemplate.size() - (asked.requests.size() - before);
  if (left > 0)
  {
    run.note("Left out " + std::to_string(left) + " of the template's " +
      std::to_string(ofTemplate.size()) +
      " critical points, which are at or next to points of CriticalPoints or their neighbors.");
  }
}

PlaceName namesOf(const CriticalRequests& asked, const VertexMap& map)
{
  return [asked, names = map.names()](std::size_t place)
  {
    return place < asked.points.size()
      ? pointName(asked.points[place])
      : "the template's point " + std::to_string(names(asked.requests[place].vertex));
  };
}

} // namespace SurfaceScalars
