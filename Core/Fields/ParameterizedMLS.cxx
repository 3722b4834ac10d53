#include "FieldSchemes.h"
#include "LocalFit.h"
#include "PolynomialNeighborhood.h"

#include <cmath>

namespace SurfaceScalars
{
namespace
{

class ParameterizedMLS : public FieldApproximation
{
public:
  ParameterizedMLS(const FieldSamples& samples, const FieldParameters& parameters)
    : polynomials_(samples.cloud, samples.values,
        { parameters.neighborCount, parameters.searchRadius }, parameters.polynomialDegree)
    , cloud_(samples.cloud)
    , searchRadius_(parameters.searchRadius)
  {
  }

  Eigen::Index expect(const PointsRef& places) override
  {
    return this->polynomials_.expect(places);
  }
  bool center(const Vector3d& place) override;
  FieldJet jet(const Vector3d& place, Derivatives derivatives) const override;

private:
  PolynomialNeighborhood polynomials_;
  const PointCloud& cloud_;
  Neighborhood nearest_;
  double searchRadius_;
};

bool ParameterizedMLS::center(const Vector3d& place)
{
  if (this->searchRadius_ > 0.0)
  {
    this->cloud_.nearest(place, 1, this->nearest_);
    if (std::sqrt(this->nearest_.squaredDistances.front()) > this->searchRadius_)
    {
      return false;
    }
  }
  return this->polynomials_.center(place);
}

/// F(q) = r at the orthogonal projection of q: constant along the normal.
FieldJet ParameterizedMLS::jet(const Vector3d& place, Derivatives derivatives) const
{
  const LocalFit& fit = this->polynomials_.fit();
  const Vector2d uv = fit.flatten(place);
  const auto axes = fit.frame().leftCols<2>();
  FieldJet result;
  if (derivatives == Derivatives::Hessian)
  {
    const LocalFit::Jet r = fit.value(uv);
    result.value = r.value;
    result.gradient = axes * r.gradient;
    result.hessian = axes * r.hessian * axes.transpose();
    return result;
  }
  const LocalFit::Slope r = fit.valueSlope(uv);
  result.value = r.value;
  result.gradient = axes * r.gradient;
  return result;
}

} // namespace

std::unique_ptr<FieldApproximation> makeParameterizedMLS(
  const FieldSamples& samples, const FieldParameters& parameters)
{
  return std::make_unique<ParameterizedMLS>(samples, parameters);
}

} // namespace SurfaceScalars
