#pragma once

namespace SurfaceScalars
{

/// Index of the first monomial of a degree; monomial k of degree d is x^(d-k) y^k.
constexpr int firstTerm(int degree)
{
  return degree * (degree + 1) / 2;
}

/// The values of all monomials up to a degree.
inline void monomials(int degree, double x, double y, double* terms)
{
  terms[0] = 1.0;
  for (int d = 1; d <= degree; ++d)
  {
    const double* lower = terms + firstTerm(d - 1);
    double* current = terms + firstTerm(d);
    for (int k = 0; k < d; ++k)
    {
      current[k] = x * lower[k];
    }
    current[d] = y * lower[d - 1];
  }
}

} // namespace SurfaceScalars
