#include "LevelSetModel.h"
#include "NearestSearch.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <functional>

namespace SurfaceScalars
{
namespace
{

constexpr double LargestStep = 0.3;   // of one Newton iteration, in neighborhood radii
constexpr double TrustedRadius = 1.0; // places farther from the center are not the model's business
constexpr int NewtonIterations = 100; // few are needed but at the edges of a given function
constexpr double NewtonTolerance = 1e-12; // in neighborhood radii
constexpr int LargestEnlargement = 8; // of a neighborhood that does not determine the polynomials
constexpr double LargestVoid = 0.5;   // distance to the nearest sample, in neighborhood radii
constexpr double VoidWidening = 2.0;  // of the neighborhood beyond that

/// More samples than count, so that places nearby need no search.
int enoughFor(int count)
{
  return count + count / 8 + 4;
}

class PolynomialModel : public LevelSetModel
{
public:
  PolynomialModel(const SampledFunction& function, const FitSize& size, int degree)
    : function_(function)
    , size_(size)
    , degree_(degree)
    , search_(function.graph,
        std::min<std::size_t>(
          static_cast<std::size_t>(enoughFor(size.count)), function.graph.pointCount()))
  {
  }

  bool center(const Vector3d& place) override;
  std::optional<Vector3d> solve(double level, const Vector3d& start) const override;
  std::optional<Saddle> nearbySaddle() const override;

private:
  bool fit(const Vector3d& place, int count, int degree);
  void gather(const Vector3d& place, int count);
  void copySamples();
  double radiusAround(const Vector3d& place, int count);
  void weigh(double radius);
  bool evaluateAtCenter();
  double valueOn(const Vector2d& uv, Vector2d& gradient) const;

  const SampledFunction& function_;
  FitSize size_;
  int degree_;
  NearestSearch search_;
  LocalFit fit_;
  WeightedSamples samples_;
  bool centered_ = false;
  std::vector<double> scratch_;
  int gatheredCount_ = 0; // asked for at the last gathering
  double gatherMargin_ =
    0.0; // how far from gatherPlace_ the samples gathered are still all that count
};

void PolynomialModel::gather(const Vector3d& place, int count)
{
  this->gatherPlace_ = place;
  this->gatheredCount_ = count;
  const int enough = enoughFor(count);
  if (this->size_.radius > 0.0)
  {
    this->function_.graph.within(place, 1.1 * this->size_.radius, this->neighborhood_);
    this->gatherMargin_ = 0.1 * this->size_.radius;
  }
  if (!(this->size_.radius > 0.0) ||
    this->neighborhood_.indices.size() < static_cast<std::size_t>(enough))
  {
    if (count == this->size_.count)
    {
      this->search_.follow(place, this->neighborhood_);
    }
    else
    {
      this->function_.graph.nearest(place, enough, this->neighborhood_);
    }
    const auto& squared = this->neighborhood_.squaredDistances;
    const std::size_t last = std::min(squared.size(), static_cast<std::size_t>(count)) - 1;
    this->gatherMargin_ = 0.5 * (std::sqrt(squared.back()) - std::sqrt(squared[last]));
  }
  this->copySamples();
}

void PolynomialModel::copySamples()
{
  const auto found = static_cast<Eigen::Index>(this->neighborhood_.indices.size());
  this->samples_.points.resize(3, found);
  this->samples_.values.resize(found);
  this->samples_.weights.resize(found);
  for (Eigen::Index i = 0; i < found; ++i)
  {
    const Index index = this->neighborhood_.indices[static_cast<std::size_t>(i)];
    this->samples_.points.col(i) = this->function_.graph.points().col(index);
    this->samples_.values[i] =
      this->function_.values.size() > 0 ? this->function_.values[index] : 0.0;
  }
}

/// Distance to the count-th sample; more in a void, so that samples from across a hole take part.
/// Continuous in the place.
double PolynomialModel::radiusAround(const Vector3d& place, int count)
{
  // The squared distances are kept where the weights, which come from them, are to be.
  Values& squared = this->samples_.weights;
  squared = (this->samples_.points.colwise() - place).colwise().squaredNorm().transpose();
  this->scratch_.assign(squared.data(), squared.data() + squared.size());
  // Few samples lie beyond, mostly the last: a heap of these costs less than std::nth_element.
  const auto farthest = this->scratch_.rbegin();
  const auto last = farthest + (squared.size() - std::min<Eigen::Index>(count, squared.size()));
  std::partial_sort(farthest, last + 1, this->scratch_.rend(), std::greater<>());
  const double radius = std::max(std::sqrt(*last), this->size_.radius);
  const double nearest = std::sqrt(squared.minCoeff()) / radius;
  return radius * (1.0 + VoidWidening * std::max(0.0, nearest - LargestVoid));
}

/// Turns the squared distances that radiusAround() left into weights (1 - r^2 / radius^2)^2, which
/// vanish smoothly at the radius.
void PolynomialModel::weigh(double radius)
{
  this->samples_.weights =
    (1.0 - this->samples_.weights.array() / (radius * radius)).max(0.0).square();
}

bool PolynomialModel::fit(const Vector3d& place, int count, int degree)
{
  if (this->gatheredCount_ != count ||
    !((place - this->gatherPlace_).norm() <= this->gatherMargin_))
  {
    this->gather(place, count);
  }
  this->reach = this->radiusAround(place, count);
  const auto gathered = static_cast<std::size_t>(count);
  if (this->reach * this->reach > this->samples_.weights.maxCoeff() &&
    gathered < this->function_.graph.pointCount())
  {
    // No more than that: near a stray point the radius may be that of everything.
    this->function_.graph.nearest(place, LargestEnlargement * count, this->neighborhood_);
    this->reach = std::min(this->reach, std::sqrt(this->neighborhood_.squaredDistances.back()));
    this->copySamples();
    this->samples_.weights =
      (this->samples_.points.colwise() - place).colwise().squaredNorm().transpose();
    this->gatheredCount_ = 0; // of no use for another place
  }
  this->weigh(this->reach);
  return this->fit_.compute(place, this->samples_, this->reach, degree);
}

bool PolynomialModel::center(const Vector3d& place)
{
  if (!place.allFinite())
  {
    return false;
  }
  if (this->centered_ && place == this->fit_.center())
  {
    return true;
  }
  // Samples on a few parallel lines do not determine the polynomials: take more of them, then a
  // lower degree.
  const int all = static_cast<int>(this->function_.graph.pointCount());
  for (int degree = this->degree_; degree >= 1; --degree)
  {
    for (int more = 1;; more *= 2)
    {
      const bool last = more == LargestEnlargement || this->size_.count * more >= all;
      if (this->fit(place, this->size_.count * more, degree))
      {
        return this->centered_ = this->evaluateAtCenter();
      }
      if (last)
      {
        break;
      }
    }
  }
  return this->centered_ = false;
}

bool PolynomialModel::evaluateAtCenter()
{
  const Eigen::Matrix3d& frame = this->fit_.frame();
  const LocalFit::Slope height = this->fit_.heightSlope(Vector2d::Zero());
  this->distance = -height.value;
  this->distanceGradient = frame * Vector3d(-height.gradient.x(), -height.gradient.y(), 1.0);
  if (this->function_.volumeFunction)
  {
    this->value = this->function_.volumeFunction(this->fit_.center(), &this->valueGradient);
  }
  else
  {
    const LocalFit::Slope f = this->fit_.valueSlope(Vector2d::Zero());
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
