#include "LevelSetModel.h"

#include <Eigen/Eigenvalues>

#include <cmath>

namespace SurfaceScalars
{
namespace
{

constexpr double Support =
  3.0; // samples beyond this many kernel widths weigh less than 2e-4 of the nearest

class AverageModel : public LevelSetModel
{
public:
  AverageModel(const SampledFunction& function, const FitSize& size, double kernelWidth)
    : function_(function)
    , size_(size)
    , fixedWidth_(kernelWidth)
  {
  }

  bool center(const Vector3d& place) override;
  std::optional<Vector3d> solve(double level, const Vector3d& start) const override;

private:
  void gather(const Vector3d& place);
  bool evaluateSurface(double weight, const Vector3d& mean, const Eigen::Matrix3d& moments);

  const SampledFunction& function_;
  FitSize size_;
  double fixedWidth_;
  double width_ = 0.0; // h; fixed while a place is projected: F would jump with it
  Vector3d place_ = Vector3d::Zero();
};

void AverageModel::gather(const Vector3d& place)
{
  this->gatherPlace_ = place;
  double sigma = this->size_.radius;
  if (!(sigma > 0.0))
  {
    this->function_.graph.nearest(place, this->size_.count, this->neighborhood_);
    sigma = std::sqrt(this->neighborhood_.squaredDistances.back());
  }
  this->width_ = this->fixedWidth_ > 0.0 ? this->fixedWidth_ : sigma / std::sqrt(3.0);
  this->reach = sigma;
  this->function_.graph.within(place, Support * this->width_, this->neighborhood_);
}

bool AverageModel::center(const Vector3d& place)
{
  if (!place.allFinite())
  {
    return false;
  }
  if (!(this->width_ > 0.0) || (place - this->gatherPlace_).norm() > 0.25 * this->width_)
  {
    this->gather(place);
  }
  this->place_ = place;
  const double inverse = 1.0 / (this->width_ * this->width_);
  double weight = 0.0;
  double valueSum = 0.0;
  Vector3d offsets = Vector3d::Zero();
  Vector3d valueOffsets = Vector3d::Zero();
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  for (const Index i : this->neighborhood_.indices)
  {
    const Vector3d offset = this->function_.graph.points().col(i) - place;
    const double w = std::exp(-offset.squaredNorm() * inverse);
    weight += w;
    offsets += w * offset;
    moments += (w * offset) * offset.transpose();
    if (!this->function_.volumeFunction)
    {
      valueSum += w * this->function_.values[i];
      valueOffsets += (w * this->function_.values[i]) * offset;
    }
  }
  if (!(weight > 0.0))
  {
    return false;
  }
  if (this->function_.volumeFunction)
  {
    this->value = this->function_.volumeFunction(place, &this->valueGradient);
  }
  else
  {
    // (6) and, with offsets p_i - p, (7).
    this->value = valueSum / weight;
    this->valueGradient = 2.0 * inverse * (valueOffsets - this->value * offsets) / weight;
  }
  return this->evaluateSurface(weight, offsets / weight, moments) && std::isfinite(this->value);
}

/// (2) with its exact gradient: n turns with the place, so that the gradient is not n itself.
bool AverageModel::evaluateSurface(
  double weight, const Vector3d& mean, const Eigen::Matrix3d& moments)
{
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes;
  axes.computeDirect(moments);
  const Vector3d normal = axes.eigenvectors().col(0);
  const Vector3d& eigenvalues = axes.eigenvalues();
  if (!normal.allFinite() || !(eigenvalues[1] > 1e-9 * eigenvalues[2]))
  {
    return false; // the samples lie on a line
  }
  const double inverse = 1.0 / (this->width_ * this->width_);
  // Derivatives by the place of the weighted mean, times n, and of the moments, times n.
  Vector3d meanAlongNormal = Vector3d::Zero();
  Eigen::Matrix3d momentsNormal = Eigen::Matrix3d::Zero();
  for (const Index i : this->neighborhood_.indices)
  {
    const Vector3d offset = this->function_.graph.points().col(i) - this->place_;
    const double w = std::exp(-offset.squaredNorm() * inverse);
    const double height = offset.dot(normal);
    meanAlongNormal += (w * height) * offset;
    momentsNormal += (2.0 * inverse * w * height) * offset * offset.transpose() -
      (w * height) * Eigen::Matrix3d::Identity() - (w * offset) * normal.transpose();
  }
  this->distance = -mean.dot(normal);
  this->distanceGradient =
    normal - 2.0 * inverse * (meanAlongNormal / weight - mean * mean.dot(normal));
  for (int axis = 1; axis < 3; ++axis)
  {
    const Vector3d tangent = axes.eigenvectors().col(axis);
    const double turn = tangent.dot(-mean) / (eigenvalues[0] - eigenvalues[axis]);
    this->distanceGradient += turn * (momentsNormal.transpose() * tangent);
  }
  return this->distanceGradient.allFinite() && this->valueGradient.allFinite();
}

std::optional<Vector3d> AverageModel::solve(double level, const Vector3d& start) const
{
  // One Gauss-Newton step: the model is only known to first order away from its center.
  const Vector3d predicted = start - this->place_;
  Eigen::Matrix<double, 2, 3> jacobian;
  jacobian << this->valueGradient.transpose(), this->distanceGradient.transpose();
  const Eigen::Matrix2d gram = jacobian * jacobian.transpose();
  if (!(gram.determinant() > 1e-14 * gram(0, 0) * gram(1, 1)))
  {
    return {};
  }
  const Vector2d missing = Vector2d(level - this->value, -this->distance) - jacobian * predicted;
  const Vector3d step = jacobian.transpose() * (gram.inverse() * missing);
  if (!(step.norm() <= 0.5 * this->reach))
  {
    return {};
  }
  return start + step;
}

} // namespace

std::unique_ptr<LevelSetModel> makeAverageModel(
  const SampledFunction& function, const FitSize& size, double kernelWidth)
{
  return std::make_unique<AverageModel>(function, size, kernelWidth);
}

} // namespace SurfaceScalars
