#include "PointCloud.h"

#include "Error.h"
#include "MortonOrder.h"
#include "PointTree.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <string>

namespace SurfaceScalars
{
namespace
{

constexpr std::size_t Grain = 1024; // points per block of a parallel loop

/// The points in Morton order without duplicates, and the way there from the caller's order.
struct SortedPoints
{
  Points points;
  Vector3d origin;
  std::vector<Index> pointOfInput;
  std::vector<Index> inputOfPoint;
};

/// The center of the bounding box, which does not depend on the order of the points. @throws
/// InvalidInput if a coordinate is not finite
Vector3d boxCenter(const PointsRef& input, const Execution& execution)
{
  const auto count = static_cast<std::size_t>(input.cols());
  const std::size_t blocks = (count + Grain - 1) / Grain;
  Points low(3, static_cast<Eigen::Index>(blocks));
  Points high(3, static_cast<Eigen::Index>(blocks));
  parallelFor(count, Grain, execution,
    [&](std::size_t begin, std::size_t end)
    {
      const auto block =
        input.middleCols(static_cast<Eigen::Index>(begin), static_cast<Eigen::Index>(end - begin));
      if (!block.allFinite())
      {
        throw InvalidInput("finite coordinates", "NaN or infinity", "Leave such points out.");
      }
      const auto column = static_cast<Eigen::Index>(begin / Grain);
      low.col(column) = block.rowwise().minCoeff();
      high.col(column) = block.rowwise().maxCoeff();
    });
  const Vector3d lowest = low.rowwise().minCoeff();
  return lowest + 0.5 * (high.rowwise().maxCoeff() - lowest);
}

/// Numbers runs of equal points, in the order given, from 0: duplicates get the same number.
/// @returns how many runs
std::size_t numberRuns(const Points& points, const std::vector<Index>& order,
  std::vector<Index>& runs, const Execution& execution)
{
  const auto startsRun = [&](std::size_t i)
  { return i == 0 || points.col(order[i]) != points.col(order[i - 1]); };
  std::vector<std::size_t> before((order.size() + Grain - 1) / Grain + 1, 0);
  parallelFor(order.size(), Grain, execution.part(0.0, 0.5),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        before[begin / Grain + 1] += startsRun(i) ? 1 : 0;
      }
    });
  std::partial_sum(before.begin(), before.end(), before.begin());
  runs.resize(order.size());
  parallelFor(order.size(), Grain, execution.part(0.5, 1.0),
    [&](std::size_t begin, std::size_t end)
    {
      std::size_t started = before[begin / Grain];
      for (std::size_t i = begin; i < end; ++i)
      {
        started += startsRun(i) ? 1 : 0;
        runs[i] = static_cast<Index>(started - 1);
      }
    });
  return before.back();
}

SortedPoints sortPoints(const PointsRef& input, const Execution& execution)
{
  SortedPoints sorted;
  sorted.origin = boxCenter(input, execution.part(0.0, 0.05));
  // Centered before all else: what becomes equal by that is a duplicate too.
  const auto count = static_cast<std::size_t>(input.cols());
  Points centered(3, input.cols());
  parallelFor(count, Grain, execution.part(0.05, 0.1),
    [&](std::size_t begin, std::size_t end)
    {
      const auto first = static_cast<Eigen::Index>(begin);
      const auto size = static_cast<Eigen::Index>(end - begin);
      centered.middleCols(first, size) = input.middleCols(first, size).colwise() - sorted.origin;
    });
  const std::vector<Index> order = mortonOrder(centered, execution.part(0.1, 0.8));
  std::vector<Index> runs;
  const std::size_t distinct = numberRuns(centered, order, runs, execution.part(0.8, 0.9));

  sorted.points.resize(3, static_cast<Eigen::Index>(distinct));
  sorted.inputOfPoint.resize(distinct);
  sorted.pointOfInput.resize(count);
  parallelFor(count, Grain, execution.part(0.9, 1.0),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        sorted.pointOfInput[order[i]] = runs[i];
        if (i == 0 || runs[i] != runs[i - 1])
        {
          sorted.points.col(runs[i]) = centered.col(order[i]);
          sorted.inputOfPoint[runs[i]] = order[i];
        }
      }
    });
  return sorted;
}

} // namespace

struct PointCloud::Implementation
{
  SortedPoints sorted;
  PointTree tree;

  Implementation(const PointsRef& points, const Execution& execution)
    : sorted(sortPoints(points, execution.part(0.0, 0.5)))
    , tree(sorted.points, execution.part(0.5, 1.0))
  {
  }
};

PointCloud::PointCloud(const PointsRef& points, const Execution& execution)
{
  if (points.cols() < 1)
  {
    throw InvalidInput("points", "none", "Choose a larger input.");
  }
  if (points.cols() > std::numeric_limits<int>::max())
  {
    throw InvalidInput(
      "at most 2147483647 points", std::to_string(points.cols()), "Thin them out.");
  }
  this->implementation_ = std::make_unique<Implementation>(points, execution);
}

PointCloud::~PointCloud() = default;
PointCloud::PointCloud(PointCloud&&) noexcept = default;
PointCloud& PointCloud::operator=(PointCloud&&) noexcept = default;

const PointTree& PointCloud::tree() const
{
  return this->implementation_->tree;
}

Index PointCloud::pointCount() const
{
  return static_cast<Index>(this->implementation_->sorted.inputOfPoint.size());
}

const Points& PointCloud::points() const
{
  return this->implementation_->sorted.points;
}

const Vector3d& PointCloud::origin() const
{
  return this->implementation_->sorted.origin;
}

Index PointCloud::pointOfInput(std::size_t input) const
{
  return this->implementation_->sorted.pointOfInput[input];
}

std::size_t PointCloud::inputOfPoint(Index point) const
{
  return this->implementation_->sorted.inputOfPoint[point];
}

std::size_t PointCloud::inputCount() const
{
  return this->implementation_->sorted.pointOfInput.size();
}

Values PointCloud::average(const ValuesRef& values) const
{
  if (this->inputCount() == this->pointCount())
  {
    const auto& inputs = this->implementation_->sorted.inputOfPoint;
    return Values::NullaryExpr(this->pointCount(),
      [&](Eigen::Index i) { return values[inputs[static_cast<std::size_t>(i)]]; });
  }
  Values result = Values::Zero(this->pointCount());
  Eigen::VectorXi weights = Eigen::VectorXi::Zero(this->pointCount());
  for (std::size_t i = 0; i < this->inputCount(); ++i)
  {
    const Index point = this->pointOfInput(i);
    // A running mean: a sum of huge values could overflow, and equal values must stay what they
    // are.
    result[point] += (values[static_cast<Eigen::Index>(i)] - result[point]) / ++weights[point];
  }
  return result;
}

void PointCloud::nearest(const Vector3d& place, int count, Neighborhood& result) const
{
  const auto wanted = static_cast<std::size_t>(std::max(1, count));
  this->implementation_->tree.nearest(
    place, std::min<std::size_t>(wanted, this->pointCount()), result);
}

void PointCloud::within(const Vector3d& place, double radius, Neighborhood& result) const
{
  this->implementation_->tree.within(place, radius, result);
}

} // namespace SurfaceScalars
