#include "GlobalSystem.h"

#include "Error.h"
#include "FieldChecks.h"
#include "KernelWidth.h"
#include "NumberText.h"
#include "RadialRefusal.h"
#include "RadialSum.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace SurfaceScalars
{
namespace
{

constexpr double MostEntries = 2e8;      // of a sparse matrix: 2.4 GB
constexpr double SparseFraction = 0.05;  // of a matrix up to which it counts as sparse
constexpr Index MostAlwaysDense = 1000;  // a dense system of these takes no time
constexpr double LargestResidual = 1e-5; // relative to f's range: beyond, f~ is noise
constexpr double WidthReduction = 0.8;   // of a chosen width that proves too large
constexpr int MostReductions = 10;

class GlobalApproximation : public FieldApproximation
{
public:
  GlobalApproximation(
    const FieldSamples& terms, const RadialKernel& kernel, const Eigen::Vector4d& tail)
    : terms_(terms)
    , kernel_(kernel)
    , tail_(tail)
  {
  }

  bool center(const Vector3d&) override { return true; }
  FieldJet jet(const Vector3d& place, Derivatives derivatives) const override;

private:
  FieldSamples terms_;
  RadialKernel kernel_;
  Eigen::Vector4d tail_;
  mutable Neighborhood found_;
};

FieldJet GlobalApproximation::jet(const Vector3d& place, Derivatives derivatives) const
{
  FieldJet result = linearJet(this->tail_, place);
  const Points& centers = this->terms_.cloud.points(); // once, not for each term
  const auto add = [&](Index center)
  {
    addRadialTerm(
      result, this->terms_.values[center], this->kernel_, place - centers.col(center), derivatives);
  };
  if (std::isfinite(this->kernel_.support()))
  {
    this->terms_.cloud.within(place, this->kernel_.support(), this->found_);
    std::for_each(this->found_.indices.begin(), this->found_.indices.end(), add);
    return result;
  }
  const auto count = static_cast<Index>(centers.cols());
  for (Index center = 0; center < count; ++center)
  {
    add(center);
  }
  return result;
}

double widthOf(
  const FieldSamples& samples, const FieldParameters& parameters, const Execution& execution)
{
  return parameters.kernelWidth > 0.0
    ? parameters.kernelWidth
    : chooseKernelWidth(samples, parameters.kernel, parameters.regularization, execution);
}

void checkCount(const PointCloud& cloud, KernelType kernel)
{
  if (!std::isfinite(RadialKernel(kernel, 1.0).support()) && cloud.pointCount() > MostDenseCenters)
  {
    throw InvalidInput("at most " + std::to_string(MostDenseCenters) +
        " different points for the GlobalRBF scheme with the " + nameOf(kernel) + " kernel",
      std::to_string(cloud.pointCount()),
      "Choose the Wendland or Wu Kernel or the LocalRBF scheme, or thin the samples.");
  }
}

/// The cloud, after it has been found small enough.
const PointCloud& checked(const FieldSamples& samples, const FieldParameters& parameters)
{
  checkCount(samples.cloud, parameters.kernel);
  return samples.cloud;
}

} // namespace

std::unique_ptr<FieldApproximation> makeGlobalRBF(
  const FieldSamples& terms, const RadialKernel& kernel, const Eigen::Vector4d& tail)
{
  return std::make_unique<GlobalApproximation>(terms, kernel, tail);
}

GlobalSystem::GlobalSystem(
  const FieldSamples& samples, const FieldParameters& parameters, const Execution& execution)
  : cloud_(checked(samples, parameters))
  , kernel_(parameters.kernel, widthOf(samples, parameters, execution.part(0.0, 0.2)))
  , regularization_(parameters.regularization)
{
  if (this->isSparse(execution.part(0.2, 0.25)))
  {
    this->sparse_ = std::make_unique<CompactSystem>(
      this->cloud_, this->kernel_, this->regularization_, execution.part(0.25, 1.0));
    return;
  }
  this->dense_ = std::make_unique<RadialBasisFit>();
  const bool isReducible = !(parameters.kernelWidth > 0.0) && this->kernel_.dependsOnWidth();
  const int most = isReducible ? MostReductions : 0;
  for (int reduction = 0;; ++reduction)
  {
    // Not the whole of what is left, as it may not be the last time.
    const double done = 1.0 - 0.75 * std::pow(0.5, reduction);
    if (this->dense_->factor(this->cloud_.points(), this->kernel_, this->regularization_,
          execution.part(done, 0.5 * (1.0 + done))))
    {
      return;
    }
    if (reduction >= most)
    {
      this->refuse("a system that is singular at machine precision");
    }
    this->kernel_ = { this->kernel_.type(), WidthReduction * this->kernel_.width() };
  }
}

bool GlobalSystem::isSparse(const Execution& execution) const
{
  if (!std::isfinite(this->kernel_.support()) || this->cloud_.pointCount() <= MostAlwaysDense)
  {
    return false;
  }
  const double count = this->cloud_.pointCount();
  const double mean = meanNeighborCount(this->cloud_, this->kernel_.support(), execution);
  if (this->cloud_.pointCount() <= MostDenseCenters)
  {
    return mean < SparseFraction * count;
  }
  if (mean * count > MostEntries)
  {
    throw InvalidInput("at most " + textOf(std::floor(MostEntries / count)) +
        " points within the width of the " + nameOf(this->kernel_.type()) +
        " kernel around each, on average",
      textOf(std::round(mean)) + " within " + textOf(this->kernel_.width()),
      "Lower KernelWidth or thin the samples.");
  }
  return true;
}

void GlobalSystem::refuse(const std::string& found) const
{
  refuseSystem(found, this->kernel_, 1.0 / this->dense_->reciprocalCondition());
}

GlobalSum GlobalSystem::solve(const Values& values, const Execution& execution) const
{
  GlobalSum result{ this->kernel_, {}, {} };
  Vector3d origin;
  if (this->sparse_)
  {
    CompactSystem::Solution solution = this->sparse_->solve(values, execution);
    result.coefficients = std::move(solution.coefficients);
    result.tail = solution.tail;
    origin = this->sparse_->tailOrigin();
  }
  else
  {
    const std::lock_guard<std::mutex> lock(this->mutex_);
    this->dense_->solve(values);
    result.coefficients = this->dense_->coefficients();
    result.tail = this->dense_->tail();
    origin = this->dense_->tailOrigin();
  }
  result.tail[0] -= result.tail.tail<3>().dot(origin);
  if (this->dense_ && this->regularization_ == 0.0)
  {
    this->checkResidual(result, values, execution);
  }
  return result;
}

Values GlobalSystem::leaveOneOutErrors(const Values& values, const Execution& execution) const
{
  if (!this->dense_)
  {
    throw InvalidInput("a dense system for leave-one-out errors",
      "the sparse one of the " + textOf(this->kernel_),
      this->cloud_.pointCount() <= MostDenseCenters
        ? "Raise KernelWidth, or choose a Kernel without compact support."
        : "Thin the samples to at most " + std::to_string(MostDenseCenters) +
          ", and choose a Kernel without compact support.");
  }
  const std::lock_guard<std::mutex> lock(this->mutex_);
  this->dense_->solve(values);
  return this->dense_->leaveOneOutErrors(execution);
}

void GlobalSystem::checkResidual(
  const GlobalSum& sum, const Values& values, const Execution& execution) const
{
  Values residual(values.size());
  parallelFor(static_cast<std::size_t>(values.size()), 32, execution,
    [&](std::size_t begin, std::size_t end)
    {
      const auto approximation =
        makeGlobalRBF({ this->cloud_, sum.coefficients }, sum.kernel, sum.tail);
      for (auto i = static_cast<Eigen::Index>(begin); i < static_cast<Eigen::Index>(end); ++i)
      {
        residual[i] =
          approximation->jet(this->cloud_.points().col(i), Derivatives::None).value - values[i];
      }
    });
  const double range = values.maxCoeff() - values.minCoeff();
  const double miss = residual.lpNorm<Eigen::Infinity>();
  if (!(miss <= LargestResidual * range + 1e-14 * values.lpNorm<Eigen::Infinity>()))
  {
    constexpr double smallest = std::numeric_limits<double>::min();
    if (range < smallest)
    {
      throw InvalidInput("values that differ by " + textOf(smallest) +
          " at least, as smaller numbers have few digits",
        textOf(range), "Multiply them by a power of ten.");
    }
    this->refuse(
      "an interpolant that misses its samples by " + textOf(miss / range) + " of f's range");
  }
}

} // namespace SurfaceScalars
