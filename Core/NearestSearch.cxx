#include "NearestSearch.h"

#include "PointTree.h"

#include <algorithm>
#include <cmath>

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

// Along a curve, in reaches.
constexpr double Extent = 0.6;
constexpr double Ahead = 0.54; // so that the place itself is within

} // namespace

NearestSearch::NearestSearch(const PointCloud& cloud, std::size_t count)
  : cloud_(cloud)
  , count_(count)
  , coordinates_(MostCandidates * count, 3)
  , squaredDistances_(MostCandidates * count)
  , near_(MostCandidates * count)
  , sorted_(MostCandidates * count)
  , starts_(Classes * count + 2)
{
}

void NearestSearch::gather(const Vector3d& center, double extent)
{
  this->center_ = center;
  this->radius_ = extent + this->reach_;
  this->candidates_.clear();
  if (!this->cloud_.tree().gather(center, (1.0 + RoundingMargin) * this->radius_,
        MostCandidates * this->count_, this->candidates_))
  {
    this->candidates_.clear();
    this->radius_ = 0.0;
  }
  for (std::size_t i = 0; i < this->candidates_.size(); ++i)
  {
    this->coordinates_.row(static_cast<Eigen::Index>(i)) =
      this->cloud_.points().col(this->candidates_[i]).transpose();
  }
}

/// The radius around a place within which all points are candidates.
double NearestSearch::known(const Vector3d& place) const
{
  return this->radius_ - (place - this->center_).norm();
}

const std::vector<NearestSearch::Found>& NearestSearch::nearest(const Vector3d& place)
{
  if (!this->choose(place, std::min(this->known(place), this->reach_)))
  {
    this->searchTree(place);
  }
  const double distance = std::sqrt(this->sorted_[this->count_ - 1].squaredDistance);
  const double mean = this->meanDistance_ > 0.0 ? this->meanDistance_ : distance;
  // A stray point is not to make all candidates of those after it.
  this->meanDistance_ = mean + Smoothing * (std::min(distance, LargestGrowth * mean) - mean);
  const double spread = 1.0 / std::sqrt(static_cast<double>(this->count_));
  this->reach_ = (1.0 + ReachMargin * spread) * this->meanDistance_;
  return this->sorted_;
}

void NearestSearch::follow(const Vector3d& place, Neighborhood& result)
{
  if (this->known(place) < this->reach_)
  {
    // The next places are expected where the last step leads.
    const Vector3d step = place - this->lastPlace_;
    const double length = step.norm();
    const double ahead =
      length > 0.0 && length < this->reach_ ? Ahead * this->reach_ / length : 0.0;
    this->gather(place + ahead * step, Extent * this->reach_);
  }
  this->lastPlace_ = place;
  this->nearest(place);
  result.indices.resize(this->count_);
  result.squaredDistances.resize(this->count_);
  for (std::size_t i = 0; i < this->count_; ++i)
  {
    result.indices[i] = this->sorted_[i].index;
    result.squaredDistances[i] = this->sorted_[i].squaredDistance;
  }
}

/// Chooses among the candidates within reach. @returns whether these are enough
bool NearestSearch::choose(const Vector3d& place, double reach)
{
  const double limit = reach * reach;
  if (!(reach > 0.0) || !std::isnormal(static_cast<double>(Classes * this->count_) / limit))
  {
    return false;
  }
  const auto count = static_cast<Eigen::Index>(this->candidates_.size());
  const auto squared = [&](int axis)
  { return (this->coordinates_.col(axis).head(count) - place[axis]).square(); };
  this->squaredDistances_.head(count) = squared(0) + squared(1) + squared(2);
  std::size_t near = 0;
  for (Eigen::Index i = 0; i < count; ++i)
  {
    this->near_[near] = static_cast<std::size_t>(i);
    near += this->squaredDistances_[i] < limit ? 1 : 0; // no branch: it could not be foretold
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
void NearestSearch::sortNear(std::size_t count, double limit)
{
  const std::size_t classes = Classes * this->count_;
  const double scale = static_cast<double>(classes) / limit;
  const auto classOf = [&](std::size_t candidate)
  {
    return static_cast<std::size_t>(
      scale * this->squaredDistances_[static_cast<Eigen::Index>(candidate)]);
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
    const Found moved = this->sorted_[i];
    std::size_t j = i;
    for (; j > 0 && moved.squaredDistance < this->sorted_[j - 1].squaredDistance; --j)
    {
      this->sorted_[j] = this->sorted_[j - 1];
    }
    this->sorted_[j] = moved;
  }
}

void NearestSearch::searchTree(const Vector3d& place)
{
  this->cloud_.nearest(place, static_cast<int>(this->count_), this->found_);
  for (std::size_t i = 0; i < this->count_; ++i)
  {
    this->sorted_[i] = { this->found_.squaredDistances[i], this->found_.indices[i] };
  }
}

} // namespace SurfaceScalars
