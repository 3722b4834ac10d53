#include "SparseCholesky.h"

#include "Background.h"
#include "Error.h"
#include "Require.h"

#ifdef SURFACE_SCALARS_CHOLMOD
#include <Eigen/CholmodSupport>
#else
#include <Eigen/SparseCholesky>
#endif

#include <limits>
#include <string>
#include <utility>

namespace SurfaceScalars
{

namespace
{

using Matrix = Eigen::SparseMatrix<double>;

#ifdef SURFACE_SCALARS_CHOLMOD
constexpr Eigen::Index MostOfMeshes = 8; // entries per row, of the Laplacian

class Decomposition : public Eigen::CholmodSupernodalLLT<Matrix>
{
public:
  explicit Decomposition(const Matrix& matrix)
  {
    this->cholmod().print = 0; // nothing: errors are thrown
    if (matrix.nonZeros() <= MostOfMeshes * matrix.cols())
    {
      this->cholmod().nmethods = 1; // nested dissection takes longer than it saves
      this->cholmod().method[0].ordering = CHOLMOD_AMD;
    }
  }

  RoundedFactor rounded() const
  {
    const cholmod_factor& factor = *this->m_cholmodFactor;
    const auto* order = static_cast<const int*>(factor.Perm);
    const auto* first = static_cast<const int*>(factor.super);
    const auto* rows = static_cast<const int*>(factor.s);
    const auto* rowsBegin = static_cast<const int*>(factor.pi);
    const auto* valuesBegin = static_cast<const int*>(factor.px);
    const auto* values = static_cast<const double*>(factor.x);
    const Eigen::Map<const Values> all(values, static_cast<Eigen::Index>(factor.xsize));
    RoundedFactor result({ order, order + factor.n }, all.lpNorm<Eigen::Infinity>(), factor.xsize);
    for (std::size_t block = 0; block < factor.nsuper; ++block)
    {
      result.append(first[block + 1] - first[block],
        { rows + rowsBegin[block], rows + rowsBegin[block + 1] }, values + valuesBegin[block]);
    }
    return result;
  }
};
#else
class Decomposition : public Eigen::SimplicialLLT<Matrix>
{
public:
  explicit Decomposition(const Matrix&) {}

  RoundedFactor rounded() const
  {
    const Matrix& factor = this->matrixL().nestedExpression();
    const auto& order = this->permutationPinv().indices();
    const Eigen::Map<const Values> all(factor.valuePtr(), factor.nonZeros());
    RoundedFactor result({ order.begin(), order.end() }, all.lpNorm<Eigen::Infinity>(),
      static_cast<std::size_t>(factor.nonZeros()));
    for (Eigen::Index column = 0; column < factor.cols(); ++column)
    {
      const int begin = factor.outerIndexPtr()[column];
      result.append(1,
        { factor.innerIndexPtr() + begin,
          factor.innerIndexPtr() + factor.outerIndexPtr()[column + 1] },
        factor.valuePtr() + begin);
    }
    return result;
  }
};
#endif

} // namespace

struct SparseCholesky::Factors
{
  Decomposition decomposition;

  explicit Factors(const Matrix& matrix)
    : decomposition(matrix)
  {
    this->decomposition.analyzePattern(matrix);
    this->factor(matrix);
  }

  void factor(const Matrix& matrix)
  {
    this->decomposition.factorize(matrix);
    if (this->decomposition.info() != Eigen::Success)
    {
      throw Error("expected a positive definite matrix, found one of " +
        std::to_string(matrix.cols()) + " rows that cannot be factored. Choose other weights.");
    }
  }
};

SparseCholesky::SparseCholesky(
  const std::shared_ptr<const Eigen::SparseMatrix<double>>& matrix, const Execution& execution)
{
  // The factors have up to some ten times as many entries, counted by integers of the same type.
  constexpr Eigen::Index most = std::numeric_limits<int>::max() / 16;
  require(matrix->nonZeros() <= most, "at most " + std::to_string(most) + " links between points",
    std::to_string(matrix->nonZeros()), "Choose fewer neighbors or thin the points.");
  this->factors_ =
    inBackground(execution, [matrix]() { return std::make_shared<Factors>(*matrix); });
}

void SparseCholesky::refactor(
  const std::shared_ptr<const Eigen::SparseMatrix<double>>& matrix, const Execution& execution)
{
  // Not ours meanwhile: after an abort the work goes on, and nobody may use them.
  this->factors_ = inBackground(execution,
    [matrix, factors = std::exchange(this->factors_, nullptr)]()
    {
      factors->factor(*matrix);
      return factors;
    });
}

Values SparseCholesky::solve(const ValuesRef& rightSide) const
{
  return this->factors_->decomposition.solve(rightSide);
}

Eigen::MatrixXd SparseCholesky::solveColumns(const Eigen::MatrixXd& rightSides) const
{
  return this->factors_->decomposition.solve(rightSides);
}

RoundedFactor SparseCholesky::rounded() const
{
  return this->factors_->decomposition.rounded();
}

} // namespace SurfaceScalars
