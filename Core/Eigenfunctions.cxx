#include "Error.h"
#include "LaplacianFunctions.h"
#include "NumberText.h"
#include "Require.h"
#include "SparseCholesky.h"

#include <Eigen/Eigenvalues>
#include <Spectra/SymEigsSolver.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

namespace SurfaceScalars
{
namespace
{

constexpr Eigen::Index MostDense = 300; // vertices for which a dense matrix is the simplest
constexpr int MostRestarts = 1000;
constexpr double Tolerance = 1e-10;    // of the inverse's eigenvalues, relative
constexpr double MostResidual = 1e-5;  // of S f - lambda M f, relative
constexpr double RelativeShift = 0.01; // in 1 / area, the order of the first eigenvalue

/// The functions that are constant on components, of which all eigenvalues are 0. Known beforehand,
/// they need not be searched for; that they are as many as components is no difficulty then.
///
/// Functions are scaled by the square roots of the mass, so that they are orthogonal as vectors.
class Constants
{
public:
  Constants(const Laplacian& laplacian, const Values& roots)
    : components_(connectedComponents(laplacian.stiffness))
    , roots_(roots)
    , masses_(Values::Zero(1 + *std::max_element(components_.begin(), components_.end())))
  {
    for (std::size_t i = 0; i < this->components_.size(); ++i)
    {
      this->masses_[this->components_[i]] += laplacian.mass[static_cast<Eigen::Index>(i)];
    }
  }

  Eigen::Index count() const { return this->masses_.size(); }

  void removeFrom(Eigen::Ref<Values> function) const
  {
    Values sums = Values::Zero(this->count());
    for (Eigen::Index i = 0; i < function.size(); ++i)
    {
      sums[this->component(i)] += this->roots_[i] * function[i];
    }
    sums = sums.cwiseQuotient(this->masses_);
    for (Eigen::Index i = 0; i < function.size(); ++i)
    {
      function[i] -= this->roots_[i] * sums[this->component(i)];
    }
  }

  /// Not scaled: a function of norm 1 that is not 0 on one component only.
  Values on(Eigen::Index component) const
  {
    Values result = Values::Zero(this->roots_.size());
    for (Eigen::Index i = 0; i < result.size(); ++i)
    {
      result[i] = this->component(i) == component ? 1.0 / std::sqrt(this->masses_[component]) : 0.0;
    }
    return result;
  }

private:
  int component(Eigen::Index vertex) const
  {
    return this->components_[static_cast<std::size_t>(vertex)];
  }

  std::vector<int> components_;
  const Values& roots_;
  Values masses_;
};

/// What Spectra iterates: R (S + s M)^-1 R with R^2 = M, beside the constants.
class ShiftedInverse
{
public:
  using Scalar = double;

  ShiftedInverse(const Laplacian& laplacian, const Values& roots, const Constants& constants,
    const Execution& execution)
    : roots_(roots)
    , constants_(constants)
    , execution_(execution.part(0.4, 1.0))
    , cholesky_(shifted(laplacian), execution.part(0.0, 0.4))
  {
  }

  Eigen::Index rows() const { return this->roots_.size(); }
  Eigen::Index cols() const { return this->roots_.size(); }

  // NOLINTNEXTLINE(readability-identifier-naming): Spectra's name
  void perform_op(const double* in, double* out) const
  {
    Values function = Eigen::Map<const Values>(in, this->rows());
    this->constants_.removeFrom(function);
    function =
      this->roots_.cwiseProduct(this->cholesky_.solve(this->roots_.cwiseProduct(function)));
    this->constants_.removeFrom(function);
    Eigen::Map<Values>(out, this->rows()) = function;
    ++this->solutions_;
    this->execution_.report(this->solutions_ / (this->solutions_ + 40.0)); // some 60 are usual
  }

private:
  static Eigen::SparseMatrix<double> shifted(const Laplacian& laplacian)
  {
    Eigen::SparseMatrix<double> result = laplacian.stiffness;
    result.diagonal() += (RelativeShift / laplacian.mass.sum()) * laplacian.mass;
    return result;
  }

