#include "GreensFunctions.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

namespace SurfaceScalars
{
namespace
{

using Matrix = Eigen::SparseMatrix<double>;

constexpr Index None = std::numeric_limits<Index>::max();
constexpr std::size_t Block = 16;       // columns solved for at once
constexpr std::size_t MostKnown = 1000; // beyond, what is no longer asked for is forgotten

/// S with the diagonal of the first vertex of each component doubled: positive definite.
std::shared_ptr<const Matrix> groundedStiffness(
  const Laplacian& laplacian, const std::vector<int>& components)
{
  auto result = std::make_shared<Matrix>(laplacian.stiffness);
  int next = 0;
  for (std::size_t vertex = 0; vertex < components.size(); ++vertex)
  {
    if (components[vertex] == next)
    {
      const auto row = static_cast<Eigen::Index>(vertex);
      result->coeffRef(row, row) *= 2.0;
      ++next;
    }
  }
  return result;
}

} // namespace

PoissonSolver::PoissonSolver(std::shared_ptr<const Laplacian> laplacian, const Execution& execution)
  : laplacian_(std::move(laplacian))
  , components_(connectedComponents(this->laplacian_->stiffness))
  , grounded_(groundedStiffness(*this->laplacian_, this->components_), execution)
{
}

Eigen::MatrixXd PoissonSolver::solve(const Eigen::MatrixXd& columns) const
{
  return this->grounded_.solveColumns(columns);
}

GreensFunctions::GreensFunctions(
  std::shared_ptr<const PoissonSolver> poisson, SmoothingEnergy energy, const Matrix& mass)
  : poisson_(std::move(poisson))
  , energy_(energy)
  , mass_(mass)
  , means_(this->poisson_->laplacian(), this->mass_ * Values::Ones(this->mass_.cols()))
  , positions_(static_cast<std::size_t>(this->mass_.rows()), None)
{
}

Eigen::MatrixXd GreensFunctions::functions(const Eigen::MatrixXd& columns) const
{
  Eigen::MatrixXd result = this->poisson_->solve(columns);
  if (this->energy_ == SmoothingEnergy::Biharmonic)
  {
    for (auto column : result.colwise())
    {
      const Values centered = column - this->means_.of(column);
      column = this->mass_ * centered;
    }
    result = this->poisson_->solve(result);
  }
  return result;
}

void GreensFunctions::add(const std::vector<Index>& added, const Execution& execution)
{
  const auto vertexCount = static_cast<Eigen::Index>(this->positions_.size());
  std::vector<Index> all = this->known_;
  all.insert(all.end(), added.begin(), added.end());
  Eigen::MatrixXd rows(all.size(), added.size()); // of all vertices, for the added ones
  for (std::size_t first = 0; first < added.size(); first += Block)
  {
    execution.report(static_cast<double>(first) / static_cast<double>(added.size()));
    const std::size_t count = std::min(Block, added.size() - first);
    Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(vertexCount, static_cast<Eigen::Index>(count));
    for (std::size_t i = 0; i < count; ++i)
    {
      columns(added[first + i], static_cast<Eigen::Index>(i)) = 1.0;
    }
    rows.middleCols(static_cast<Eigen::Index>(first), static_cast<Eigen::Index>(count)) =
      this->functions(columns)(all, Eigen::all);
  }
  // All at once, as an abort leaves what was known before.
  const Eigen::Index before = this->entries_.cols();
  this->entries_.conservativeResize(rows.rows(), rows.rows());
  this->entries_.rightCols(rows.cols()) = rows;
  this->entries_.bottomRows(rows.cols()) = rows.transpose();
  const Eigen::MatrixXd corner = rows.bottomRows(rows.cols());
  this->entries_.bottomRightCorner(rows.cols(), rows.cols()) = 0.5 * (corner + corner.transpose());
  for (std::size_t i = static_cast<std::size_t>(before); i < all.size(); ++i)
  {
    this->positions_[all[i]] = static_cast<Index>(i);
  }
  this->known_ = std::move(all);
}

Eigen::MatrixXd GreensFunctions::among(
  const std::vector<Index>& vertices, const Execution& execution)
{
  std::vector<Index> added;
  std::copy_if(vertices.begin(), vertices.end(), std::back_inserter(added),
    [&](Index vertex) { return this->positions_[vertex] == None; });
  if (this->known_.size() + added.size() > MostKnown)
  {
    std::fill(this->positions_.begin(), this->positions_.end(), None);
    this->known_.clear();
    this->entries_.resize(0, 0);
    added = vertices;
  }
  if (!added.empty())
  {
    this->add(added, execution);
  }
  std::vector<Index> positions;
  std::transform(vertices.begin(), vertices.end(), std::back_inserter(positions),
    [&](Index vertex) { return this->positions_[vertex]; });
  return this->entries_(positions, positions);
}

Values GreensFunctions::sum(const std::vector<Index>& vertices, const Values& lambda) const
{
  Values column = Values::Zero(static_cast<Eigen::Index>(this->positions_.size()));
  column(vertices) = lambda;
  return this->functions(column);
}

} // namespace SurfaceScalars
