#include "AverageSurface.h"

#include "ImplicitSurface.h"

#include <Eigen/Eigenvalues>

#include <limits>

namespace SurfaceScalars
{
namespace
{

constexpr double Support = 3.0; // kernel widths: samples beyond weigh less than 2e-4 of the nearest
constexpr double LineFraction = 1e-6; // of the largest spread, squared, in the second largest

using Distance = FieldJet (*)(const GaussianAverage&, const SurfaceNormal&);

class GaussianSurface : public FieldApproximation
{
public:
  GaussianSurface(const OrientedSamples& samples, double width, Distance distance)
    : samples_(samples)
    , width_(width)
    , distance_(distance)
  {
  }

  bool center(const Vector3d& place) override;
  FieldJet jet(const Vector3d& place, Derivatives derivatives) const override;

private:
  OrientedSamples samples_;
  double width_;
  Distance distance_;
  Neighborhood near_;
  SampleRows points_;
  Vector3d side_ = Vector3d::Zero();
  mutable GaussianAverage average_; // keeps its buffers
};

bool GaussianSurface::center(const Vector3d& place)
{
  this->samples_.cloud.within(place, Support * this->width_, this->near_);
  if (this->near_.indices.empty())
  {
    return false;
  }
  this->side_ = this->samples_.normals.col(this->near_.indices.front());
  this->points_ = this->samples_.cloud.points()(Eigen::all, this->near_.indices).transpose();
  this->average_.weigh(this->points_, place, this->width_);
  return surfaceNormal(this->average_).has_value();
}

FieldJet GaussianSurface::jet(const Vector3d& place, Derivatives) const
{
  this->average_.weigh(this->points_, place, this->width_);
  const std::optional<SurfaceNormal> normal = surfaceNormal(this->average_);
  if (!normal)
  {
    constexpr double Undefined = std::numeric_limits<double>::quiet_NaN();
    return { Undefined, Vector3d::Constant(Undefined), {} };
  }
  // Both change their sign with the normal.
  const double sign = normal->direction.dot(this->side_) < 0.0 ? -1.0 : 1.0;
  FieldJet result = this->distance_(this->average_, *normal);
  result.value *= sign;
  result.gradient *= sign;
  return result;
}

} // namespace

std::optional<SurfaceNormal> surfaceNormal(const GaussianAverage& average)
{
  const SampleRows& offsets = average.offsets();
  const Values& weights = average.weights();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes;
  axes.computeDirect(offsets.transpose() * weights.asDiagonal() * offsets);
  const Vector3d& eigenvalues = axes.eigenvalues();
  SurfaceNormal result{ axes.eigenvectors().col(0), Eigen::Matrix3d::Zero() };
  if (!result.direction.allFinite() || !(eigenvalues[1] > LineFraction * eigenvalues[2]))
  {
    return {};
  }
  // The derivatives of the moments by the place, times n.
  const Values heights = weights.cwiseProduct(offsets * result.direction);
  const Eigen::Matrix3d moments =
    average.slope() * (offsets.transpose() * heights.asDiagonal() * offsets) -
    heights.sum() * Eigen::Matrix3d::Identity() -
    average.weightSum() * average.meanOffset() * result.direction.transpose();
  for (int axis = 1; axis < 3; ++axis)
  {
    const Vector3d tangent = axes.eigenvectors().col(axis);
    result.turn += tangent * (tangent.transpose() * moments) / (eigenvalues[0] - eigenvalues[axis]);
  }
  return result;
}

FieldJet extremalDistance(const GaussianAverage& average, const SurfaceNormal& normal)
{
  // h_i = <x - p_i, n>, and 1 / h^2 of the kernel is slope / 2.
  const SampleRows& offsets = average.offsets();
  const Eigen::ArrayXd weights = average.weights() / average.weightSum();
  const Eigen::ArrayXd heights = -(offsets * normal.direction).array();
  const Eigen::ArrayXd squares = 0.5 * average.slope() * heights.square();
  const Values terms = weights * (1.0 - squares) * heights;
  const Values slopes = weights * (1.0 - 3.0 * squares);
  FieldJet result;
  result.value = terms.sum();
  result.gradient = slopes.sum() * normal.direction -
    normal.turn.transpose() * (offsets.transpose() * slopes) +
    average.slope() * (offsets.transpose() * terms - result.value * average.meanOffset());
  return result;
}

FieldJet averageDistance(const GaussianAverage& average, const SurfaceNormal& normal)
{
  const SampleRows& offsets = average.offsets();
  const Vector3d mean = average.meanOffset(); // b(x) - x
  const Values heights =
    average.weights().cwiseProduct(offsets * normal.direction) / average.weightSum();
  FieldJet result;
  result.value = -mean.dot(normal.direction);
  result.gradient = normal.direction - normal.turn.transpose() * mean -
    average.slope() * (offsets.transpose() * heights + result.value * mean);
  return result;
}

std::unique_ptr<FieldApproximation> makeExtremalSurface(
  const OrientedSamples& samples, double kernelWidth)
{
  return std::make_unique<GaussianSurface>(samples, kernelWidth, extremalDistance);
}

std::unique_ptr<FieldApproximation> makeAverageSurface(
  const OrientedSamples& samples, double kernelWidth)
{
  return std::make_unique<GaussianSurface>(samples, kernelWidth, averageDistance);
}

} // namespace SurfaceScalars
