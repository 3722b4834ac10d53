#include "BlockCholesky.h"

#include <algorithm>

namespace SurfaceScalars
{
namespace
{

constexpr Eigen::Index PanelWidth = 128;
constexpr Eigen::Index SmallMatrix = 512; // that Eigen factors in milliseconds

/// The largest sum of magnitudes in a column of the symmetric matrix.
double oneNorm(const Eigen::MatrixXd& lower)
{
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(lower.cols());
  for (Eigen::Index j = 0; j < lower.cols(); ++j)
  {
    const auto below = lower.col(j).tail(lower.rows() - j - 1).cwiseAbs();
    sums[j] += std::abs(lower(j, j)) + below.sum();
    sums.tail(lower.rows() - j - 1) += below;
  }
  return sums.maxCoeff();
}

} // namespace

void BlockCholesky::compute(
  const Eigen::Ref<const Eigen::MatrixXd>& matrix, const Execution& execution)
{
  if (matrix.rows() <= SmallMatrix)
  {
    Eigen::LLT<Eigen::MatrixXd>::compute(matrix);
    return;
  }
  this->m_matrix = matrix;
  this->m_l1_norm = oneNorm(this->m_matrix);
  this->m_isInitialized = true;
  this->m_info = Eigen::Success;
  const Eigen::Index count = matrix.rows();
  const auto left = [&](Eigen::Index begin)
  {
    const double fraction = 1.0 - static_cast<double>(begin) / static_cast<double>(count);
    return fraction * fraction * fraction; // of the work
  };
  for (Eigen::Index begin = 0; begin < count; begin += PanelWidth)
  {
    const double done = 1.0 - left(begin);
    const double next = 1.0 - left(std::min(count, begin + PanelWidth));
    if (!this->factorPanel(begin, execution.part(done, next)))
    {
      this->m_info = Eigen::NumericalIssue;
      return;
    }
  }
}

/// Finishes a panel of columns and takes it out of the matrix to its right.
bool BlockCholesky::factorPanel(Eigen::Index begin, const Execution& execution)
{
  Eigen::MatrixXd& matrix = this->m_matrix;
  const Eigen::Index width = std::min(PanelWidth, matrix.rows() - begin);
  const Eigen::Index rest = matrix.rows() - begin - width;
  Eigen::Ref<Eigen::MatrixXd> diagonal = matrix.block(begin, begin, width, width);
  if (Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>>(diagonal).info() != Eigen::Success)
  {
    return false;
  }
  auto below = matrix.block(begin + width, begin, rest, width);
  const auto count = static_cast<std::size_t>(rest);
  parallelFor(count, PanelWidth, execution.part(0.0, 0.2),
    [&](std::size_t first, std::size_t last)
    {
      auto rows =
        below.middleRows(static_cast<Eigen::Index>(first), static_cast<Eigen::Index>(last - first));
      diagonal.triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(rows);
    });
  auto corner = matrix.bottomRightCorner(rest, rest);
  parallelFor(count, PanelWidth, execution.part(0.2, 1.0),
    [&](std::size_t first, std::size_t last)
    {
      const auto column = static_cast<Eigen::Index>(first);
      const auto columns = static_cast<Eigen::Index>(last - first);
      corner.block(column, column, rest - column, columns).noalias() -=
        below.bottomRows(rest - column) * below.middleRows(column, columns).transpose();
    });
  return true;
}

} // namespace SurfaceScalars
