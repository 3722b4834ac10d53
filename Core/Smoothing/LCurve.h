#pragma once

#include <cmath>

namespace SurfaceScalars
{

/// The curvature of the L-curve (log R / 2, log E / 2), R = ||f - x||^2 and E the energy of the x
/// that makes E + t R least. There dE / du = -t dR / du with u = log t, so that with
/// a = (dR / du) / R and q = t R / E it is as below; 0 where a norm is 0.
/// @param change dR / du
inline double lCurveCurvature(double residual, double energy, double change, double weight)
{
  const double a = change / residual;
  const double q = weight * residual / energy;
  const double result =
    2.0 * q * (1.0 + a * (1.0 + q)) / (std::abs(a) * std::pow(1.0 + q * q, 1.5));
  return std::isfinite(result) ? result : 0.0;
}

} // namespace SurfaceScalars
