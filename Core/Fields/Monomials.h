#pragma once

#include <type_traits>

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

/// Calls body with the degree, 1 to 4, as a constant: loops over terms are unrolled.
template <class Body>
auto withDegree(int degree, const Body& body)
{
  switch (degree)
  {
    case 1:
      return body(std::integral_constant<int, 1>());
    case 2:
      return body(std::integral_constant<int, 2>());
    case 3:
      return body(std::integral_constant<int, 3>());
    default:
      return body(std::integral_constant<int, 4>());
  }
}

} // namespace SurfaceScalars
