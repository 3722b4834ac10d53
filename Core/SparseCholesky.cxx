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

struct SparseCholesky::Factors
{
  using Matrix = Eigen::SparseMatrix<double>;
#ifdef SURFACE_SCALARS_CHOLMOD
  Eigen::CholmodSupernodalLLT<Matrix> decomposition;
#else
  Eigen::SimplicialLLT<Matrix> decomposition;
#endif

  explicit Factors(const Matrix& matrix)
  {
#ifdef SURFACE_SCALARS_CHOLMOD
    this->decomposition.cholmod().print = 0; // nothing: errors are thrown
#endif
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

} // namespace SurfaceScalars
