#include "AverageSurface.h"
#include "LevelSetModel.h"

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
  const std::vector<Index>& samples() const override { return this->neighborhood_.indices; }

private:
  void gather(const Vector3d& place);
  bool evaluateSurface();

  const SampledFunction& function_;
  FitSize size_;
  double fixedWidth_;
  Neighborhood neighborhood_;
  Vector3d gatherPlace_ = Vector3d::Zero();
  SampleRows points_; // of the neighborhood
  Values values_;
  GaussianAverage average_;
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
  const auto count = static_cast<Eigen::Index>(this->neighborhood_.indices.size());
  this->points_.resize(count, 3);
  this->values_.resize(this->function_.volumeFunction ? 0 : count);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    const Index sample = this->neighborhood_.indices[static_cast<std::size_t>(i)];
    this->points_.row(i) = this->function_.graph.points().col(sample);
    if (!this->function_.volumeFunction)
    {
      this->values_[i] = this->function_.values[sample];
    }
  }
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
  if (this->points_.rows() == 0)
  {
    return false;
  }
  this->average_.weigh(this->points_, place, this->width_);
  if (this->function_.volumeFunction)
  {
    this->value = this->function_.volumeFunction(place, &this->valueGradient);
  }
  else
  {
    const FieldJet average = this->average_.jet(this->values_, Derivatives::Gradient);
    this->value = average.value;
    this->valueGradient = average.gradient;
  }
  return this->evaluateSurface() && std::isfinite(this->value);
}

bool AverageModel::evaluateSurface()
{
  const std::optional<SurfaceNormal> normal = surfaceNormal(this->average_);
  if (!normal)
  {
    return false; // the samples lie on a line
  }
  const FieldJet g = averageDistance(this->average_, *normal);
  this->distance = g.value;
  this->distanceGradient = g.gradient;
  return this->distanceGradient.allFinite() && this->valueGradient.allFinite();
}

std::optional<Vector3d> AverageModel::solve(double level, const Vector3d& start) const
{
  // One Gauss-Newton step: the model is only known to first order away from its center.
  const Vector3d predicted = start - this->place_;
  const Vector2d missing(level - this->value - this->valueGradient.dot(predicted),
    -this->distance - this->distanceGradient.dot(predicted));
  const std::optional<Vector3d> step =
    leastNormStep(this->valueGradient, this->distanceGradient, missing);
  if (!step || !(step->norm() <= 0.5 * this->reach))
  {
    return {};
  }
  return start + *step;
}

} // namespace

std::unique_ptr<LevelSetModel> makeAverageModel(
  const SampledFunction& function, const FitSize& size, double kernelWidth)
{
  return std::make_unique<AverageModel>(function, size, kernelWidth);
}

} // namespace SurfaceScalars
