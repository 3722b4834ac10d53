#include "FieldApproximation.h"

namespace SurfaceScalars
{

FieldApproximation::~FieldApproximation() = default;

} // namespace SurfaceScalars
