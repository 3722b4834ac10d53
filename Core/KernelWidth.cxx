#include "KernelWidth.h"

#include "GlobalSystem.h"
#include "Quantile.h"
#include "RadialBasisFit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace SurfaceScalars
{
namespace
{

constexpr std::size_t MostAsked = 500;       // samples: each width costs their number cubed
constexpr std::size_t FewestAsked = 6;       // fewer do not tell widths apart
constexpr int SpacingNeighbors = 9;          // itself counted
constexpr int MostNeighbors = 80;            // within a compact support
constexpr double GridFactor = 1.5;           // from one width to the next
constexpr int Refinements = 8;               // of the best of these
constexpr double SmallestReciprocal = 1e-12; // of the condition

/// Every so many samples along the curve on which they lie.
struct Subset
{
  Points points;
  Values values;
};

Subset spreadSubset(const FieldSamples& samples)
{
  const std::size_t count = samples.cloud.pointCount();
  const auto asked = static_cast<Eigen::Index>(std::min(count, MostAsked));
  Subset result{ Points(3, asked), Values(asked) };
  for (Eigen::Index i = 0; i < asked; ++i)
  {
    const auto from = static_cast<Eigen::Index>(
      static_cast<std::size_t>(i) * count / static_cast<std::size_t>(asked));
    result.points.col(i) = samples.cloud.points().col(from);
    result.values[i] = samples.values[from];
  }
  return result;
}

/// The median distance to the neighbor of this rank.
double neighborDistance(const PointCloud& cloud, int rank)
{
  Neighborhood found;
  return medianOfSome(cloud.pointCount(),
    [&](std::size_t point)
    {
      cloud.nearest(cloud.points().col(static_cast<Eigen::Index>(point)), rank, found);
      return std::sqrt(found.squaredDistances.back());
    });
}

double radiusOf(const PointCloud& cloud)
{
  return std::sqrt(cloud.points().colwise().squaredNorm().maxCoeff());
}

/// The error of leaving one out, infinite where the system is badly conditioned.
double missOf(const Subset& subset, const RadialKernel& kernel, double regularization)
{
  RadialBasisFit fit;
  if (!fit.factor(subset.points, kernel, regularization) ||
    fit.reciprocalCondition() < SmallestReciprocal)
  {
    return std::numeric_limits<double>::infinity();
  }
  fit.solve(subset.values);
  const double miss = fit.leaveOneOutErrors().norm();
  return std::isfinite(miss) ? miss : std::numeric_limits<double>::infinity();
}

/// Where a function is least, from `begin` to `end`, by golden sections.
template <class Function>
double minimum(double begin, double end, const Function& function)
{
  const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
  double left = end - golden * (end - begin);
  double right = begin + golden * (end - begin);
  double atLeft = function(left);
  double atRight = function(right);
  for (int i = 2; i < Refinements; ++i)
  {
    if (atLeft <= atRight)
    {
      end = right;
      right = left;
      atRight = atLeft;
      left = end - golden * (end - begin);
      atLeft = function(left);
    }
    else
    {
      begin = left;
      left = right;
      atLeft = atRight;
      right = begin + golden * (end - begin);
      atRight = function(right);
    }
  }
  return atLeft <= atRight ? left : right;
}

} // namespace

double chooseKernelWidth(
  const FieldSamples& samples, KernelType kernel, double regularization, const Execution& execution)
{
  const PointCloud& cloud = samples.cloud;
  const double radius = radiusOf(cloud);
  if (cloud.pointCount() < FewestAsked || !RadialKernel(kernel, 1.0).dependsOnWidth())
  {
    return radius > 0.0 ? radius : 1.0;
  }
  const Subset subset = spreadSubset(samples);
  const double spacing = neighborDistance(cloud, SpacingNeighbors);
  const double subsetSpacing =
    neighborDistance(PointCloud(subset.points, execution.part(0.0, 0.0)), SpacingNeighbors);
  const bool isSparse =
    std::isfinite(RadialKernel(kernel, 1.0).support()) && cloud.pointCount() > MostDenseCenters;
  // All widths below are in units of the spacing.
  const double widest =
    (isSparse ? neighborDistance(cloud, MostNeighbors) : 4.0 * radius) / spacing;
  const auto miss = [&](double width) {
    return missOf(subset, { kernel, width * subsetSpacing }, regularization);
  };

  std::vector<double> widths{ 0.5 };
  while (widths.back() * GridFactor < widest)
  {
    widths.push_back(widths.back() * GridFactor);
  }
  widths.push_back(widest);
  std::vector<double> misses(widths.size());
  parallelForEach(widths.size(), execution.part(0.0, 0.6),
    [&](std::size_t i, const Poll&) { misses[i] = miss(widths[i]); });
  const auto best =
    static_cast<std::size_t>(std::min_element(misses.begin(), misses.end()) - misses.begin());
  const double begin = widths[best > 0 ? best - 1 : best];
  const double end = widths[std::min(best + 1, widths.size() - 1)];
  double least = misses[best];
  double width = widths[best];
  minimum(std::log(begin), std::log(end),
    [&](double logarithm)
    {
      execution.report(0.6);
      const double here = miss(std::exp(logarithm));
      if (here < least)
      {
        least = here;
        width = std::exp(logarithm);
      }
      return here;
    });
  execution.report(1.0);
  return width * spacing;
}

} // namespace SurfaceScalars
