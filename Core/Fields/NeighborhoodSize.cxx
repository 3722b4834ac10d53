#include "NeighborhoodSize.h"

#include "LocalFit.h"
#include "Quantile.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace SurfaceScalars
{
namespace
{

constexpr std::size_t Sites = 128;
constexpr int LargestCount = 512;
constexpr double NegligibleMisfit = 1e-3; // in sampling steps: nobody sees it
constexpr double WidthToNoise = 3.0;      // of an admissible neighborhood
constexpr double VarianceShare =
  8.0; // of the noise's variance in that of the fit's center is this / k, for degree 2
constexpr double BiasShare =
  0.1; // of the misfit in the bias at the center, squared: odd terms cancel there

/// What fits of one size leave over, medians over the sites. Lengths.
struct Misfit
{
  int count;
  double squaredDeviation; ///< of surface and level set
  double squaredHeightDeviation;
  double squaredWidth; ///< of the neighborhood
};

/// Fits at the samples themselves; the weights are those of the polynomial model.
bool fitAt(const PointCloud& cloud, const Values& values, Index point, int count, int degree,
  LocalFit& fit, WeightedSamples& samples, double& width)
{
  Neighborhood near;
  const Vector3d center = cloud.points().col(point);
  cloud.nearest(center, count, near);
  const auto found = static_cast<Eigen::Index>(near.indices.size());
  samples.points.resize(3, found);
  samples.values = Values::Zero(found);
  samples.weights.resize(found);
  const double squaredWidth = near.squaredDistances.back();
  for (Eigen::Index i = 0; i < found; ++i)
  {
    const auto k = static_cast<std::size_t>(i);
    const double w = 1.0 - near.squaredDistances[k] / squaredWidth;
    samples.points.col(i) = cloud.points().col(near.indices[k]);
    samples.weights[i] = w * w;
    if (values.size() > 0)
    {
      samples.values[i] = values[near.indices[k]];
    }
  }
  width = std::sqrt(squaredWidth);
  return fit.compute(center, samples, width, degree);
}

Misfit measure(
  const PointCloud& cloud, const Values& values, int count, int degree, const Execution& execution)
{
  const std::size_t points = cloud.pointCount();
  const std::size_t sites = std::min(Sites, points);
  std::vector<double> heights(sites), deviations(sites), gradients(sites), widths(sites);
  parallelFor(sites, 8, { execution.threadCount, {} },
    [&](std::size_t begin, std::size_t end)
    {
      LocalFit fit;
      WeightedSamples samples;
      for (std::size_t i = begin; i < end; ++i)
      {
        const bool fitted = fitAt(cloud, values, static_cast<Index>(siteOf(i, sites, points)),
          count, degree, fit, samples, widths[i]);
        heights[i] = fitted ? fit.heightDeviation(samples) : 0.0;
        deviations[i] = fitted ? fit.valueDeviation(samples) : 0.0;
        gradients[i] = fitted ? fit.gradient(Vector2d::Zero()).norm() : 0.0;
      }
    });
  const double height = quantile(heights, 0.5);
  const double width = quantile(widths, 0.5);
  const double gradient = quantile(gradients, 0.5);
  const double value = gradient > 0.0 ? quantile(deviations, 0.5) / gradient : 0.0;
  // A function that is mostly flat has no position to be wrong about.
  const double along = std::min(value, width);
  return { count, height * height + along * along, height * height, width * width };
}

/// The median over the sites, with the neighbors that a graph has.
double typicalSamplingStep(const PointCloud& cloud)
{
  constexpr int Neighbors = 16;
  const std::size_t points = cloud.pointCount();
  const int count = std::clamp(static_cast<int>(points) - 1, 1, Neighbors);
  const std::size_t sites = std::min(Sites, points);
  std::vector<double> steps(sites);
  Neighborhood near;
  for (std::size_t i = 0; i < sites; ++i)
  {
    cloud.nearest(
      cloud.points().col(static_cast<Eigen::Index>(siteOf(i, sites, points))), count + 1, near);
    steps[i] = std::sqrt(near.squaredDistances.back() * Pi / count);
  }
  return quantile(steps, 0.5);
}

} // namespace

int chooseNeighborCount(
  const PointCloud& cloud, const Values& values, int degree, const Execution& execution)
{
  const int usual = UsualNeighborCount * LocalFit::termCount(degree) / LocalFit::termCount(2);
  const int points = static_cast<int>(cloud.pointCount());
  std::vector<Misfit> misfits;
  double noise = INFINITY;
  const double negligible = std::pow(NegligibleMisfit * typicalSamplingStep(cloud), 2);
  for (int count = usual; count <= LargestCount && count <= points / 4; count += count / 2)
  {
    execution.report(static_cast<double>(count) / LargestCount);
    const Misfit misfit = measure(cloud, values, count, degree, execution);
    if (misfit.squaredWidth < WidthToNoise * WidthToNoise * misfit.squaredHeightDeviation)
    {
      continue;
    }
    noise = std::min(noise, misfit.squaredDeviation);
    misfits.push_back(misfit);
    if (misfits.front().squaredDeviation < negligible)
    {
      return misfits.front().count;
    }
    if (misfit.squaredDeviation > 4.0 * noise)
    {
      break; // bias has taken over
    }
  }
  const auto error = [&](const Misfit& misfit)
  { return noise * VarianceShare / misfit.count + BiasShare * (misfit.squaredDeviation - noise); };
  const auto best = std::min_element(misfits.begin(), misfits.end(),
    [&](const Misfit& a, const Misfit& b) { return error(a) < error(b); });
  return std::min(best == misfits.end() ? usual : best->count, points);
}

} // namespace SurfaceScalars
