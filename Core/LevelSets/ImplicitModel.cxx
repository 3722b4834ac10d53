#include "LevelSetModel.h"

#include <cmath>

namespace SurfaceScalars
{
namespace
{

constexpr int NewtonIterations = 10;      // the projection takes new samples and goes on
constexpr double NewtonTolerance = 1e-12; // in neighborhood radii
constexpr double TrustedRadius = 1.0;     // of the place the samples were taken around
constexpr double KeptRadius = 0.25;       // in sampling steps

/// F and g as any two functions that are analytic in space while their samples stay. They stay
/// while a place is projected: F and g would jump with them.
class ImplicitModel : public LevelSetModel
{
public:
  ImplicitModel(const NeighborGraph& graph, const FitSize& size,
    std::unique_ptr<FieldApproximation> function, std::unique_ptr<FieldApproximation> surface)
    : graph_(graph)
    , size_(size)
    , function_(std::move(function))
    , surface_(std::move(surface))
  {
  }

  bool center(const Vector3d& place) override;
  std::optional<Vector3d> solve(double level, const Vector3d& start) const override;
  const std::vector<Index>& samples() const override { return this->neighborhood_.indices; }

private:
  bool gather(const Vector3d& place);

  const NeighborGraph& graph_;
  FitSize size_;
  std::unique_ptr<FieldApproximation> function_; // F
  std::unique_ptr<FieldApproximation> surface_;  // g
  Neighborhood neighborhood_;
  Vector3d gatherPlace_ = Vector3d::Zero();
  double kept_ = -1.0; // how far from gatherPlace_ its samples are kept
};

bool ImplicitModel::gather(const Vector3d& place)
{
  this->kept_ = -1.0;
  this->gatherPlace_ = place;
  this->graph_.nearest(place, this->size_.count, this->neighborhood_);
  this->reach = std::sqrt(this->neighborhood_.squaredDistances.back());
  if (this->size_.radius > this->reach)
  {
    this->reach = this->size_.radius;
    this->graph_.within(place, this->reach, this->neighborhood_);
  }
  if (!this->function_->center(place) || !this->surface_->center(place))
  {
    return false;
  }
  const auto count = static_cast<double>(this->neighborhood_.indices.size());
  this->kept_ = KeptRadius * this->reach * std::sqrt(Pi / count);
  return true;
}

bool ImplicitModel::center(const Vector3d& place)
{
  if (!place.allFinite())
  {
    return false;
  }
  if (!((place - this->gatherPlace_).norm() <= this->kept_) && !this->gather(place))
  {
    return false;
  }
  const FieldJet f = this->function_->jet(place, Derivatives::Gradient);
  const FieldJet g = this->surface_->jet(place, Derivatives::Gradient);
  this->value = f.value;
  this->valueGradient = f.gradient;
  this->distance = g.value;
  this->distanceGradient = g.gradient;
  return std::isfinite(this->value) && this->valueGradient.allFinite() &&
    std::isfinite(this->distance) && this->distanceGradient.allFinite();
}

std::optional<Vector3d> ImplicitModel::solve(double level, const Vector3d& start) const
{
  Vector3d place = start;
  for (int i = 0; i < NewtonIterations; ++i)
  {
    const FieldJet f = this->function_->jet(place, Derivatives::Gradient);
    const FieldJet g = this->surface_->jet(place, Derivatives::Gradient);
    const std::optional<Vector3d> step =
      leastNormStep(f.gradient, g.gradient, Vector2d(level - f.value, -g.value));
    if (!step)
    {
      return {};
    }
    place += *step;
    if (!((place - this->gatherPlace_).norm() <= TrustedRadius * this->reach))
    {
      return {};
    }
    if (step->norm() <= NewtonTolerance * this->reach)
    {
      break;
    }
  }
  return place;
}

} // namespace

std::unique_ptr<LevelSetModel> makeImplicitModel(const NeighborGraph& graph, const FitSize& size,
  std::unique_ptr<FieldApproximation> function, std::unique_ptr<FieldApproximation> surface)
{
  return std::make_unique<ImplicitModel>(graph, size, std::move(function), std::move(surface));
}

} // namespace SurfaceScalars
