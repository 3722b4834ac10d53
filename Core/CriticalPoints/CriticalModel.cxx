#include "CriticalModel.h"

#include "SampleSupport.h"
#include "SurfaceRestriction.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <vector>

namespace SurfaceScalars
{
namespace
{

constexpr int NewtonIterations = 30;
constexpr double NewtonTolerance = 1e-9; // of a step, in radii: its square is left
constexpr double LargestStep = 0.5;      // in radii
constexpr double LargestFirstStep = 1.5; // farther off, the critical point is not this fit's
constexpr double PlateauShare = 0.33;    // of the samples around
constexpr double Flat = 1e-13;           // changes of f, in its range: rounding

} // namespace

CriticalModel::CriticalModel(const CriticalScale& scale)
  : scale_(scale)
  , polynomials_(*scale.cloud, scale.values, scale.size, scale.degree)
  , field_(scale.field.make ? scale.field.make() : nullptr)
{
}

bool CriticalModel::center(const Vector3d& place)
{
  this->covarianceKnown_ = Known::No;
  this->finerKnown_ = Known::No;
  return this->polynomials_.center(place) && this->moveField(Vector2d::Zero());
}

bool CriticalModel::moveField(const Vector2d& uv)
{
  return !this->field_ || this->field_->center(this->fit().lift(uv) + this->scale_.origin);
}

LocalFit::Jet CriticalModel::jet(const Vector2d& uv) const
{
  const LocalFit& fit = this->fit();
  if (!this->field_)
  {
    return fit.value(uv);
  }
  const FieldJet inSpace =
    this->field_->jet(fit.lift(uv) + this->scale_.origin, Derivatives::Hessian);
  LocalFit::Jet result = restrictedTo(fit, uv, inSpace);
  if (!this->scale_.field.hasHessian)
  {
    result.hessian = fit.value(uv).hessian;
  }
  return result;
}

double CriticalModel::normalCosine(const Vector2d& uv) const
{
  const Vector3d gradient =
    this->field_->jet(this->fit().lift(uv) + this->scale_.origin, Derivatives::Gradient).gradient;
  const double length = gradient.norm();
  return length > 0.0 ? std::abs(gradient.dot(this->fit().normal(uv))) / length : 1.0;
}

const FitCovariance* CriticalModel::covariance()
{
  if (this->covarianceKnown_ == Known::No)
  {
    const bool found = this->covariance_.compute(this->fit(), this->polynomials_.weightedSamples());
    this->covarianceKnown_ = found ? Known::Yes : Known::Never;
  }
  return this->covarianceKnown_ == Known::Yes ? &this->covariance_ : nullptr;
}

Eigen::Matrix2d CriticalModel::gradientError(const Vector2d& uv)
{
  if (!this->covariance())
  {
    return Eigen::Matrix2d::Zero();
  }
  Eigen::Matrix2d error = this->covariance_.ofGradient(uv);
  if (this->finerKnown_ == Known::No)
  {
    const LocalFit& fit = this->fit();
    const WeightedSamples& samples = this->polynomials_.weightedSamples();
    const bool found = fit.degree() < LocalFit::MaximumDegree &&
      this->finerFit_.compute(fit.center(), samples, fit.scale(), fit.degree() + 1) &&
      this->finerCovariance_.compute(this->finerFit_, samples);
    this->finerKnown_ = found ? Known::Yes : Known::Never;
  }
  if (this->finerKnown_ == Known::Never)
  {
    return error;
  }
  const Vector2d bias =
    this->finerFit_.valueSlope(uv).gradient - this->fit().valueSlope(uv).gradient;
  const double noise = std::max(0.0, this->finerCovariance_.ofGradient(uv).trace() - error.trace());
  const double share = 1.0 - noise / bias.squaredNorm();
  if (share > 0.0)
  {
    error += share * bias * bias.transpose();
  }
  return error;
}

double CriticalModel::samplingStep() const
{
  return this->radius() * std::sqrt(Pi / this->scale_.fitCount());
}

bool CriticalModel::isSupported(double margin) const
{
  const SampleSupport support = measureSupport(this->scale_.cloud->points(), this->samples(),
    this->fit().lift(Vector2d::Zero()), this->fit().normal(Vector2d::Zero()));
  // Random samples leave a disc of radius r (in steps) empty with probability exp(-pi r^2) at a
  // place; this radius makes an empty disc unlikely among all the places there are.
  const double largestVoid = std::sqrt(std::log(1e5 * this->scale_.cloud->pointCount()) / Pi);
  return support.nearest <= largestVoid * this->samplingStep() && support.beyond <= -margin;
}

bool CriticalModel::isOnPlateau() const
{
  std::vector<double> values;
  for (const Index sample : this->samples())
  {
    values.push_back(this->scale_.values[sample]);
  }
  std::sort(values.begin(), values.end());
  const auto share = static_cast<std::size_t>(PlateauShare * static_cast<double>(values.size()));
  for (std::size_t i = 0; i + share < values.size(); ++i)
  {
    if (values[i] == values[i + share])
    {
      return true;
    }
  }
  return false;
}

std::optional<Vector2d> CriticalModel::criticalPoint(double within) const
{
  const double radius = this->radius();
  Vector2d uv = Vector2d::Zero();
  for (int i = 0; i < NewtonIterations; ++i)
  {
    const LocalFit::Jet f = this->jet(uv);
    const double determinant = f.hessian.determinant();
    if (!(f.hessian.norm() * radius * radius > Flat))
    {
      return {};
    }
    Eigen::Matrix2d adjugate;
    adjugate << f.hessian(1, 1), -f.hessian(0, 1), -f.hessian(1, 0), f.hessian(0, 0);
    Vector2d step = -(adjugate * f.gradient) / determinant;
    const double length = step.norm() / radius;
    if (!(length <= LargestFirstStep)) // or not a number
    {
      return {};
    }
    uv += length > LargestStep ? Vector2d(step * (LargestStep / length)) : step;
    if (!(uv.norm() <= radius))
    {
      return {};
    }
    if (length <= NewtonTolerance || !this->scale_.field.hasHessian)
    {
      break; // an average is f~ at the center only
    }
  }
  return uv.norm() <= within * radius ? std::optional<Vector2d>(uv) : std::nullopt;
}

} // namespace SurfaceScalars