  const Values& roots_;
  const Constants& constants_;
  Execution execution_;
  SparseCholesky cholesky_;
  mutable double solutions_ = 0.0;
};

Eigen::MatrixXd iterate(ShiftedInverse& inverse, Eigen::Index count, Eigen::Index dimension)
{
  const Eigen::Index basis = std::min(dimension, std::max(2 * count + 1, count + 20));
  Spectra::SymEigsSolver<ShiftedInverse> solver(inverse, count, basis);
  solver.init();
  const Eigen::Index found = solver.compute(
    Spectra::SortRule::LargestAlge, MostRestarts, Tolerance, Spectra::SortRule::LargestAlge);
  if (found < count)
  {
    throw Error("expected " + std::to_string(count) + " eigenfunctions, found that only " +
      std::to_string(found) + " converge. Choose fewer, or other weights.");
  }
  return solver.eigenvectors();
}

/// All at once, of a small matrix.
Eigen::MatrixXd solveDense(
  const Laplacian& laplacian, const Values& roots, const Constants& constants, Eigen::Index count)
{
  const Values inverse = roots.cwiseInverse();
  Eigen::MatrixXd matrix =
    inverse.asDiagonal() * Eigen::MatrixXd(laplacian.stiffness) * inverse.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
  Eigen::MatrixXd vectors = solver.eigenvectors().middleCols(constants.count(), count);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    constants.removeFrom(vectors.col(i));
  }
  return vectors;
}

/// The entry of greatest magnitude becomes positive.
void fixSign(Eigen::Ref<Values> function)
{
  Eigen::Index greatest = 0;
  function.cwiseAbs().maxCoeff(&greatest);
  if (function[greatest] < 0.0)
  {
    function = -function;
  }
}

void checkResiduals(const Laplacian& laplacian, const Eigenfunctions& result)
{
  for (Eigen::Index i = 0; i < result.eigenvalues.size(); ++i)
  {
    const double eigenvalue = result.eigenvalues[i];
    const Values function = result.functions.col(i);
    const Values residual =
      laplacian.stiffness * function - eigenvalue * laplacian.mass.cwiseProduct(function);
    const double norm = std::sqrt(residual.cwiseAbs2().cwiseQuotient(laplacian.mass).sum());
    if (!(norm <= MostResidual * result.eigenvalues.maxCoeff() || eigenvalue == 0.0))
    {
      throw Error("expected eigenfunctions to 1e-5, found a residual of " +
        textOf(norm / eigenvalue) + " in number " + std::to_string(i) +
        ". Choose fewer, or other weights.");
    }
  }
}

/// Those found, after the constants, by their Rayleigh quotients.
Eigenfunctions collect(const Laplacian& laplacian, const Values& roots, const Constants& constants,
  const Eigen::MatrixXd& found, Eigen::Index count)
{
  Eigenfunctions result = { Values::Zero(count), Eigen::MatrixXd(roots.size(), count) };
  const Eigen::Index constant = std::min(count, constants.count());
  for (Eigen::Index i = 0; i < constant; ++i)
  {
    result.functions.col(i) = constants.on(i);
  }
  const Eigen::MatrixXd functions = roots.cwiseInverse().asDiagonal() * found;
  Values quotients(found.cols());
  for (Eigen::Index i = 0; i < found.cols(); ++i)
  {
    quotients[i] = functions.col(i).dot(laplacian.stiffness * functions.col(i));
  }
  std::vector<Eigen::Index> order(static_cast<std::size_t>(found.cols()));
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
    [&](Eigen::Index a, Eigen::Index b) { return quotients[a] < quotients[b]; });
  for (Eigen::Index i = constant; i < count; ++i)
  {
    const Eigen::Index from = order[static_cast<std::size_t>(i - constant)];
    result.eigenvalues[i] = quotients[from];
    result.functions.col(i) = functions.col(from);
    fixSign(result.functions.col(i));
  }
  return result;
}

} // namespace

Eigenfunctions laplacianEigenfunctions(
  const Laplacian& laplacian, int count, const Execution& execution)
{
  const Eigen::Index vertices = laplacian.mass.size();
  require(laplacian.symmetric, "weights that are symmetric", "others (MeanValue 5)",
    "Choose Cotangent 3.");
  require(count >= 1 && count < vertices,
    "a number of eigenfunctions from 1 to " + std::to_string(vertices - 1) +
      ", fewer than there are points",
    std::to_string(count), "Choose an index in this range.");

  const Values roots = laplacian.mass.cwiseSqrt();
  const Constants constants(laplacian, roots);
  Eigen::MatrixXd found(vertices, 0);
  const Eigen::Index wanted = count - constants.count();
  if (wanted > 0 && vertices <= MostDense)
  {
    found = solveDense(laplacian, roots, constants, wanted);
  }
  else if (wanted > 0)
  {
    ShiftedInverse inverse(laplacian, roots, constants, execution);
    found = iterate(inverse, wanted, vertices - constants.count());
  }
  const Eigenfunctions result = collect(laplacian, roots, constants, found, count);
  checkResiduals(laplacian, result);
  execution.report(1.0);
  return result;
}

} // namespace SurfaceScalars
