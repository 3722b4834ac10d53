#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace SurfaceScalars
{

/// The value below which a fraction of the values lies, 0.5 for the median; puts them into another
/// order.
inline double quantile(std::vector<double>& values, double fraction)
{
  const auto element =
    values.begin() + static_cast<std::ptrdiff_t>(fraction * static_cast<double>(values.size()));
  if (element == values.begin())
  {
    return *std::min_element(values.begin(), values.end()); // std::nth_element would sort as usual
  }
  std::nth_element(values.begin(), element, values.end());
  return *element;
}

/// The element at a site, of sites spread evenly over `count` elements.
inline std::size_t siteOf(std::size_t site, std::size_t sites, std::size_t count)
{
  return (2 * site + 1) * count / (2 * sites);
}

/// The median of ten thousand values spread over all, which is as good as that of all and quicker.
template <class ValueAt>
double medianOfSome(std::size_t count, const ValueAt& valueAt)
{
  const std::size_t stride = std::max<std::size_t>(1, count / 10000);
  std::vector<double> some;
  some.reserve(count / stride + 1);
  for (std::size_t i = stride / 2; i < count; i += stride)
  {
    some.push_back(valueAt(i));
  }
  return quantile(some, 0.5);
}

} // namespace SurfaceScalars
