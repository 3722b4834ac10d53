#include "ComponentMeans.h"
#include "EllipticSolver.h"
#include "LaplacianFunctions.h"
#include "NumberText.h"
#include "Require.h"

#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace SurfaceScalars
{
namespace
{

constexpr int Degree = 10;         // of r below
constexpr double Divisions = 11.0; // of the time, by the step of G: the best for the degree
constexpr int Solutions = Degree + 2;

using Coefficients = std::array<double, Degree + 1>;

/// exp(-t lambda) as a function of g = 1 / (1 + t lambda / Divisions), divided by g^2.
double decay(double g)
{
  return std::exp(-Divisions * (1.0 / g - 1.0)) / (g * g);
}

/// r(g) = sum c_k T_k(2 g - 1) interpolates decay(g) at Chebyshev's points, and is 1 at 1.
Coefficients decayCoefficients()
{
  Coefficients result{};
  double sum = 0.0;
  for (int k = 0; k <= Degree; ++k)
  {
    for (int i = 0; i <= Degree; ++i)
    {
      const double angle = Pi * (i + 0.5) / (Degree + 1);
      result[k] += decay((std::cos(angle) + 1.0) / 2.0) * std::cos(k * angle);
    }
    result[k] *= (k == 0 ? 1.0 : 2.0) / (Degree + 1);
    sum += result[k];
  }
  for (double& coefficient : result)
  {
    coefficient /= sum;
  }
  return result;
}

/// G = (M + t / Divisions S)^-1 M: an implicit Euler step.
class EulerStep
{
public:
  EulerStep(const Laplacian& laplacian, double time, const Execution& execution)
    : mass_(laplacian.mass)
    , execution_(execution.part(0.2, 1.0))
    , solver_(matrix(laplacian, time), laplacian.symmetric, execution.part(0.0, 0.2))
  {
  }

  Values of(const Values& function)
  {
    const Execution part = this->execution_.part(
      this->solved_ / static_cast<double>(Solutions), (this->solved_ + 1) / double(Solutions));
    ++this->solved_;
    return this->solver_.solve(this->mass_.cwiseProduct(function), part);
  }

private:
  static RowMatrix matrix(const Laplacian& laplacian, double time)
  {
    RowMatrix result = laplacian.stiffness;
    result *= time / Divisions;
    result.diagonal() += laplacian.mass;
    return result;
  }

  const Values& mass_;
  Execution execution_;
  EllipticSolver solver_;
  int solved_ = 0;
};

/// G^2 r(G) f, by the recurrence of Chebyshev's polynomials.
Values decayed(EulerStep& step, const Values& heat)
{
  const Coefficients coefficients = decayCoefficients();
  Values last = step.of(step.of(heat)); // T_0
  Values current = 2.0 * step.of(last) - last;
  Values result = coefficients[0] * last + coefficients[1] * current;
  for (int k = 2; k <= Degree; ++k)
  {
    last = 4.0 * step.of(current) - 2.0 * current - last;
    std::swap(last, current);
    result += coefficients[k] * current;
  }
  return result;
}

} // namespace

Values diffuse(
  const Laplacian& laplacian, const ValuesRef& heat, double time, const Execution& execution)
{
  require(std::isfinite(time) && time > 0.0, "a finite time above 0", textOf(time),
    "Choose the square of the length over which heat is to spread.");
  require(heat.size() == laplacian.mass.size(),
    "heat at each of " + std::to_string(laplacian.mass.size()) + " vertices",
    std::to_string(heat.size()) + " values", "Choose another array.");
  require(heat.allFinite(), "finite heat", "a value that is not", "Remove such points.");

  const ComponentMeans means(laplacian);
  const Values constant = means.of(heat);
  EulerStep step(laplacian, time, execution);
  Values change = decayed(step, heat - constant);
  if (laplacian.symmetric)
  {
    change -= means.of(change); // 0 but for the errors of solutions
  }
  return constant + change;
}

} // namespace SurfaceScalars
