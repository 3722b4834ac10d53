#pragma once

#include "Error.h"
#include "NumberText.h"
#include "RadialKernel.h"

#include <cmath>
#include <string>

namespace SurfaceScalars
{

/// "Gaussian kernel of width 5", for sentences.
inline std::string textOf(const RadialKernel& kernel)
{
  return std::string(nameOf(kernel.type())) + " kernel" +
    (kernel.dependsOnWidth() ? " of width " + textOf(kernel.width()) : "");
}

/// Says what to change about a system that cannot be solved.
/// @param condition an estimate; infinite if the system is singular @throws InvalidInput
[[noreturn]] inline void refuseSystem(
  const std::string& found, const RadialKernel& kernel, double condition)
{
  std::string remedy = "Lower KernelWidth, raise Regularization to 1e-10 or so, or choose the "
                       "Cubic Kernel.";
  if (!kernel.dependsOnWidth())
  {
    remedy = "Raise Regularization to 1e-10 or so, or leave out points far from the others or that "
             "nearly coincide.";
  }
  else if (std::isfinite(kernel.support()))
  {
    remedy = "Lower KernelWidth, raise Regularization to 1e-10 or so, or leave out points that "
             "nearly coincide.";
  }
  throw InvalidInput("a kernel whose system can be solved at machine precision",
    found + " with the " + textOf(kernel) + " (condition " +
      (std::isfinite(condition) ? "about " + textOf(condition) : "infinite") + ")",
    remedy);
}

} // namespace SurfaceScalars
