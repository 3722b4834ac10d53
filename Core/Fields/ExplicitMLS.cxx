#include "FieldSchemes.h"
#include "GaussianAverage.h"

#include <cmath>

namespace SurfaceScalars
{
namespace
{

class ExplicitMLS : public FieldApproximation
{
public:
  ExplicitMLS(const FieldSamples& samples, const FieldParameters& parameters)
    : samples_(samples)
    , kernelWidth_(parameters.kernelWidth)
    , search_(neighborhoodSearch(samples.cloud, parameters))
  {
  }

  Eigen::Index expect(const PointsRef& places) override { return this->search_.expect(places); }
  bool center(const Vector3d& place) override;
  FieldJet jet(const Vector3d& place, Derivatives derivatives) const override;

private:
  FieldSamples samples_;
  double kernelWidth_;
  NearestSearch search_;
  SampleRows points_;
  Values values_;
  double width_ = 1.0;
  mutable GaussianAverage average_; // keeps its buffers
};

bool ExplicitMLS::center(const Vector3d& place)
{
  const std::vector<NearestSearch::Found>& near = this->search_.find(place);
  const auto count = static_cast<Eigen::Index>(near.size());
  this->points_.resize(count, 3);
  this->values_.resize(count);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    const Index sample = near[static_cast<std::size_t>(i)].index;
    this->points_.row(i) = this->samples_.cloud.points().col(sample);
    this->values_[i] = this->samples_.values[sample];
  }
  this->width_ = averageWidth(this->kernelWidth_, this->search_.radius());
  return count > 0;
}

FieldJet ExplicitMLS::jet(const Vector3d& place, Derivatives derivatives) const
{
  this->average_.weigh(this->points_, place, this->width_);
  return this->average_.jet(this->values_, derivatives);
}

} // namespace

NearestSearch neighborhoodSearch(const PointCloud& cloud, const FieldParameters& parameters)
{
  return { cloud, static_cast<std::size_t>(parameters.neighborCount), parameters.searchRadius };
}

double averageWidth(double kernelWidth, double radius)
{
  const double width = kernelWidth > 0.0 ? kernelWidth : radius / std::sqrt(3.0);
  return width > 0.0 ? width : 1.0; // one sample, at the place itself
}

std::unique_ptr<FieldApproximation> makeExplicitMLS(
  const FieldSamples& samples, const FieldParameters& parameters)
{
  return std::make_unique<ExplicitMLS>(samples, parameters);
}

} // namespace SurfaceScalars
