#include "ComponentMeans.h"
#include "Error.h"
#include "LaplacianFunctions.h"
#include "NumberText.h"
#include "Require.h"
#include "SparseCholesky.h"

#include <Eigen/Eigenvalues>
#include <Spectra/SymEigsSolver.h>

#include <algorithm>
#include <cmath>
#include <memory>
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

/// Functions beside the constants, which are known beforehand: they need not be searched for, and
/// that there are as many as components is no difficulty then.
///
/// Functions f are scaled to R f with R^2 = M, so that they are orthogonal as vectors.
class Complement
{
public:
  explicit Complement(const Laplacian& laplacian)
    : roots_(laplacian.mass.cwiseSqrt())
    , constants_(laplacian)
  {
  }

  const Values& roots() const { return this->roots_; }
  const ComponentMeans& constants() const { return this->constants_; }

  Values project(const Values& scaled) const
  {
    const Values means = this->constants_.of(scaled.cwiseQuotient(this->roots_));
    return scaled - this->roots_.cwiseProduct(means);
  }

private:
  Values roots_;
  ComponentMeans constants_;
};

/// What Spectra iterates: c R (S + s M)^-1 R with c so large that all eigenvalues, c / (lambda +
/// s), are of the order of 1 or above in any unit of length: Spectra takes what is below 1e-11 for
/// converged.
class ShiftedInverse
{
public:
  using Scalar = double;

  ShiftedInverse(
    const Laplacian& laplacian, const Complement& complement, const Execution& execution)
    : complement_(complement)
    , execution_(execution.part(0.4, 1.0))
    , scale_(laplacian.stiffness.diagonal().cwiseQuotient(laplacian.mass).maxCoeff())
    , cholesky_(shifted(laplacian), execution.part(0.0, 0.4))
  {
  }

  Eigen::Index rows() const { return this->complement_.roots().size(); }
  Eigen::Index cols() const { return this->rows(); }

  // NOLINTNEXTLINE(readability-identifier-naming): Spectra's name
  void perform_op(const double* in, double* out) const
  {
    const Values& roots = this->complement_.roots();
    const Values function = this->complement_.project(Eigen::Map<const Values>(in, this->rows()));
    Eigen::Map<Values>(out, this->rows()) = this->complement_.project(
      roots.cwiseProduct(this->cholesky_.solve(this->scale_ * roots.cwiseProduct(function))));
    ++this->solutions_;
    this->execution_.report(this->solutions_ / (this->solutions_ + 40.0)); // some 60 are usual
  }

private:
  static std::shared_ptr<const Eigen::SparseMatrix<double>> shifted(const Laplacian& laplacian)
  {
    auto result = std::make_shared<Eigen::SparseMatrix<double>>(laplacian.stiffness);
    result->diagonal() += (RelativeShift / laplacian.mass.sum()) * laplacian.mass;
    return result;
  }

  const Complement& complement_;
  Execution execution_;
  double scale_;
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
  const Laplacian& laplacian, const Complement& complement, Eigen::Index count)
{
  const Values inverse = complement.roots().cwiseInverse();
  const Eigen::MatrixXd matrix =
    inverse.asDiagonal() * Eigen::MatrixXd(laplacian.stiffness) * inverse.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
  Eigen::MatrixXd result = solver.eigenvectors().middleCols(complement.constants().count(), count);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    result.col(i) = complement.project(result.col(i));
  }
  return result;
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
Eigenfunctions collect(const Laplacian& laplacian, const Complement& complement,
  const Eigen::MatrixXd& found, Eigen::Index count)
{
  Eigenfunctions result = { Values::Zero(count), Eigen::MatrixXd(laplacian.mass.size(), count) };
  const Eigen::Index constant = count - found.cols();
  for (Eigen::Index i = 0; i < constant; ++i)
  {
    result.functions.col(i) = complement.constants().unit(i);
  }
  const Eigen::MatrixXd functions = complement.roots().cwiseInverse().asDiagonal() * found;
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

  const Complement complement(laplacian);
  const Eigen::Index wanted = count - complement.constants().count();
  Eigen::MatrixXd found(vertices, 0);
  if (wanted > 0 && vertices <= MostDense)
  {
    found = solveDense(laplacian, complement, wanted);
  }
  else if (wanted > 0)
  {
    ShiftedInverse inverse(laplacian, complement, execution);
    found = iterate(inverse, wanted, vertices - complement.constants().count());
  }
  Eigenfunctions result = collect(laplacian, complement, found, count);
  checkResiduals(laplacian, result);
  execution.report(1.0);
  return result;
}

} // namespace SurfaceScalars
