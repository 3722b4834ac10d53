#pragma once

#include "Error.h"
#include "NumberText.h"
#include "RadialKernel.h"

#include <string>

namespace SurfaceScalars
{

/// Says that a system of radial functions cannot be solved, and what helps with its kernel.
/// @param flaw "that makes ... singular" @throws InvalidInput
[[noreturn]] inline void refuseRadialSystem(
  const RadialKernel& kernel, double reciprocalCondition, const std::string& flaw)
{
  throw InvalidInput("a kernel whose system can be solved at machine precision",
    "a " + std::string(nameOf(kernel.type())) + " kernel of width " + textOf(kernel.width()) + " " +
      flaw + " (condition " +
      (reciprocalCondition > 0.0 ? "about " + textOf(1.0 / reciprocalCondition) : "infinite") + ")",
    kernel.dependsOnWidth()
      ? "Lower KernelWidth, raise Regularization to 1e-10 or so, or choose the Cubic Kernel."
      : "Raise Regularization to 1e-10 or so, or leave points out that nearly coincide.");
}

} // namespace SurfaceScalars
