#include "FarthestPoints.h"

#include "MortonOrder.h"
#include "Quantile.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace SurfaceScalars
{
namespace
{

/// How far each candidate is from the nearest of those it has been told of.
class Distances
{
public:
  explicit Distances(const PointsRef& candidates)
    : rows_(candidates.transpose())
    , squared_(Eigen::ArrayXd::Constant(candidates.cols(), std::numeric_limits<double>::infinity()))
  {
  }

  void add(const Vector3d& place)
  {
    this->squared_ = this->squared_.min((this->rows_.col(0).array() - place.x()).square() +
      (this->rows_.col(1).array() - place.y()).square() +
      (this->rows_.col(2).array() - place.z()).square());
  }

  double squaredRadius(Eigen::Index& farthest) const { return this->squared_.maxCoeff(&farthest); }

private:
  Eigen::Matrix<double, Eigen::Dynamic, 3> rows_; ///< for long loops
  Eigen::ArrayXd squared_;
};

} // namespace

FarthestPoints farthestPoints(const PointsRef& candidates, const PointsRef& there,
  std::size_t count, const Execution& execution)
{
  FarthestPoints result;
  if (candidates.cols() == 0)
  {
    return result;
  }
  const auto steps = static_cast<double>(static_cast<std::size_t>(there.cols()) + count + 1);
  Distances distances(candidates);
  for (Eigen::Index i = 0; i < there.cols(); ++i)
  {
    execution.report(static_cast<double>(i) / steps);
    distances.add(there.col(i));
  }
  Eigen::Index farthest = 0;
  double squaredRadius = distances.squaredRadius(farthest);
  while (result.chosen.size() < count && squaredRadius > 0.0)
  {
    execution.report(
      static_cast<double>(static_cast<std::size_t>(there.cols()) + result.chosen.size()) / steps);
    result.chosen.push_back(static_cast<Index>(farthest));
    distances.add(candidates.col(farthest));
    squaredRadius = distances.squaredRadius(farthest);
  }
  result.radius = std::sqrt(squaredRadius);
  return result;
}

std::vector<Index> evenPart(const std::vector<Index>& items, std::size_t count)
{
  if (items.size() <= count)
  {
    return items;
  }
  std::vector<Index> result(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    result[i] = items[siteOf(i, count, items.size())];
  }
  return result;
}

std::vector<Index> evenSubset(
  const PointsRef& points, std::size_t count, const Execution& execution)
{
  return evenPart(mortonOrder(points, execution), count);
}

std::vector<Index> distinctPlaces(
  const PointsRef& points, const std::vector<Index>& indices, const Execution& execution)
{
  if (indices.empty())
  {
    return {};
  }
  const Points places = points(Eigen::all, indices);
  const std::vector<Index> order = mortonOrder(places, execution);
  std::vector<char> isRepeated(indices.size(), 0);
  for (std::size_t i = 1; i < order.size(); ++i)
  {
    isRepeated[order[i]] = places.col(order[i]) == places.col(order[i - 1]) ? 1 : 0;
  }
  std::vector<Index> result;
  for (std::size_t i = 0; i < indices.size(); ++i)
  {
    if (isRepeated[i] == 0)
    {
      result.push_back(indices[i]);
    }
  }
  return result;
}

} // namespace SurfaceScalars
