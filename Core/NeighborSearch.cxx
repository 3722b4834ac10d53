#include "NeighborSearch.h"

#include <algorithm>
#include <cmath>

namespace SurfaceScalars
{
namespace
{

// All measured; counts are multiples of the number of neighbors.
constexpr double LargestRun = 1.5;
constexpr double RunExtent = 2.0;          // from its first point, in reaches
constexpr double ReachMargin = 1.3;        // over the mean of the run before
constexpr std::size_t MostCandidates = 32; // a surface has 6 to 8
constexpr std::size_t Classes = 4;

} // namespace

NeighborSearch::NeighborSearch(const Points& points, const PointTree& tree, std::size_t count)
  : points_(points)
  , tree_(tree)
  , count_(count)
  , coordinates_(MostCandidates * count, 3)
  , squaredDistances_(MostCandidates * count)
  , near_(MostCandidates * count)
  , sorted_(MostCandidates * count)
  , starts_(Classes * count + 2)
{
}

void NeighborSearch::find(Index begin, Index end, Index* neighbors)
{
  while (begin < end)
  {
    const Index endOfRun = this->endOfRun(begin, end);
    const bool gathered = this->gatherAround(begin, endOfRun);
    double distances = 0.0;
    for (Index point = begin; point < endOfRun; ++point, neighbors += this->count_)
    {
      if (!gathered || !this->choose(point, neighbors))
      {
        this->searchTree(point, neighbors);
      }
      const Index last = neighbors[this->count_ - 1];
      distances += (this->points_.col(last) - this->points_.col(point)).norm();
    }
    this->reach_ = ReachMargin * distances / (endOfRun - begin);
    begin = endOfRun;
  }
}

/// Where the points jump, a run ends early.
Index NeighborSearch::endOfRun(Index begin, Index end) const
{
  const auto largest = static_cast<Index>(LargestRun * static_cast<double>(this->count_));
  const Index last = begin + std::min(end - begin, std::max<Index>(1, largest));
  const double extent = RunExtent * this->reach_;
  Index i = begin + 1;
  while (i < last && (this->points_.col(i) - this->points_.col(begin)).norm() <= extent)
  {
    ++i;
  }
  return i;
}

/// Makes all points within reach of a run's points candidates. @returns false if the reach is
/// unknown or there are too many
bool NeighborSearch::gatherAround(Index begin, Index end)
{
  const auto run = this->points_.middleCols(begin, end - begin);
  const Vector3d center = 0.5 * (run.rowwise().minCoeff() + run.rowwise().maxCoeff());
  const double extent = std::sqrt((run.colwise() - center).colwise().squaredNorm().maxCoeff());
  const double margin = 1e-12; // for rounding
  this->classesPerArea_ =
    static_cast<double>(Classes * this->count_) / (this->reach_ * this->reach_);
  this->candidates_.clear();
  if (!std::isnormal(this->classesPerArea_) ||
    !this->tree_.gather(center, (1.0 + margin) * (extent + this->reach_),
      MostCandidates * this->count_, this->candidates_))
  {
    return false;
  }
  for (std::size_t i = 0; i < this->candidates_.size(); ++i)
  {
    this->coordinates_.row(static_cast<Eigen::Index>(i)) =
      this->points_.col(this->candidates_[i]).transpose();
  }
  return true;
}

/// Chooses a point's neighbors among the candidates. @returns whether enough are within reach, as
/// only those are known to be all there are
bool NeighborSearch::choose(Index point, Index* neighbors)
{
  const auto count = static_cast<Eigen::Index>(this->candidates_.size());
  const Vector3d place = this->points_.col(point);
  const auto squared = [&](int axis)
  { return (this->coordinates_.col(axis).head(count) - place[axis]).square(); };
  this->squaredDistances_.head(count) = squared(0) + squared(1) + squared(2);

  const double limit = this->reach_ * this->reach_;
  std::size_t near = 0;
  for (Eigen::Index i = 0; i < count; ++i)
  {
    this->near_[near] = static_cast<std::size_t>(i);
    near += this->squaredDistances_[i] < limit ? 1 : 0; // no branch: it could not be foretold
  }
  if (near <= this->count_)
  {
    return false;
  }
  this->sortNear(near);
  for (std::size_t i = 0, chosen = 0; chosen < this->count_; ++i)
  {
    neighbors[chosen] = this->sorted_[i].index;
    chosen += this->sorted_[i].index != point ? 1 : 0;
  }
  return true;
}

/// On a surface squared distances are spread evenly: counting sorts them into classes of about one
/// each, with little left to insertion.
void NeighborSearch::sortNear(std::size_t count)
{
  const std::size_t classes = Classes * this->count_;
  const auto classOf = [&](std::size_t candidate)
  {
    return static_cast<std::size_t>(
      this->classesPerArea_ * this->squaredDistances_[static_cast<Eigen::Index>(candidate)]);
  };
  std::fill(this->starts_.begin(), this->starts_.end(), 0);
  for (std::size_t i = 0; i < count; ++i)
  {
    ++this->starts_[classOf(this->near_[i]) + 1];
  }
  for (std::size_t i = 0; i < classes; ++i)
  {
    this->starts_[i + 1] += this->starts_[i];
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::size_t candidate = this->near_[i];
    this->sorted_[this->starts_[classOf(candidate)]++] = {
      this->squaredDistances_[static_cast<Eigen::Index>(candidate)], this->candidates_[candidate]
    };
  }
  for (std::size_t i = 1; i < count; ++i)
  {
    const Candidate moved = this->sorted_[i];
    std::size_t j = i;
    for (; j > 0 && moved.squaredDistance < this->sorted_[j - 1].squaredDistance; --j)
    {
      this->sorted_[j] = this->sorted_[j - 1];
    }
    this->sorted_[j] = moved;
  }
}

void NeighborSearch::searchTree(Index point, Index* neighbors)
{
  this->tree_.nearest(this->points_.col(point), this->count_ + 1, this->found_);
  std::copy(this->found_.indices.begin() + 1, this->found_.indices.end(), neighbors);
}

} // namespace SurfaceScalars
