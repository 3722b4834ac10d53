#include "Error.h"
#include "FieldChecks.h"
#include "FieldSchemes.h"
#include "RadialBasisFit.h"
#include "RadialRefusal.h"

#include <algorithm>
#include <cmath>

namespace SurfaceScalars
{
namespace
{

constexpr double LargestResidual = 1e-5;  // relative to the range of values: beyond, f~ is noise
constexpr double ChosenResidual = 1e-10;  // with a width that was chosen here
constexpr double ChosenCondition = 1e-10; // its reciprocal, likewise
constexpr double WidthReduction = 0.5;    // of a chosen width that proves too large
constexpr int MostReductions = 3;

/// h where it is chosen, in radii of the neighborhood: wider is more accurate and closer to
/// singular, and overshoots between irregular samples whose values jump. Measured on random samples
/// of a surface and on random stations in a plane, where all kernels come near to Cubic; powers and
/// thin plates depend on it only through the unit of the regularization.
double widthInRadii(KernelType kernel)
{
  switch (kernel)
  {
    case KernelType::Gaussian:
      return 0.25;
    case KernelType::Exponential:
      return 2.0;
    case KernelType::Multiquadric:
      return 0.2;
    case KernelType::InverseMultiquadric:
      return 0.3;
    case KernelType::Wendland:
    case KernelType::Wu:
      return 5.0;
    default:
      return 1.0;
  }
}

class LocalRBF : public FieldApproximation
{
public:
  LocalRBF(const FieldSamples& samples, const FieldParameters& parameters)
    : samples_(samples)
    , parameters_(parameters)
    , search_(neighborhoodSearch(samples.cloud, parameters))
  {
  }

  Eigen::Index expect(const PointsRef& places) override { return this->search_.expect(places); }
  bool center(const Vector3d& place) override;
  FieldJet jet(const Vector3d& place, Derivatives derivatives) const override
  {
    return this->fit_.jet(place, derivatives);
  }

private:
  void fit(const std::vector<Index>& neighbors);
  bool fitChosen(double width);
  void fitOrRefuse(double width);
  double residual(double enough) const;

  FieldSamples samples_;
  FieldParameters parameters_;
  NearestSearch search_;
  std::vector<Index> found_;     // in the order of the cloud
  std::vector<Index> neighbors_; // that the fit is made of
  Points centers_;
  Values values_;
  RadialBasisFit fit_;
};

bool LocalRBF::center(const Vector3d& place)
{
  this->found_.clear();
  for (const NearestSearch::Found& found : this->search_.find(place))
  {
    this->found_.push_back(found.index);
  }
  std::sort(this->found_.begin(), this->found_.end());
  if (this->found_.empty() || this->found_ == this->neighbors_)
  {
    return !this->found_.empty(); // one fit serves all places that have the same neighbors
  }
  checkNeighborhood(this->found_.size());
  this->neighbors_.clear(); // until the new fit is there
  this->fit(this->found_);
  this->neighbors_ = this->found_;
  return true;
}

void LocalRBF::fit(const std::vector<Index>& neighbors)
{
  const auto count = static_cast<Eigen::Index>(neighbors.size());
  this->centers_.resize(3, count);
  this->values_.resize(count);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    const Index sample = neighbors[static_cast<std::size_t>(i)];
    this->centers_.col(i) = this->samples_.cloud.points().col(sample);
    this->values_[i] = this->samples_.values[sample];
  }
  const Vector3d middle = this->centers_.rowwise().mean();
  const double radius =
    std::sqrt((this->centers_.colwise() - middle).colwise().squaredNorm().maxCoeff());
  if (this->parameters_.kernelWidth > 0.0)
  {
    this->fitOrRefuse(this->parameters_.kernelWidth);
    return;
  }
  double width = radius > 0.0 ? widthInRadii(this->parameters_.kernel) * radius : 1.0;
  if (RadialKernel(this->parameters_.kernel, width).dependsOnWidth())
  {
    for (int reduction = 0; reduction < MostReductions; ++reduction)
    {
      if (this->fitChosen(width))
      {
        return;
      }
      width *= WidthReduction;
    }
  }
  this->fitOrRefuse(width);
}

/// @returns whether the fit is far from singular
bool LocalRBF::fitChosen(double width)
{
  if (!this->fit_.factor(this->centers_, RadialKernel(this->parameters_.kernel, width),
        this->parameters_.regularization) ||
    this->fit_.reciprocalCondition() < ChosenCondition)
  {
    return false;
  }
  this->fit_.solve(this->values_);
  return this->residual(ChosenResidual) <= ChosenResidual;
}

void LocalRBF::fitOrRefuse(double width)
{
  const RadialKernel kernel(this->parameters_.kernel, width);
  const std::string neighbors = std::to_string(this->centers_.cols()) + " neighbors";
  if (!this->fit_.factor(this->centers_, kernel, this->parameters_.regularization))
  {
    refuseSystem(
      "a singular system of " + neighbors, kernel, 1.0 / this->fit_.reciprocalCondition());
  }
  this->fit_.solve(this->values_);
  const double residual = this->residual(LargestResidual);
  if (residual > LargestResidual)
  {
    refuseSystem("an interpolant of " + neighbors + " that misses them by " + textOf(residual) +
        " of the range of their values",
      kernel, 1.0 / this->fit_.reciprocalCondition());
  }
}

/// By how much f~ misses the neighbors, relative to the range of their values; 0 where it may,
/// or is certain to be less than enough.
double LocalRBF::residual(double enough) const
{
  const double range = this->values_.maxCoeff() - this->values_.minCoeff();
  const double rounding = 1e-14 * this->values_.lpNorm<Eigen::Infinity>();
  if (this->parameters_.regularization > 0.0 || this->fit_.residualBound() <= enough * range)
  {
    return 0.0;
  }
  const double residual = this->fit_.largestResidual();
  return residual <= rounding ? 0.0 : residual / range;
}

} // namespace

std::unique_ptr<FieldApproximation> makeLocalRBF(
  const FieldSamples& samples, const FieldParameters& parameters)
{
  return std::make_unique<LocalRBF>(samples, parameters);
}

} // namespace SurfaceScalars
