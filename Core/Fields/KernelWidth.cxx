#include "KernelWidth.h"

#include "Error.h"
#include "GlobalSystem.h"
#include "NumberText.h"
#include "Quantile.h"
#include "RadialBasisFit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
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
constexpr double NarrowValue = 0.06;         // of a term at half the spacing, of that at its center

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

double smallestDistance(const PointCloud& cloud)
{
  Neighborhood found;
  double smallest = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < cloud.points().cols(); ++i)
  {
    cloud.nearest(cloud.points().col(i), 2, found);
    smallest = std::min(smallest, found.squaredDistances.back());
  }
  return std::sqrt(smallest);
}

/// A width and the error of leaving one out, root mean square: infinite where the system is badly
/// conditioned.
struct Trial
{
  double width;
  double miss;
};

double missOf(const Subset& subset, const RadialKernel& kernel, double regularization)
{
  RadialBasisFit fit;
  if (!fit.factor(subset.points, kernel, regularization) ||
    fit.reciprocalCondition() < SmallestReciprocal)
  {
    return std::numeric_limits<double>::infinity();
  }
  fit.solve(subset.values);
  const double miss =
    fit.leaveOneOutErrors().norm() / std::sqrt(static_cast<double>(subset.values.size()));
  return std::isfinite(miss) ? miss : std::numeric_limits<double>::infinity();
}

/// The width from `begin` to `end` that misses least, by golden sections of their logarithms.
template <class Function>
Trial refine(double begin, double end, const Function& missOfWidth)
{
  const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
  const auto between = [&](double share)
  {
    const double width = begin * std::pow(end / begin, share);
    return Trial{ width, missOfWidth(width) };
  };
  Trial left = between(1.0 - golden);
  Trial right = between(golden);
  for (int i = 2; i < Refinements; ++i)
  {
    if (left.miss <= right.miss)
    {
      end = right.width;
      right = left;
      left = between(1.0 - golden);
    }
    else
    {
      begin = left.width;
      left = right;
      right = between(golden);
    }
  }
  return left.miss <= right.miss ? left : right;
}

/// Where all miss by rounding errors alone, as where f is constant or linear, these say nothing.
double roundingOf(const Values& values)
{
  return 1e-12 * (values.maxCoeff() - values.minCoeff()) + 1e-14 * values.lpNorm<Eigen::Infinity>();
}

[[noreturn]] void refuseAll(const PointCloud& cloud, KernelType kernel, double spacing)
{
  throw InvalidInput("samples for which some KernelWidth makes the system of the " +
      std::string(nameOf(kernel)) + " kernel well conditioned",
    "some " + textOf(smallestDistance(cloud)) + " apart where " + textOf(spacing) + " is typical",
    "Raise Regularization to 1e-10 or so, or leave out points that nearly coincide.");
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
  const PointCloud subsetCloud(subset.points, execution.part(0.0, 0.0));
  const double subsetSpacing = neighborDistance(subsetCloud, SpacingNeighbors);
  const bool isSparse =
    std::isfinite(RadialKernel(kernel, 1.0).support()) && cloud.pointCount() > MostDenseCenters;
  // All widths below are in units of the spacing.
  const double widest =
    (isSparse ? neighborDistance(cloud, MostNeighbors) : 4.0 * radius) / spacing;
  const auto miss = [&](double width) {
    return missOf(subset, { kernel, width * subsetSpacing }, regularization);
  };

  std::vector<Trial> trials{ { 0.5, 0.0 } };
  while (trials.back().width * GridFactor < widest)
  {
    trials.push_back({ trials.back().width * GridFactor, 0.0 });
  }
  trials.push_back({ widest, 0.0 });
  parallelForEach(trials.size(), execution.part(0.0, 0.6),
    [&](std::size_t i, const Poll&) { trials[i].miss = miss(trials[i].width); });

  const auto exact = std::find_if(trials.rbegin(), trials.rend(),
    [rounding = roundingOf(subset.values)](const Trial& trial) { return trial.miss <= rounding; });
  if (exact != trials.rend())
  {
    return exact->width * spacing;
  }
  const auto best = std::min_element(
    trials.begin(), trials.end(), [](const Trial& a, const Trial& b) { return a.miss < b.miss; });
  if (std::isinf(best->miss))
  {
    refuseAll(subsetCloud, kernel, subsetSpacing);
  }
  const auto before = best == trials.begin() ? best : best - 1;
  const auto after = best + 1 == trials.end() ? best : best + 1;
  const Trial refined = refine(before->width, after->width,
    [&](double width)
    {
      execution.report(0.6);
      return miss(width);
    });
  execution.report(1.0);
  return (refined.miss < best->miss ? refined : *best).width * spacing;
}

std::string remarkOnWidth(const FieldParameters& asked, const PointCloud& centers)
{
  const bool hasKernel = asked.scheme == Scheme::LocalRBF || asked.scheme == Scheme::Hybrid ||
    asked.scheme == Scheme::GlobalRBF;
  if (!hasKernel || !(asked.kernelWidth > 0.0) || centers.pointCount() < SpacingNeighbors)
  {
    return {};
  }
  const RadialKernel kernel(asked.kernel, asked.kernelWidth);
  if (!kernel.dependsOnWidth())
  {
    return {};
  }
  const double spacing = neighborDistance(centers, SpacingNeighbors);
  if (kernel.value(0.5 * spacing) >= NarrowValue * kernel.value(0.0))
  {
    return {};
  }
  return "KernelWidth " + textOf(asked.kernelWidth) + " is too narrow for the " +
    nameOf(asked.kernel) + " kernel: half of the centers have their eighth neighbor farther than " +
    textOf(spacing) +
    " away, and between centers there may be little more than a linear function. "
    "Raise it to several times that distance, or set it to 0 to have it chosen.";
}

} // namespace SurfaceScalars
