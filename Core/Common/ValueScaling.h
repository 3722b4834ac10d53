#pragma once

#include "Basics.h"
#include "Quantile.h"

namespace SurfaceScalars
{

/// Takes f's range to a length of 1 and its typical value to 0, about which numbers are most
/// precise: one wild value, such as a code for "no data", must not cost the others their digits.
/// Halves: the range of finite values need not be finite.
struct ValueScaling
{
  double middle;
  double halfRange;

  explicit ValueScaling(const ValuesRef& values)
    : middle(medianOfSome(static_cast<std::size_t>(values.size()),
        [&](std::size_t i) { return values[static_cast<Eigen::Index>(i)]; }))
    , halfRange(0.5 * values.maxCoeff() - 0.5 * values.minCoeff())
  {
  }
  double operator()(double value) const
  {
    return (0.5 * value - 0.5 * this->middle) / this->halfRange;
  }
  double inverse(double scaled) const
  {
    return 2.0 * (scaled * this->halfRange + 0.5 * this->middle);
  }
};

} // namespace SurfaceScalars
