#include "CriticalTrust.h"

#include <algorithm>
#include <cstdlib>

namespace SurfaceScalars
{
namespace
{

// Eigenvalue to its standard error. Where there is no noise, the error is a smooth misfit and not
// spread as a noise's.
constexpr double Trusted = 20.0;
constexpr double TrustedInNoise = 5.0;
// If nothing else is known.
constexpr double Significant = 8.0;
constexpr double SignificantInNoise = 2.0;
constexpr double RidgeRatio = 0.02; // of eigenvalues
constexpr int FewestVotes = 2;      // of fits to many neighbors
constexpr int ManyNeighbors = 60;

Points placesOf(const std::vector<RefinedPoint>& points, const Trust& trust)
{
  Points places(3, static_cast<Eigen::Index>(points.size()));
  Eigen::Index count = 0;
  for (const RefinedPoint& point : points)
  {
    if (trust.isSure(point))
    {
      places.col(count++) = point.place;
    }
  }
  places.conservativeResize(3, count);
  return places;
}

} // namespace

Trust::Trust(const CriticalScale& scale)
  : isNoisy_(scale.isNoisy)
  , isFew_(scale.neighborCount <= ManyNeighbors)
{
}

std::optional<int> clearIndex(const RefinedPoint& point)
{
  const auto& [own, near, far, outer] = point.enclosed;
  const bool isSimple = own && std::abs(*own) == 1;
  // Of a degenerate point; the more multiple, the farther its parts.
  const bool isPart = std::abs(far.value_or(0)) > 1 || std::abs(outer.value_or(0)) > 2;
  return isSimple && !isPart && (near ? near : far) == own ? own : std::nullopt;
}

CriticalType typeOf(const RefinedPoint& point)
{
  const std::optional<int> index = clearIndex(point);
  if (index ? *index < 0 : point.curvature[0] * point.curvature[1] < 0.0)
  {
    return CriticalType::Saddle;
  }
  return point.curvature.sum() > 0.0 ? CriticalType::Minimum : CriticalType::Maximum;
}

bool Trust::isSure(const RefinedPoint& point) const
{
  if (clearIndex(point))
  {
    return this->isLikely(point);
  }
  return point.isSettled && this->strength(point) >= (this->isNoisy_ ? TrustedInNoise : Trusted) &&
    point.curvature.cwiseAbs().minCoeff() >= point.bend;
}

bool Trust::isLikely(const RefinedPoint& point) const
{
  const std::optional<int> index = clearIndex(point);
  const bool isUnanimous = index &&
    std::all_of(point.enclosed.begin(), point.enclosed.end(),
      [&](const std::optional<int>& enclosed) { return enclosed == index; });
  const double least = isUnanimous ? 0.0
    : this->isNoisy_ || index      ? SignificantInNoise
                                   : Significant;
  return point.isSettled && this->isSeen(point) && this->strength(point) >= least;
}

bool Trust::isCurved(const RefinedPoint& point) const
{
  return point.isSettled && this->isSeen(point) &&
    point.significance[1] >= (this->isNoisy_ ? TrustedInNoise : Trusted);
}

bool Trust::isSeen(const RefinedPoint& point) const
{
  return this->isFew_ || point.votes >= FewestVotes;
}

/// Of the weaker eigenvalue. The misfit to a curved ridge looks like a curvature along it.
double Trust::strength(const RefinedPoint& point) const
{
  const Vector2d sizes = point.curvature.cwiseAbs();
  const double ratio = sizes.minCoeff() / sizes.maxCoeff();
  return point.significance[0] * (this->isNoisy_ ? 1.0 : std::min(1.0, ratio / RidgeRatio));
}

SurePoints::SurePoints(const std::vector<RefinedPoint>& points, const Trust& trust)
  : places_(placesOf(points, trust))
  , tree_(this->places_)
{
}

bool SurePoints::isAnyWithin(const Vector3d& place, double radius) const
{
  Neighborhood near;
  this->tree_.within(place, radius, near);
  return !near.indices.empty();
}

} // namespace SurfaceScalars
