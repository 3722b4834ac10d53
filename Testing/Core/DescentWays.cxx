#include "DescentWays.h"

#include "Sampling.h"

#include <Eigen/LU>

#include <limits>
#include <memory>

namespace SurfaceScalars::Truth
{
namespace
{

/// Gradient and Hessian of F in the plane.
struct PlanarField
{
  const Field& field;
  std::unique_ptr<FieldApproximation> approximation;

  explicit PlanarField(const Field& of)
    : field(of)
    , approximation(of.approximation())
  {
  }
  FieldJet at(const Vector2d& place) const
  {
    const Vector3d local = Vector3d(place.x(), place.y(), 0.0) - this->field.cloud().origin();
    if (!this->approximation->center(local))
    {
      return { 0.0, Vector3d::Constant(std::numeric_limits<double>::infinity()),
        Eigen::Matrix3d::Zero() };
    }
    return this->approximation->jet(local, Derivatives::Hessian);
  }
};

/// Levenberg and Marquardt's method for grad F = 0: a trust region around every place.
Way follow(const PlanarField& field, Vector2d place)
{
  FieldJet jet = field.at(place);
  Way way{ place, { jet.gradient.head<2>().norm() } };
  double damping = 1e-3;
  for (int i = 0; i < 200 && !way.converged(); ++i)
  {
    const Eigen::Matrix2d hessian = jet.hessian.topLeftCorner<2, 2>();
    const Eigen::Matrix2d damped =
      hessian.transpose() * hessian + damping * hessian.squaredNorm() * Eigen::Matrix2d::Identity();
    const Vector2d trial = place - damped.inverse() * hessian.transpose() * jet.gradient.head<2>();
    const FieldJet there = field.at(trial);
    const double gradient = there.gradient.head<2>().norm();
    if (gradient < way.gradients.back())
    {
      place = trial;
      jet = there;
      way.gradients.push_back(gradient);
      damping *= 0.1;
    }
    else if ((damping *= 10.0) > 1e12)
    {
      break; // F does not vary any more, or jumps here
    }
  }
  way.end = place;
  return way;
}

} // namespace

std::vector<Way> followFromRandomStarts(const Field& field, double halfWidth, int startCount)
{
  Random random(7);
  const PlanarField planar(field);
  std::vector<Way> ways;
  for (int i = 0; i < startCount; ++i)
  {
    const double x = random.uniform(-halfWidth, halfWidth);
    ways.push_back(follow(planar, Vector2d(x, random.uniform(-halfWidth, halfWidth))));
  }
  return ways;
}

} // namespace SurfaceScalars::Truth
