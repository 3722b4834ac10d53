#include "NearestSearch.h"

#include "PointTree.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace SurfaceScalars
{
namespace
{

// Multiples of the number to find; measured.
constexpr std::size_t MostCandidates = 16; // on a surface 4 to 8 are enough
constexpr std::size_t Classes = 4;

constexpr double Smoothing = 0.125; // weight of the last place in the mean distance
constexpr double LargestGrowth = 2.0;
constexpr double ReachMargin = 1.2; // over the mean, in roots of the number: so little it varies
constexpr double RoundingMargin = 1e-12;

// Of places that share what is gathered; measured.
constexpr Eigen::Index LongestRun = 24;
constexpr double RunExtent = 2.0; // from the first of them, in reaches

// Along a curve, in reaches.
constexpr double Extent = 0.6;
constexpr double Ahead = 0.54; // so that the place itself is within

bool isBefore(const NearestSearch::Found& a, const NearestSearch::Found& b)
{
  return a.squaredDistance < b.squaredDistance ||
    (a.squaredDistance == b.squaredDistance && a.index < b.index);
}

} // namespace

NearestSearch::NearestSearch(const PointCloud& cloud, std::size_t count, double radius)
  : cloud_(cloud)
  , count_(count)
  , givenRadius_(radius)
  , reach_(radius)
  , starts_(Classes * count + 2)
{
}

Eigen::Index NearestSearch::expect(const PointsRef& places)
{
  const Eigen::Index most = std::min(places.cols(), LongestRun);
  Eigen::Index length = 1; // where places jump, fewer
  while (length < most && (places.col(length) - places.col(0)).norm() <= RunExtent * this->reach_)
  {
    ++length;
  }
  const auto run = places.leftCols(length);
  const Vector3d center = 0.5 * (run.rowwise().minCoeff() + run.rowwise().maxCoeff());
  this->gather(center, std::sqrt((run.colwise() - center).colwise().squaredNorm().maxCoeff()));
  return length;
}

/// What places up to `extent` from `center` need.
void NearestSearch::gather(const Vector3d& center, double extent)
{
  this->center_ = center;
  this->extent_ = (1.0 + RoundingMargin) * extent;
  this->radius_ = this->extent_ + this->reach_;
  this->candidates_.clear();
  const bool isCounted = !(this->givenRadius_ > 0.0);
  const std::size_t most =
    isCounted ? MostCandidates * this->count_ : std::numeric_limits<std::size_t>::max();
  if (!this->cloud_.tree().gather(
        center, (1.0 + RoundingMargin) * this->radius_, most, this->candidates_))
  {
    this->candidates_.clear();
    this->radius_ = 0.0;
  }
  if (!isCounted)
  {
    std::sort(this->candidates_.begin(), this->candidates_.end());
  }
  const auto count = static_cast<Eigen::Index>(this->candidates_.size());
  if (this->squaredDistances_.size() < count)
  {
    this->coordinates_.resize(2 * count, 3);
    this->squaredDistances_.resize(2 * count);
    this->near_.resize(2 * this->candidates_.size());
  }
  const Points& points = this->cloud_.points();
  for (Eigen::Index i = 0; i < count; ++i)
  {
    this->coordinates_.row(i) =
      points.col(this->candidates_[static_cast<std::size_t>(i)]).transpose();
  }
}

/// The next places are expected where the last step leads.
void NearestSearch::gatherAhead(const Vector3d& place)
{
  const Vector3d step = place - this->lastPlace_;
  const double length = step.norm();
  const double ahead = length > 0.0 && length < this->reach_ ? Ahead * this->reach_ / length : 0.0;
  this->gather(place + ahead * step, Extent * this->reach_);
}

const std::vector<NearestSearch::Found>& NearestSearch::find(const Vector3d& place)
{
  if (!((place - this->center_).norm() <= this->extent_))
  {
    this->gatherAhead(place);
  }
  this->lastPlace_ = place;
  this->measure(place);
  if (this->givenRadius_ > 0.0)
  {
    this->findWithin();
    return this->found_;
  }
  const double known = this->radius_ - (place - this->center_).norm();
  if (!this->choose(std::min(known, this->reach_)))
  {
    this->searchTree(place);
  }
  this->learnReach();
  return this->found_;
}

double NearestSearch::radius() const
{
  return this->givenRadius_ > 0.0 ? this->givenRadius_
                                  : std::sqrt(this->found_.back().squaredDistance);
}

void NearestSearch::learnReach()
{
  const double distance = this->radius();
  const double mean = this->meanDistance_ > 0.0 ? this->meanDistance_ : distance;
  // A stray point is not to make all candidates of those after it.
  this->meanDistance_ = mean + Smoothing * (std::min(distance, LargestGrowth * mean) - mean);
  const double spread = 1.0 / std::sqrt(static_cast<double>(this->count_));
  this->reach_ = (1.0 + ReachMargin * spread) * this->meanDistance_;
}

void NearestSearch::measure(const Vector3d& place)
{
  const auto count = static_cast<Eigen::Index>(this->candidates_.size());
  const auto squared = [&](int axis)
  { return (this->coordinates_.col(axis).head(count) - place[axis]).square(); };
  this->squaredDistances_.head(count) = squared(0) + squared(1) + squared(2);
}

void NearestSearch::findWithin()
{
  const double limit = this->givenRadius_ * this->givenRadius_;
  this->found_.resize(this->candidates_.size());
  std::size_t found = 0;
  for (std::size_t i = 0; i < this->candidates_.size(); ++i)
  {
    const double squared = this->squaredDistances_[static_cast<Eigen::Index>(i)];
    this->found_[found] = { squared, this->candidates_[i] };
    found += squared < limit ? 1 : 0; // no branch: it could not be foretold
  }
  this->found_.resize(found);
}

/// Chooses among the candidates within reach. @returns whether these are enough
bool NearestSearch::choose(double reach)
{
  const double limit = reach * reach;
  if (!(reach > 0.0) || !std::isnormal(static_cast<double>(Classes * this->count_) / limit))
  {
    return false;
  }
  std::size_t near = 0;
  for (std::size_t i = 0; i < this->candidates_.size(); ++i)
  {
    this->near_[near] = i;
    near += this->squaredDistances_[static_cast<Eigen::Index>(i)] < limit ? 1 : 0;
  }
  if (near < this->count_)
  {
    return false;
  }
  this->sortNear(near, limit);
  return true;
}

/// On a surface squared distances are spread evenly: counting sorts them into classes of about one
/// each, with little left to insertion.
void NearestSearch::sortNear(std::size_t near, double limit)
{
  const std::size_t classes = Classes * this->count_;
  const double scale = static_cast<double>(classes) / limit;
  const auto classOf = [&](std::size_t candidate)
  {
    return static_cast<std::size_t>(
      scale * this->squaredDistances_[static_cast<Eigen::Index>(candidate)]);
  };
  this->found_.resize(near);
  std::fill(this->starts_.begin(), this->starts_.end(), 0);
  for (std::size_t i = 0; i < near; ++i)
  {
    ++this->starts_[classOf(this->near_[i]) + 1];
  }
  for (std::size_t i = 0; i < classes; ++i)
  {
    this->starts_[i + 1] += this->starts_[i];
  }
  for (std::size_t i = 0; i < near; ++i)
  {
    const std::size_t candidate = this->near_[i];
    this->found_[this->starts_[classOf(candidate)]++] = {
      this->squaredDistances_[static_cast<Eigen::Index>(candidate)], this->candidates_[candidate]
    };
  }
  for (std::size_t i = 1; i < near; ++i)
  {
    const Found moved = this->found_[i];
    std::size_t j = i;
    for (; j > 0 && isBefore(moved, this->found_[j - 1]); --j)
    {
      this->found_[j] = this->found_[j - 1];
    }
    this->found_[j] = moved;
  }
  this->found_.resize(this->count_);
}

void NearestSearch::searchTree(const Vector3d& place)
{
  const std::size_t enough = std::min<std::size_t>(this->count_ + 1, this->cloud_.pointCount());
  this->cloud_.nearest(place, static_cast<int>(enough), this->inTree_);
  const double last = this->inTree_.squaredDistances[this->count_ - 1];
  if (last == this->inTree_.squaredDistances.back() && last > 0.0)
  {
    // Equally far ones: all of them, to take the first.
    this->cloud_.within(place, (1.0 + RoundingMargin) * std::sqrt(last), this->inTree_);
  }
  this->found_.clear();
  for (std::size_t i = 0; i < this->inTree_.indices.size(); ++i)
  {
    this->found_.push_back({ this->inTree_.squaredDistances[i], this->inTree_.indices[i] });
  }
  std::sort(this->found_.begin(), this->found_.end(), isBefore);
  this->found_.resize(this->count_);
}

} // namespace SurfaceScalars
