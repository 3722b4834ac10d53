#pragma once

#include "Basics.h"

namespace SurfaceScalars
{

/// Whether values are equal but for rounding: to 1e-12 of their size.
/// @param values finite, at least one
inline bool areConstant(const ValuesRef& values)
{
  constexpr double rounding = 1e-12;
  return values.maxCoeff() - values.minCoeff() <= rounding * values.cwiseAbs().maxCoeff();
}

} // namespace SurfaceScalars
