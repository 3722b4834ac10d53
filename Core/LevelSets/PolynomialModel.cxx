#include "LevelSetModel.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace SurfaceScalars
{
namespace
{

constexpr double LargestStep = 0.3;   // of one Newton iteration, in neighborhood radii
constexpr double TrustedRadius = 1.0; // places farther from the center are not the model's business
constexpr int NewtonIterations = 100; // few are needed but at the edges of a given function
constexpr double NewtonTolerance = 1e-8; // in neighborhood radii; its square is left

class PolynomialModel : public LevelSetModel
{
public:
  PolynomialModel(const SampledFunction& function, const FitSize& size, int degree)
    : function_(function)
    , polynomials_(function.graph, function.values, size, degree)
    , fit_(this->polynomials_.fit())
  {
  }

  bool center(const Vector3d& place) override;
  std::optional<Vector3d> solve(double level, const Vector3d& start) const override;
  std::optional<Saddle> nearbySaddle() const override;
  double deviation() const override { return this->polynomials_.valueDeviation(); }

  const std::vector<Index>& samples() const override { return this->polynomials_.samples(); }

private:
  bool evaluateAtCenter();
  double valueOn(const Vector2d& uv, Vector2d& gradient) const;

  const SampledFunction& function_;
  PolynomialNeighborhood polynomials_;
  const LocalFit& fit_;
};

bool PolynomialModel::center(const Vector3d& place)
{
  return this->polynomials_.center(place) && this->evaluateAtCenter();
}

bool PolynomialModel::evaluateAtCenter()
{
  this->reach = this->polynomials_.radius();
  const Eigen::Matrix3d& frame = this->fit_.frame();
  const LocalFit::Slope height = this->fit_.heightAtCenter();
  this->distance = -height.value;
  this->distanceGradient = frame * Vector3d(-height.gradient.x(), -height.gradient.y(), 1.0);
  if (this->function_.volumeFunction)
  {
    this->value = this->function_.volumeFunction(this->fit_.center(), &this->valueGradient);
  }
  else
  {
    const LocalFit::Slope f = this->fit_.valueAtCenter();
    this->value = f.value;
    this->valueGradient = frame.leftCols<2>() * f.gradient;
  }
  return std::isfinite(this->value) && this->valueGradient.allFinite();
}

/// F on the fitted surface as a function of the tangent plane's coordinates.
double PolynomialModel::valueOn(const Vector2d& uv, Vector2d& gradient) const
{
  if (!this->function_.volumeFunction)
  {
    const LocalFit::Slope f = this->fit_.valueSlope(uv);
    gradient = f.gradient;
    return f.value;
  }
  Vector3d inSpace;
  const double f = this->function_.volumeFunction(this->fit_.lift(uv), &inSpace);
  const Vector3d local = this->fit_.frame().transpose() * inSpace;
  gradient = local.head<2>() + local.z() * this->fit_.heightSlope(uv).gradient;
  return f;
}

std::optional<Vector3d> PolynomialModel::solve(double level, const Vector3d& start) const
{
  const double radius = this->reach;
  Vector2d uv = this->fit_.flatten(start);
  for (int i = 0; i < NewtonIterations; ++i)
  {
    Vector2d gradient;
    const double missing = level - this->valueOn(uv, gradient);
    const double squared = gradient.squaredNorm();
    if (!(squared > 0.0))
    {
      return {};
    }
    Vector2d step = (missing / squared) * gradient;
    const double length = step.norm();
    if (!std::isfinite(length))
    {
      return {};
    }
    step *= std::min(1.0, LargestStep * radius / length);
    uv += step;
    if (uv.norm() > TrustedRadius * radius)
    {
      return {};
    }
    if (length <= NewtonTolerance * radius)
    {
      return this->fit_.lift(uv);
    }
  }
  return {};
}

std::optional<Saddle> PolynomialModel::nearbySaddle() const
{
  if (this->function_.volumeFunction)
  {
    return {};
  }
  Vector2d uv = Vector2d::Zero();
  for (int i = 0; i < NewtonIterations; ++i)
  {
    const LocalFit::Jet f = this->fit_.value(uv);
    if (!(f.hessian.determinant() < 0.0))
    {
      return {};
    }
    const Vector2d step = f.hessian.inverse() * f.gradient;
    uv -= step;
    if (!(uv.norm() <= 0.9 * this->reach))
    {
      return {};
    }
    if (step.norm() <= NewtonTolerance * this->reach)
    {
      return Saddle{ this->fit_.lift(uv), this->fit_.value(uv).value };
    }
  }
  return {};
}

} // namespace

std::unique_ptr<LevelSetModel> makePolynomialModel(
  const SampledFunction& function, const FitSize& size, int degree)
{
  return std::make_unique<PolynomialModel>(function, size, degree);
}

} // namespace SurfaceScalars
