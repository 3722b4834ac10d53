#include "GaussianAverage.h"

namespace SurfaceScalars
{

void GaussianAverage::weigh(const SampleRows& samples, const Vector3d& place, double width)
{
  this->offsets_ = samples.rowwise() - place.transpose();
  this->weights_ = this->offsets_.col(0).array().square() + this->offsets_.col(1).array().square() +
    this->offsets_.col(2).array().square();
  const double nearest = this->weights_.minCoeff();
  this->weights_ = ((nearest - this->weights_.array()) / (width * width)).exp();
  this->weightSum_ = this->weights_.sum();
  this->slope_ = 2.0 / (width * width);
}

Vector3d GaussianAverage::meanOffset() const
{
  return this->offsets_.transpose() * this->weights_ / this->weightSum_;
}

FieldJet GaussianAverage::jet(const Values& values, Derivatives derivatives) const
{
  FieldJet result;
  // Deviations from the first value: equal values keep their digits, and so do small differences.
  const double first = values[0];
  result.value = first + this->weights_.dot((values.array() - first).matrix()) / this->weightSum_;
  if (derivatives == Derivatives::None)
  {
    return result;
  }
  // (7) with the products multiplied out: the weighted deviations from the average, which add up to
  // zero.
  const Values deviations =
    (this->slope_ / this->weightSum_) * this->weights_.array() * (values.array() - result.value);
  result.gradient = this->offsets_.transpose() * deviations;
  if (derivatives == Derivatives::Hessian)
  {
    const Vector3d weightGradient = this->slope_ * this->meanOffset(); // relative to the weight
    const Eigen::Matrix3d turn = result.gradient * weightGradient.transpose();
    result.hessian =
      this->slope_ * (this->offsets_.transpose() * deviations.asDiagonal() * this->offsets_);
    result.hessian -= turn + turn.transpose();
  }
  return result;
}

} // namespace SurfaceScalars
