#include "PropertyChoice.h"

#include "Error.h"
#include "NumberText.h"

#include <algorithm>
#include <limits>

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

void checkFraction(const std::string& property, double value)
{
  if (!(value >= 0.0 && value <= 1.0))
  {
    throw InvalidInput("a " + property + " from 0 to 1", textOf(value),
      "It is a fraction of the range of values; 0 keeps all.");
  }
}

void checkGridDimensions(const int size[3], int least, const std::string& advice)
{
  const std::string found =
    std::to_string(size[0]) + " " + std::to_string(size[1]) + " " + std::to_string(size[2]);
  if (*std::min_element(size, size + 3) < least)
  {
    throw InvalidInput("GridDimensions of at least " + std::to_string(least), found, advice);
  }
  constexpr int most = std::numeric_limits<int>::max();
  if (static_cast<double>(size[0]) * size[1] * size[2] > most)
  {
    throw InvalidInput(
      "GridDimensions with at most " + std::to_string(most) + " points in all", found, advice);
  }
}

} // namespace SurfaceScalars
