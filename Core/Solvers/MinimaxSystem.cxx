#include "MinimaxSystem.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace SurfaceScalars
{
namespace
{

constexpr int Steps = 40;
constexpr int MostIdle = 25;        // steps
constexpr double WorthAStep = 1e-3; // of the largest error
constexpr double Relaxation = 1.6;  // 1.5 to 1.8 are usual
constexpr double PeakShare = 0.15;  // of the errors in sum
constexpr double Ridge = 1e-13;     // of the normal matrix, per unknown
constexpr Eigen::Index RowsPerBlock = 64;
constexpr Eigen::Index EquationsPerBlock = 1024;

/// Values cut off at the level above which there is this much of them in sum: the proximal map of
/// the largest one.
Values withoutPeaks(const Values& values, double peaks)
{
  Values sorted = values.cwiseAbs();
  std::sort(sorted.begin(), sorted.end(), std::greater<>());
  double sum = 0.0;
  double level = 0.0;
  for (Eigen::Index i = 0; i < sorted.size() && sorted[i] > level; ++i)
  {
    sum += sorted[i];
    level = std::max((sum - peaks) / static_cast<double>(i + 1), 0.0);
  }
  return values.cwiseMax(-level).cwiseMin(level);
}

Values withMore(const Values& values, const Values& more)
{
  Values result(values.size() + more.size());
  result << values, more;
  return result;
}

} // namespace

void MinimaxSystem::addToNormalMatrix(const Eigen::MatrixXd& transposed, const Execution& execution)
{
  const auto blocks =
    static_cast<std::size_t>((transposed.rows() + RowsPerBlock - 1) / RowsPerBlock);
  parallelForEach(blocks, execution,
    [&](std::size_t block, const Poll& poll)
    {
      const Eigen::Index first = static_cast<Eigen::Index>(block) * RowsPerBlock;
      const Eigen::Index rest = transposed.rows() - first;
      const Eigen::Index width = std::min(RowsPerBlock, rest);
      for (Eigen::Index begin = 0; begin < transposed.cols(); begin += EquationsPerBlock)
      {
        poll();
        const auto columns = transposed.bottomRows(rest).middleCols(
          begin, std::min(EquationsPerBlock, transposed.cols() - begin));
        this->normal_.block(first, first, rest, width).noalias() +=
          columns * columns.topRows(width).transpose();
      }
    });
}

void MinimaxSystem::add(Eigen::MatrixXd transposed, const Values& right, const Execution& execution)
{
  const Eigen::Index unknowns = transposed.rows();
  if (this->right_.size() == 0)
  {
    this->normal_ = Eigen::MatrixXd::Zero(unknowns, unknowns);
  }
  this->addToNormalMatrix(transposed, execution.part(0.0, 0.7));
  Eigen::MatrixXd matrix = this->normal_;
  const double largest = matrix.diagonal().maxCoeff();
  matrix.diagonal().array() +=
    Ridge * static_cast<double>(unknowns) * (largest > 0.0 ? largest : 1.0);
  this->factors_.compute(matrix, execution.part(0.7, 1.0));
  this->transposed_.push_back(std::move(transposed));
  this->right_ = withMore(this->right_, right);
}

/// b - B x
Values MinimaxSystem::errorsOf(const Values& unknowns, const Execution& execution) const
{
  Values products(this->right_.size());
  const auto share = [&](Eigen::Index equations)
  { return static_cast<double>(equations) / static_cast<double>(products.size()); };
  Eigen::Index done = 0;
  for (const Eigen::MatrixXd& equations : this->transposed_)
  {
    parallelFor(static_cast<std::size_t>(equations.cols()), EquationsPerBlock,
      execution.part(share(done), share(done + equations.cols())),
      [&](std::size_t begin, std::size_t end)
      {
        const auto first = static_cast<Eigen::Index>(begin);
        const auto count = static_cast<Eigen::Index>(end) - first;
        products.segment(done + first, count).noalias() =
          equations.middleCols(first, count).transpose() * unknowns;
      });
    done += equations.cols();
  }
  return this->right_ - products;
}

/// Least squares.
Values MinimaxSystem::closestTo(const Values& wanted, const Execution& execution) const
{
  Values result = Values::Zero(this->normal_.rows());
  parallelFor(static_cast<std::size_t>(result.size()), RowsPerBlock, execution,
    [&](std::size_t begin, std::size_t end)
    {
      const auto first = static_cast<Eigen::Index>(begin);
      const auto count = static_cast<Eigen::Index>(end) - first;
      Eigen::Index done = 0;
      for (const Eigen::MatrixXd& equations : this->transposed_)
      {
        result.segment(first, count).noalias() +=
          equations.middleRows(first, count) * wanted.segment(done, equations.cols());
        done += equations.cols();
      }
    });
  return this->factors_.solve(result);
}

Values MinimaxSystem::solve(const Execution& execution)
{
  const Execution atFirst = execution.part(0.0, 0.0);
  const Values before =
    std::exchange(this->best_, this->closestTo(this->right_, atFirst)); // none at first
  const Values errors = this->errorsOf(this->best_, atFirst);
  double least = errors.lpNorm<Eigen::Infinity>();
  const auto keepIfBetter = [&](const Values& unknowns, double largest)
  {
    if (largest < least)
    {
      least = largest;
      this->best_ = unknowns;
    }
  };
  if (before.size() > 0)
  {
    keepIfBetter(before, this->errorsOf(before, atFirst).lpNorm<Eigen::Infinity>());
  }
  const double peaks = PeakShare * errors.lpNorm<1>();
  const Eigen::Index more = errors.size() - this->cut_.size();
  this->errors_ = withMore(this->errors_, errors.tail(more));
  this->cut_ = withMore(this->cut_, errors.tail(more));
  this->multipliers_ = withMore(this->multipliers_, Values::Zero(more));
  int idle = 0;
  for (int step = 0; step < Steps && idle < MostIdle; ++step)
  {
    const Execution ofStep =
      execution.part(static_cast<double>(step) / Steps, static_cast<double>(step + 1) / Steps);
    const Values relaxed =
      Relaxation * this->errors_ + (1.0 - Relaxation) * this->cut_ - this->multipliers_;
    this->cut_ = withoutPeaks(relaxed, peaks);
    this->multipliers_ = this->cut_ - relaxed;
    const Values unknowns =
      this->closestTo(this->right_ - this->cut_ - this->multipliers_, ofStep.part(0.0, 0.5));
    this->errors_ = this->errorsOf(unknowns, ofStep.part(0.5, 1.0));
    const double largest = this->errors_.lpNorm<Eigen::Infinity>();
    idle = largest < (1.0 - WorthAStep) * least ? 0 : idle + 1;
    keepIfBetter(unknowns, largest);
  }
  return this->best_;
}

} // namespace SurfaceScalars
