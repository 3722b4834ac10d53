#pragma once

#include <sstream>
#include <string>

namespace SurfaceScalars
{

/// A number for a sentence; std::to_string would show 1e-9 as 0.
inline std::string textOf(double number)
{
  std::ostringstream text;
  text << number;
  return text.str();
}

} // namespace SurfaceScalars
