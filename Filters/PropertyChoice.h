#pragma once

#include <initializer_list>
#include <string>

namespace SurfaceScalars
{

/// @param names the values with their meaning, for the error
/// @throws InvalidInput if `value` is none of the values a property has
void checkChoice(const std::string& property, int value, std::initializer_list<int> values,
  const std::string& names);

} // namespace SurfaceScalars
