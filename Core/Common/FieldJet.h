#pragma once

#include "Basics.h"

namespace SurfaceScalars
{

/// How much of a field is wanted: each includes the ones before.
enum class Derivatives
{
  None = 0,
  Gradient = 1,
  Hessian = 2
};

/// A function at a place; what was not asked for is not set.
struct FieldJet
{
  double value = 0.0;
  Vector3d gradient;       ///< value's unit per length
  Eigen::Matrix3d hessian; ///< symmetric
};

} // namespace SurfaceScalars
