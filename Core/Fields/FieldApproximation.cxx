#include "FieldApproximation.h"

namespace SurfaceScalars
{

FieldApproximation::~FieldApproximation() = default;

Eigen::Index FieldApproximation::expect(const PointsRef& places)
{
  return places.cols();
}

} // namespace SurfaceScalars
