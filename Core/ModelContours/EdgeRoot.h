#pragma once

#include <algorithm>
#include <cmath>

namespace SurfaceScalars
{

/// A function of one variable and its derivative.
struct Slope
{
  double value;
  double derivative;
};

/**
 * A root of a function in [0, 1] between ends of different signs (0 counts as positive): from that
 * of the cubic Hermite polynomial of the inverse function by Newton's method, with bisection where
 * it leaves the bracket or is slow.
 *
 * @param from, to the function at 0 and 1 @param function called with t, returns a Slope
 */
template <typename Function>
double rootBetween(const Slope& from, const Slope& to, const Function& function)
{
  constexpr int MostSteps = 80;
  constexpr double LastStep = 1e-7; // of Newton's method: its square is rounding
  constexpr double Precision = 1e-14;
  if (from.value == 0.0 || to.value == 0.0)
  {
    return from.value == 0.0 ? 0.0 : 1.0;
  }
  const double difference = to.value - from.value;
  const double secant = -from.value / difference;
  const double rest = 1.0 - secant;
  const double cubic = secant * rest * rest * (difference / from.derivative) +
    secant * secant * (3.0 - 2.0 * secant) - secant * secant * rest * (difference / to.derivative);
  double t = cubic > 0.0 && cubic < 1.0 ? cubic : secant;
  double low = 0.0;
  double high = 1.0;
  double step = 1.0;
  for (int i = 0; i < MostSteps && high - low > Precision; ++i)
  {
    const Slope at = function(t);
    if (at.value == 0.0 || !std::isfinite(at.value))
    {
      break;
    }
    ((at.value < 0.0) == (from.value < 0.0) ? low : high) = t;
    const double last = std::abs(step);
    step = -at.value / at.derivative;
    if (!(t + step > low && t + step < high && std::abs(step) <= 0.5 * last))
    {
      step = 0.5 * (low + high) - t;
      t += step;
      continue;
    }
    t += step;
    if (std::abs(step) <= LastStep)
    {
      break;
    }
  }
  return std::clamp(t, 0.0, 1.0);
}

} // namespace SurfaceScalars
