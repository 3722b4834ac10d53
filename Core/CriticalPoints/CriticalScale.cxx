#include "CriticalScale.h"

#include "FitCovariance.h"
#include "Quantile.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace SurfaceScalars
{
namespace
{

constexpr std::size_t Sites = 128;
constexpr double WantedError = 0.12; // of the Hessian, relative
constexpr double WidthToNoise = 3.0; // of a neighborhood
constexpr double NearlyLeast = 1.3;  // error of what serves as well as the best
constexpr double Hopeless = 0.5;
constexpr double FlatHessian = 1e-12;  // of f's range per neighborhood: rounding
constexpr int CountPerTerm = 4;        // neighbors where there is no noise
constexpr int FewestSteps = 5;         // neighborhoods that an input must be large enough for
constexpr int MostNeighbors = 400;     // of a fit; beyond, blocks are averaged
constexpr int AveragedNeighbors = 200; // of a fit to averages

/// Of one size of neighborhoods, medians over the sites.
struct Survey
{
  double relativeError; ///< of the Hessian
  double width;
  double heightNoise;

  bool isGood() const { return this->relativeError <= WantedError && this->isWide(); }
  bool isWide() const { return this->width >= WidthToNoise * this->heightNoise; }
};

Survey survey(const CriticalScale& scale, const Execution& execution)
{
  const std::size_t points = scale.cloud->pointCount();
  const std::size_t sites = std::min(Sites, points);
  std::vector<double> errors(sites), hessians(sites), widths(sites), heights(sites);
  parallelFor(sites, 8, { execution.threadCount, {} },
    [&](std::size_t begin, std::size_t end)
    {
      PolynomialNeighborhood near(*scale.cloud, scale.values, scale.size, scale.degree);
      FitCovariance covariance;
      for (std::size_t i = begin; i < end; ++i)
      {
        const auto site = static_cast<Eigen::Index>(siteOf(i, sites, points));
        if (!near.center(scale.cloud->points().col(site)) ||
          !covariance.compute(near.fit(), near.weightedSamples()))
        {
          continue;
        }
        const Vector3d twice(1.0, 2.0, 1.0); // the element off the diagonal counts twice
        const double squaredWidth = near.radius() * near.radius();
        errors[i] = squaredWidth * std::sqrt(covariance.ofHessianAtCenter().diagonal().dot(twice));
        hessians[i] = squaredWidth * near.fit().value(Vector2d::Zero()).hessian.norm();
        widths[i] = near.radius();
        heights[i] = near.fit().heightDeviation(near.weightedSamples());
      }
    });
  return { quantile(errors, 0.5) / (quantile(hessians, 0.5) + FlatHessian), quantile(widths, 0.5),
    quantile(heights, 0.5) };
}

void takeSamples(CriticalScale& scale, const NeighborGraph& graph, const Values& values)
{
  scale.cloud = &graph;
  scale.values = values;
  scale.origin.setZero();
  scale.blockSize = 1;
}

/// Replaces the cloud by the averages of blocks that follow each other in its order.
void averageBlocks(
  CriticalScale& scale, const NeighborGraph& graph, const Values& values, int blockSize)
{
  const auto samples = static_cast<Eigen::Index>(graph.pointCount());
  const Eigen::Index blocks = (samples + blockSize - 1) / blockSize;
  Points points(3, blocks);
  Values averages(blocks);
  for (Eigen::Index block = 0; block < blocks; ++block)
  {
    const Eigen::Index first = block * blockSize;
    const Eigen::Index count = std::min<Eigen::Index>(blockSize, samples - first);
    points.col(block) = graph.points().middleCols(first, count).rowwise().mean();
    averages[block] = values.segment(first, count).mean();
  }
  scale.averages = std::make_unique<PointCloud>(points);
  scale.cloud = scale.averages.get();
  scale.values = scale.averages->average(averages);
  scale.origin = scale.averages->origin();
  scale.blockSize = blockSize;
}

/// Neighborhoods of this many samples, fitted to averages if they are many.
Survey tryCount(CriticalScale& scale, const NeighborGraph& graph, const Values& values, int count,
  int degree, const Execution& execution)
{
  const double steps = scale.size.radius / graph.medianSamplingStep();
  const double within = std::min<double>(Pi * steps * steps, graph.pointCount());
  scale.neighborCount = std::max(count, static_cast<int>(within));
  const int blockSize =
    scale.neighborCount > MostNeighbors ? scale.neighborCount / AveragedNeighbors : 1;
  if (blockSize > 1)
  {
    averageBlocks(scale, graph, values, blockSize);
  }
  else if (scale.blockSize > 1)
  {
    takeSamples(scale, graph, values);
  }
  scale.size.count = std::max(count / blockSize, std::min(count, LocalFit::termCount(degree) + 1));
  scale.degree = degree;
  const Survey found = survey(scale, execution);
  scale.heightNoise = found.heightNoise * std::sqrt(static_cast<double>(scale.blockSize));
  return found;
}

/// Enough for a polynomial of this degree where there is no noise.
int usualCount(int degree)
{
  return CountPerTerm * LocalFit::termCount(degree);
}

/// Where no neighborhood is good, because what f bends by within large ones adds to the error, the
/// smallest of those with about the least.
void chooseCount(CriticalScale& scale, const NeighborGraph& graph, const Values& values, int degree,
  const Execution& execution)
{
  const int points = static_cast<int>(graph.pointCount());
  std::vector<int> counts;
  std::vector<double> errors;
  for (int count = usualCount(degree); errors.empty() || count * FewestSteps <= points;
       count += count / 2)
  {
    execution.report(static_cast<double>(count) / points);
    counts.push_back(std::min(count, points));
    const Survey found = tryCount(scale, graph, values, counts.back(), degree, execution);
    if (found.isGood())
    {
      return;
    }
    errors.push_back(found.isWide() ? found.relativeError : INFINITY);
  }
  const double least = *std::min_element(errors.begin(), errors.end());
  if (!(least <= Hopeless)) // then the last, the largest, sees least that is not there
  {
    return;
  }
  const auto nearly = std::find_if(
    errors.begin(), errors.end(), [=](double error) { return error <= NearlyLeast * least; });
  tryCount(scale, graph, values, counts[static_cast<std::size_t>(nearly - errors.begin())], degree,
    execution);
}

} // namespace

CriticalScale chooseCriticalScale(const NeighborGraph& graph, const Values& values,
  const CriticalPointParameters& parameters, const Execution& execution)
{
  const int points = static_cast<int>(graph.pointCount());
  const int degree = std::max(parameters.polynomialDegree, 2); // what has a Hessian
  const int finer = std::min(degree + 1, LocalFit::MaximumDegree);
  CriticalScale scale;
  takeSamples(scale, graph, values);
  // Large neighborhoods hide noise: what is asked for does not tell whether there is any.
  const bool isFine = usualCount(finer) * FewestSteps <= points &&
    tryCount(scale, graph, values, usualCount(finer), finer, execution).isGood();
  scale.isNoisy = !isFine;
  if (parameters.neighborCount > 0 || parameters.searchRadius > 0.0)
  {
    scale.size.radius = parameters.searchRadius;
    const int given = parameters.neighborCount > 0 ? std::min(parameters.neighborCount, points)
                                                   : LocalFit::termCount(degree) + 1;
    tryCount(scale, graph, values, given, degree, execution);
    if (isFine && usualCount(finer) <= scale.neighborCount)
    {
      tryCount(scale, graph, values, given, finer, execution);
    }
  }
  else if (!isFine)
  {
    chooseCount(scale, graph, values, degree, execution);
  }
  return scale;
}

} // namespace SurfaceScalars
