#pragma once

#include "Require.h"

#include <cmath>
#include <string>
#include <vector>

namespace SurfaceScalars
{

/// The list ContourValues of a filter. @throws InvalidInput if one is not finite
template <typename Filter>
std::vector<double> listOfContourValues(Filter& filter)
{
  std::vector<double> values;
  for (int i = 0; i < filter.GetNumberOfContourValues(); ++i)
  {
    values.push_back(filter.GetContourValues(i));
    require(std::isfinite(values.back()), "finite numbers as ContourValues",
      std::to_string(values.back()) + " at index " + std::to_string(i), "Correct or remove it.");
  }
  return values;
}

} // namespace SurfaceScalars
