#include "SampleSupport.h"

#include "Quantile.h"

#include <algorithm>
#include <cmath>

namespace SurfaceScalars
{
namespace
{

constexpr double OutlierFraction = 0.02;

} // namespace

SampleSupport measureSupport(const Points& points, const std::vector<Index>& samples,
  const Vector3d& place, const Vector3d& normal)
{
  Vector3d mean = Vector3d::Zero();
  double nearest = INFINITY;
  for (const Index i : samples)
  {
    const Vector3d offset = points.col(i) - place;
    mean += offset;
    nearest = std::min(nearest, offset.squaredNorm());
  }
  const Vector3d inwards = (mean - normal * normal.dot(mean)).normalized();
  std::vector<double> across;
  across.reserve(samples.size());
  for (const Index i : samples)
  {
    across.push_back(inwards.dot(points.col(i) - place));
  }
  return { std::sqrt(nearest), quantile(across, OutlierFraction) };
}

} // namespace SurfaceScalars
