#include "PointChoice.h"

#include "NumberText.h"
#include "PositionFunctions.h"
#include "Require.h"
#include "SelectedPoints.h"

#include "vtkPointSetScalarFunction.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace SurfaceScalars
{
namespace
{

using Ids = std::vector<vtkIdType>;
using Filter = vtkPointSetScalarFunction;

bool isHarmonic(const PointChoice& choice)
{
  return choice.filter.GetFunction() == Filter::HARMONIC;
}

/// The property that names the points, for errors.
std::string propertyOf(const PointChoice& choice)
{
  if (choice.filter.GetSourceType() == Filter::SELECTION)
  {
    return "a Selection";
  }
  return isHarmonic(choice) ? "ConstraintIds" : "SourceIds";
}

Ids givenIds(const PointChoice& choice)
{
  Filter& filter = choice.filter;
  const bool harmonic = isHarmonic(choice);
  Ids ids(static_cast<std::size_t>(
    harmonic ? filter.GetNumberOfConstraintIds() : filter.GetNumberOfSourceIds()));
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    const int index = static_cast<int>(i);
    ids[i] = harmonic ? filter.GetConstraintIds(index) : filter.GetSourceIds(index);
  }
  require(!ids.empty(),
    propertyOf(choice) +
      (harmonic ? ", the points whose values are given" : ", the points to start from"),
    "none",
    "List their ids, which the Spreadsheet View shows, or choose SourceType Selection or Point.");
  return ids;
}

Ids selectedIds(const PointChoice& choice)
{
  Ids ids = choice.selection ? selectedPoints(choice.selection, choice.input) : Ids();
  require(!ids.empty(), "a Selection of points",
    choice.selection ? "one of no points of the input" : "none",
    "Select points in a view and copy the active selection, or choose SourceType Ids or Point.");
  return ids;
}

/// The point that is nearest to a place.
vtkIdType nearestTo(const Vector3d& place, const PointChoice& choice, const VertexMap& map)
{
  vtkIdType nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (vtkIdType id = 0; id < map.pointCount(); ++id)
  {
    const double distance =
      map.vertexOf(id) == VertexMap::None ? least : (choice.points.col(id) - place).squaredNorm();
    if (distance < least)
    {
      least = distance;
      nearest = id;
    }
  }
  return nearest;
}

Ids nearestIds(const PointChoice& choice, const VertexMap& map)
{
  const auto nearest = [&](const std::string& property, const double* place)
  { return nearestTo(finitePlace(property, place), choice, map); };
  Filter& filter = choice.filter;
  return isHarmonic(choice) ? Ids{ nearest("ConstraintPoint1", filter.GetConstraintPoint1()),
    nearest("ConstraintPoint2", filter.GetConstraintPoint2()) }
                            : Ids{ nearest("SourcePoint", filter.GetSourcePoint()) };
}

/// @throws InvalidInput unless the point is a vertex of the surface
void checkId(vtkIdType id, const PointChoice& choice, const VertexMap& map)
{
  const std::string found = std::to_string(id);
  require(id >= 0 && id < map.pointCount(),
    propertyOf(choice) + " from 0 to " + std::to_string(map.pointCount() - 1), found,
    "Choose points of the input.");
  require(map.vertexOf(id) != VertexMap::None, propertyOf(choice) + " of points on the surface",
    "point " + found +
      (choice.points.col(id).allFinite() ? ", which is in no triangle"
                                         : ", which has a NaN or infinite coordinate"),
    "Choose another point.");
}

/// The points chosen, all of them vertices.
Ids chosenIds(const PointChoice& choice, const VertexMap& map)
{
  const int type = choice.filter.GetSourceType();
  Ids ids = type == Filter::IDS ? givenIds(choice)
    : type == Filter::SELECTION ? selectedIds(choice)
                                : nearestIds(choice, map);
  for (const vtkIdType id : ids)
  {
    checkId(id, choice, map);
  }
  return ids;
}

std::vector<double> constraintValues(Filter& filter, std::size_t count)
{
  std::vector<double> values;
  for (int i = 0; i < filter.GetNumberOfConstraintValues(); ++i)
  {
    values.push_back(filter.GetConstraintValues(i));
    require(std::isfinite(values.back()), "finite numbers as ConstraintValues",
      textOf(values.back()) + " at index " + std::to_string(i), "Correct or remove it.");
  }
  const int type = filter.GetSourceType();
  if (values.empty() && type != Filter::IDS)
  {
    values.resize(count);
    for (std::size_t i = 0; i < count; ++i)
    {
      values[i] = static_cast<double>(i) / static_cast<double>(std::max<std::size_t>(1, count - 1));
    }
  }
  if (type == Filter::POINT)
  {
    values.resize(std::min(values.size(), count)); // what is left of a longer list of ids
  }
  require(values.size() == count,
    "as many ConstraintValues as constrained points (" + std::to_string(count) + ")",
    std::to_string(values.size()),
    type == Filter::IDS ? "Give one for each of ConstraintIds."
                        : "Give one for each point, or none: 0 to 1.");
  return values;
}

} // namespace

std::vector<Index> chosenSources(const PointChoice& choice, const VertexMap& map)
{
  std::vector<Index> sources;
  for (const vtkIdType id : chosenIds(choice, map))
  {
    sources.push_back(map.vertexOf(id));
  }
  std::sort(sources.begin(), sources.end());
  sources.erase(std::unique(sources.begin(), sources.end()), sources.end());
  return sources;
}

std::vector<ValueConstraint> chosenConstraints(const PointChoice& choice, const VertexMap& map)
{
  const Ids ids = chosenIds(choice, map);
  const std::vector<double> values = constraintValues(choice.filter, ids.size());
  std::vector<ValueConstraint> constraints;
  std::map<Index, std::size_t> known; // where the constraint of a vertex comes from
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    const Index vertex = map.vertexOf(ids[i]);
    const auto [first, isNew] = known.emplace(vertex, i);
    const std::size_t other = first->second;
    require(values[other] == values[i], "one value at each place",
      textOf(values[other]) + " at point " + std::to_string(ids[other]) + " and " +
        textOf(values[i]) + " at point " + std::to_string(ids[i]) +
        (ids[other] == ids[i] ? "" : ", which is at the same place"),
      "Remove one of the two.");
    if (isNew)
    {
      constraints.push_back({ vertex, values[i] });
    }
  }
  return constraints;
}

} // namespace SurfaceScalars
