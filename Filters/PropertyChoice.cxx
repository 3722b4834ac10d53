#include "PropertyChoice.h"

#include "Error.h"

#include <algorithm>

namespace SurfaceScalars
{

void checkChoice(const std::string& property, int value, std::initializer_list<int> values,
  const std::string& names)
{
  if (std::find(values.begin(), values.end(), value) == values.end())
  {
    throw InvalidInput(property + " " + names, std::to_string(value), "Choose one of these.");
  }
}

} // namespace SurfaceScalars
