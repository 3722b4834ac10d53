#include "MorsePoints.h"

#include "StarSigns.h"
#include "ValueOrder.h"

#include <algorithm>
#include <functional>

namespace SurfaceScalars
{
namespace
{

/// V - E + F by component.
std::vector<int> eulerCharacteristics(const MeshTopology& mesh)
{
  std::vector<int> doubled(mesh.componentCount(), 0); // E = 3/2 F
  for (Index vertex = 0; vertex < mesh.vertexCount(); ++vertex)
  {
    doubled[mesh.component(vertex)] += 2;
  }
  for (Eigen::Index t = 0; t < mesh.triangles().cols(); ++t)
  {
    --doubled[mesh.component(mesh.triangles()(0, t))];
  }
  for (int& characteristic : doubled)
  {
    characteristic /= 2;
  }
  return doubled;
}

/// Chooses critical points.
class Choice
{
public:
  Choice(const MeshTopology& mesh, const std::vector<CriticalRequest>& requests)
    : mesh_(mesh)
    , missing_(eulerCharacteristics(mesh))
    , hasMinimum_(mesh.componentCount(), 0)
    , hasMaximum_(mesh.componentCount(), 0)
    , isChosen_(mesh.vertexCount(), 0)
  {
    for (const CriticalRequest& request : requests)
    {
      this->add(request.vertex, request.type, request.multiplicity);
    }
  }

  /// Adds extrema of components without, from the most persistent, then what Euler's formula needs.
  void complete(std::vector<CriticalPoint> candidates);
  bool isComplete() const;
  const std::vector<MorsePoint>& points() const { return this->points_; }

private:
  void add(Index vertex, CriticalType type, int multiplicity);

  const MeshTopology& mesh_;
  std::vector<int> missing_; ///< by component: of the sum of the indices
  std::vector<char> hasMinimum_;
  std::vector<char> hasMaximum_;
  std::vector<char> isChosen_;
  std::vector<MorsePoint> points_;
};

void Choice::add(Index vertex, CriticalType type, int multiplicity)
{
  const Index component = this->mesh_.component(vertex);
  this->missing_[component] -= indexOf(type, multiplicity);
  this->hasMinimum_[component] |= type == CriticalType::Minimum ? 1 : 0;
  this->hasMaximum_[component] |= type == CriticalType::Maximum ? 1 : 0;
  this->isChosen_[vertex] = 1;
  this->points_.push_back({ vertex, type, multiplicity, {} });
}

void Choice::complete(std::vector<CriticalPoint> candidates)
{
  std::stable_sort(candidates.begin(), candidates.end(),
    [](const CriticalPoint& a, const CriticalPoint& b) { return a.persistence > b.persistence; });
  for (const bool areFirst : { true, false })
  {
    for (const CriticalPoint& point : candidates)
    {
      const auto vertex = static_cast<Index>(point.input);
      const Index component = this->mesh_.component(vertex);
      const int missing = this->missing_[component];
      const bool isSaddle = point.type == CriticalType::Saddle;
      const bool isFirst = (point.type == CriticalType::Minimum && !this->hasMinimum_[component]) ||
        (point.type == CriticalType::Maximum && !this->hasMaximum_[component]);
      const bool isWanted = areFirst ? isFirst : (isSaddle ? missing < 0 : missing > 0);
      if (isWanted && this->isChosen_[vertex] == 0)
      {
        this->add(vertex, point.type, isSaddle ? std::min(point.multiplicity, -missing) : 1);
      }
    }
  }
}

bool Choice::isComplete() const
{
  const auto isSet = [](char flag) { return flag != 0; };
  return std::all_of(this->missing_.begin(), this->missing_.end(), [](int m) { return m == 0; }) &&
    std::all_of(this->hasMinimum_.begin(), this->hasMinimum_.end(), isSet) &&
    std::all_of(this->hasMaximum_.begin(), this->hasMaximum_.end(), isSet);
}

/// @param types of the values
std::vector<int> sidesOf(
  const MeshTopology& mesh, const Values& values, const VertexTypes& types, const MorsePoint& point)
{
  const ValueOrder isBelow{ values.data() };
  const bool isSaddle = point.type == CriticalType::Saddle;
  std::vector<int> result;
  std::vector<double> differences;
  for (const Index neighbor : mesh.link(point.vertex))
  {
    result.push_back(isSaddle ? (isBelow(neighbor, point.vertex) ? -1 : 1)
                              : (point.type == CriticalType::Minimum ? 1 : -1));
    differences.push_back(values[neighbor] - values[point.vertex]);
  }
  const bool isMet = types.types[point.vertex] == point.type &&
    static_cast<int>(types.multiplicities[point.vertex]) == point.multiplicity;
  return !isSaddle || isMet ? result
                            : closestSigns(differences, std::vector<int>(result.size(), 0), true,
                                2 * point.multiplicity + 2);
}

} // namespace

std::vector<MorsePoint> morsePoints(const DesignMesh& mesh, const Values& values,
  const std::vector<CriticalRequest>& requests, const Execution& execution)
{
  const MeshTopology& topology = mesh.topology();
  Choice choice(topology, requests);
  choice.complete(
    meshCriticalPoints(mesh.vertices(), topology, values, execution.part(0.0, 0.8)).points);
  if (!choice.isComplete())
  {
    return {};
  }
  std::vector<MorsePoint> result = choice.points();
  const VertexTypes types = classifyVertices(topology, values, execution.part(0.8, 1.0));
  const ValueOrder isBelow{ values.data() };
  for (MorsePoint& point : result)
  {
    point.sides = sidesOf(topology, values, types, point);
  }
  std::sort(result.begin(), result.end(),
    [&](const MorsePoint& a, const MorsePoint& b)
    {
      const bool isMinimum = a.type == CriticalType::Minimum;
      return isMinimum != (b.type == CriticalType::Minimum) ? isMinimum
                                                            : isBelow(a.vertex, b.vertex);
    });
  return result;
}

std::vector<MorsePoint> upsideDown(std::vector<MorsePoint> points)
{
  std::reverse(points.begin(), points.end());
  for (MorsePoint& point : points)
  {
    std::transform(point.sides.begin(), point.sides.end(), point.sides.begin(), std::negate<>());
    point.type = point.type == CriticalType::Minimum ? CriticalType::Maximum
      : point.type == CriticalType::Maximum          ? CriticalType::Minimum
                                                     : point.type;
  }
  std::stable_partition(points.begin(), points.end(),
    [](const MorsePoint& point) { return point.type == CriticalType::Minimum; });
  return points;
}

std::vector<std::vector<Index>> lowerSectors(const MeshTopology& mesh, const MorsePoint& saddle)
{
  const Index* link = mesh.link(saddle.vertex).begin();
  const std::size_t size = saddle.sides.size();
  const auto higher = std::find(saddle.sides.begin(), saddle.sides.end(), 1);
  const auto first = static_cast<std::size_t>(higher - saddle.sides.begin());
  std::vector<std::vector<Index>> result;
  bool isNew = true;
  for (std::size_t i = 0; i < size; ++i)
  {
    const std::size_t place = (first + i) % size;
    if (saddle.sides[place] < 0)
    {
      if (isNew)
      {
        result.emplace_back();
      }
      result.back().push_back(link[place]);
    }
    isNew = saddle.sides[place] > 0;
  }
  return result;
}

} // namespace SurfaceScalars
