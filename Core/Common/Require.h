#pragma once

#include "Error.h"

#include <string>

namespace SurfaceScalars
{

/// @throws InvalidInput with these parts of its sentence unless the condition holds
inline void require(
  bool condition, const std::string& expected, const std::string& found, const std::string& remedy)
{
  if (!condition)
  {
    throw InvalidInput(expected, found, remedy);
  }
}

} // namespace SurfaceScalars
