#include "MinimaxSystem.h"
#include "Sampling.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace SurfaceScalars
{
namespace
{

using Truth::Random;

struct Equations
{
  Eigen::MatrixXd transposed;
  Values right;

  Values errors(const Values& unknowns) const
  {
    return (this->transposed.transpose() * unknowns - this->right).cwiseAbs();
  }
};

/// x^k for k below the degree, at as many places of [-1, 1], against x^degree.
Equations powers(int degree, int count)
{
  Equations result{ Eigen::MatrixXd(degree, count), Values(count) };
  for (int i = 0; i < count; ++i)
  {
    const double x = 2.0 * i / (count - 1) - 1.0;
    for (int k = 0; k < degree; ++k)
    {
      result.transposed(k, i) = std::pow(x, k);
    }
    result.right[i] = std::pow(x, degree);
  }
  return result;
}

Equations randomEquations(Eigen::Index unknowns, Eigen::Index count, std::uint64_t seed)
{
  Random random(seed);
  Equations result{ Eigen::MatrixXd(unknowns, count), Values(count) };
  for (Eigen::Index i = 0; i < count; ++i)
  {
    for (Eigen::Index k = 0; k < unknowns; ++k)
    {
      result.transposed(k, i) = random.normal();
    }
    result.right[i] = random.normal();
  }
  return result;
}

/// The least largest error of two unknowns: that of the three equations that are worst together
/// (de la Vallee-Poussin). The errors of three have one linear dependence w, and the largest of
/// them is at least |w . b| / |w|_1, which is attained.
double leastByTriples(const Equations& equations)
{
  double worst = 0.0;
  const Eigen::Index count = equations.right.size();
  for (Eigen::Index i = 0; i < count; ++i)
  {
    for (Eigen::Index j = 0; j < i; ++j)
    {
      for (Eigen::Index k = 0; k < j; ++k)
      {
        const Eigen::Vector3i triple(i, j, k);
        const Eigen::Matrix<double, 2, 3> rows = equations.transposed(Eigen::all, triple);
        const Eigen::Vector3d w = rows.row(0).cross(rows.row(1)).transpose();
        worst = std::max(worst, std::abs(w.dot(equations.right(triple))) / w.template lpNorm<1>());
      }
    }
  }
  return worst;
}

// Of all monic polynomials, Chebyshev's are least on [-1, 1]: 2^(1 - degree).
TEST(MinimaxSystem, findsChebyshevsPolynomials)
{
  for (const int degree : { 1, 2, 4, 6 })
  {
    const Equations equations = powers(degree, 1001);
    MinimaxSystem system;
    system.add(equations.transposed, equations.right);
    const double largest = equations.errors(system.solve()).maxCoeff();
    EXPECT_GE(largest, std::pow(2.0, 1 - degree) * (1.0 - 1e-4)); // places are not all of [-1, 1]
    EXPECT_LE(largest, std::pow(2.0, 1 - degree) * 1.02) << degree;
  }
}

// Nearly as small as three equations by themselves allow, in any scale, and the same to the bit
// with any number of threads.
TEST(MinimaxSystem, isNearlyBest)
{
  for (const int seed : { 1, 2, 3, 4, 5, 6, 7, 8 })
  {
    Equations equations = randomEquations(2, 40, static_cast<std::uint64_t>(seed));
    equations.right *= std::pow(10.0, 3 * seed - 12);
    MinimaxSystem system;
    system.add(equations.transposed, equations.right, { 1, {} });
    const Values solution = system.solve({ 1, {} });
    const double least = leastByTriples(equations);
    EXPECT_GE(equations.errors(solution).maxCoeff(), least * (1.0 - 1e-12));
    EXPECT_LE(equations.errors(solution).maxCoeff(), least * 1.05) << seed;
    MinimaxSystem again;
    again.add(equations.transposed, equations.right, { 3, {} });
    EXPECT_EQ(again.solve({ 3, {} }), solution);
  }
}

// More equations later are as good as all at once.
TEST(MinimaxSystem, takesMoreEquations)
{
  const Equations equations = randomEquations(2, 60, 11);
  MinimaxSystem system;
  for (const Eigen::Index begin : { 0, 20, 40 })
  {
    system.add(equations.transposed.middleCols(begin, 20), equations.right.segment(begin, 20));
    const Equations some{ equations.transposed.leftCols(begin + 20),
      equations.right.head(begin + 20) };
    EXPECT_LE(some.errors(system.solve()).maxCoeff(), 1.05 * leastByTriples(some)) << begin;
  }
}

// What can be solved exactly is.
TEST(MinimaxSystem, solvesWhatIsConsistent)
{
  Equations equations = randomEquations(5, 50, 3);
  const Values unknowns = Values::LinSpaced(5, -2.0, 3.0);
  equations.right = equations.transposed.transpose() * unknowns;
  MinimaxSystem system;
  system.add(equations.transposed, equations.right);
  EXPECT_LE((system.solve() - unknowns).lpNorm<Eigen::Infinity>(), 1e-11);
  equations.right.setZero();
  MinimaxSystem zero;
  zero.add(equations.transposed, equations.right);
  EXPECT_EQ(zero.solve(), Values::Zero(5));
}

} // namespace
} // namespace SurfaceScalars
