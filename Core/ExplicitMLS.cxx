#include "FieldSchemes.h"
#include "GaussianAverage.h"
#include "SampleSearch.h"

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
    , parameters_(parameters)
    , search_(samples.cloud)
  {
  }

  bool center(const Vector3d& place) override;
  FieldJet jet(const Vector3d& place, Derivatives derivatives) const override;

private:
  FieldSamples samples_;
  FieldParameters parameters_;
  SampleSearch search_;
  SampleRows points_;
  Values values_;
  double width_ = 1.0;
  mutable GaussianAverage average_; // keeps its buffers
};

bool ExplicitMLS::center(const Vector3d& place)
{
  const double radius = searchAround(place, this->parameters_, this->search_);
  const std::vector<Index>& near = this->search_.indices();
  const auto count = static_cast<Eigen::Index>(near.size());
  this->points_.resize(count, 3);
  this->values_.resize(count);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    const Index sample = near[static_cast<std::size_t>(i)];
    this->points_.row(i) = this->samples_.cloud.points().col(sample);
    this->values_[i] = this->samples_.values[sample];
  }
  this->width_ = averageWidth(this->parameters_.kernelWidth, radius);
  return count > 0;
}

FieldJet ExplicitMLS::jet(const Vector3d& place, Derivatives derivatives) const
{
  this->average_.weigh(this->points_, place, this->width_);
  return this->average_.jet(this->values_, derivatives);
}

} // namespace

double searchAround(const Vector3d& place, const FieldParameters& parameters, SampleSearch& search)
{
  if (parameters.searchRadius > 0.0)
  {
    search.within(place, parameters.searchRadius);
    return parameters.searchRadius;
  }
  search.nearest(place, parameters.neighborCount);
  return search.reach();
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
