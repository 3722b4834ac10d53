#include "ImplicitSurface.h"

namespace SurfaceScalars
{
namespace
{

const Values NoValues; // only the surface is wanted

class PolynomialSurface : public FieldApproximation
{
public:
  PolynomialSurface(const PointCloud& cloud, const FitSize& size, int degree)
    : polynomials_(cloud, NoValues, size, degree)
  {
  }

  bool center(const Vector3d& place) override { return this->polynomials_.center(place); }

  FieldJet jet(const Vector3d& place, Derivatives) const override
  {
    const LocalFit& fit = this->polynomials_.fit();
    const Vector3d local = fit.frame().transpose() * (place - fit.center());
    const LocalFit::Slope height = fit.heightSlope(local.head<2>());
    const Vector3d gradient(-height.gradient.x(), -height.gradient.y(), 1.0);
    return { local.z() - height.value, fit.frame() * gradient, {} };
  }

private:
  PolynomialNeighborhood polynomials_;
};

} // namespace

std::unique_ptr<FieldApproximation> makePolynomialSurface(
  const PointCloud& cloud, const FitSize& size, int degree)
{
  return std::make_unique<PolynomialSurface>(cloud, size, degree);
}

} // namespace SurfaceScalars
