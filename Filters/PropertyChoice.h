#pragma once

#include <initializer_list>
#include <string>

namespace SurfaceScalars
{

/// @param names the values with their meaning, for the error
/// @throws InvalidInput if `value` is none of the values a property has
void checkChoice(const std::string& property, int value, std::initializer_list<int> values,
  const std::string& names);

/// @throws InvalidInput unless the value is from 0 to 1
void checkFraction(const std::string& property, double value);

/// @throws InvalidInput unless a grid has at least `least` points along each axis, and as many in
/// all as can be counted
void checkGridDimensions(const int size[3], int least, const std::string& advice);

} // namespace SurfaceScalars
