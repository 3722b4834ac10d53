#include "SampleSearch.h"

#include "PointTree.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace SurfaceScalars
{
namespace
{

constexpr double Surroundings = 1.5;   // fetched, in radii of what is needed; measured
constexpr std::size_t MostFetched = 6; // in counts of what is needed: beyond, the density changed
constexpr double Rounding = 1e-9;      // of radii that are compared with sums of distances

} // namespace

SampleSearch::SampleSearch(const PointCloud& cloud)
  : cloud_(cloud)
{
}

void SampleSearch::nearest(const Vector3d& place, int count)
{
  const auto wanted =
    std::min<std::size_t>(static_cast<std::size_t>(std::max(1, count)), this->cloud_.pointCount());
  double squared = std::numeric_limits<double>::infinity();
  if (this->fetched_.size() >= wanted)
  {
    this->measure(place);
    squared = this->squaredReach(wanted);
  }
  if (!this->knows(place, std::sqrt(squared)))
  {
    this->fetchNearest(place, wanted);
    this->measure(place);
    squared = this->squaredReach(wanted);
  }
  this->reach_ = std::sqrt(squared);
  const auto last = this->scratch_.begin() + static_cast<std::ptrdiff_t>(wanted);
  this->choose(
    squared, static_cast<std::size_t>(std::count(this->scratch_.begin(), last, squared)));
}

void SampleSearch::within(const Vector3d& place, double radius)
{
  if (!this->knows(place, radius))
  {
    this->fetched_.clear();
    this->cloud_.tree().gather(
      place, Surroundings * radius, std::numeric_limits<std::size_t>::max(), this->fetched_);
    this->keepFetched(place, Surroundings * radius);
  }
  this->measure(place);
  this->choose(radius * radius, 0);
}

/// Whether all samples closer to the place than this are among those fetched.
bool SampleSearch::knows(const Vector3d& place, double radius) const
{
  return radius <= (1.0 - Rounding) * this->fetchRadius_ - (place - this->fetchPlace_).norm();
}

void SampleSearch::measure(const Vector3d& place)
{
  this->squared_ = (this->fetchedPoints_.col(0).array() - place.x()).square() +
    (this->fetchedPoints_.col(1).array() - place.y()).square() +
    (this->fetchedPoints_.col(2).array() - place.z()).square();
}

/// Of the count-th of the samples fetched; leaves the first ones in front.
double SampleSearch::squaredReach(std::size_t count)
{
  // Those that were near enough the last time, or a little farther, will mostly do.
  const double limit = 1.2 * this->reach_ * this->reach_;
  this->scratch_.resize(this->fetched_.size());
  std::size_t kept = 0;
  for (const double squared : this->squared_)
  {
    this->scratch_[kept] = squared;
    kept += squared <= limit ? 1 : 0;
  }
  if (kept < count)
  {
    std::copy(this->squared_.begin(), this->squared_.end(), this->scratch_.begin());
    kept = this->scratch_.size();
  }
  const auto first = this->scratch_.begin();
  const auto last = first + static_cast<std::ptrdiff_t>(count) - 1;
  std::nth_element(first, last, first + static_cast<std::ptrdiff_t>(kept));
  return *last;
}

void SampleSearch::fetchNearest(const Vector3d& place, std::size_t count)
{
  // As far as the last ones were, and a little more, unless that is too few or too many.
  const double radius = Surroundings * this->reach_;
  this->fetched_.clear();
  if (!this->cloud_.tree().gather(place, radius, MostFetched * count, this->fetched_) ||
    this->fetched_.size() < count)
  {
    this->cloud_.nearest(place, static_cast<int>(2 * count), this->neighborhood_);
    this->fetched_ = this->neighborhood_.indices;
    const bool all = this->fetched_.size() == this->cloud_.pointCount();
    this->keepFetched(place,
      all ? std::numeric_limits<double>::infinity()
          : std::sqrt(this->neighborhood_.squaredDistances.back()));
    return;
  }
  this->keepFetched(place, radius);
}

void SampleSearch::keepFetched(const Vector3d& place, double radius)
{
  std::sort(this->fetched_.begin(), this->fetched_.end());
  this->fetchPlace_ = place;
  this->fetchRadius_ = radius;
  const auto count = static_cast<Eigen::Index>(this->fetched_.size());
  this->fetchedPoints_.resize(count, 3);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    this->fetchedPoints_.row(i) =
      this->cloud_.points().col(this->fetched_[static_cast<std::size_t>(i)]);
  }
}

/// Of the samples fetched those closer, and the first few that are as far.
void SampleSearch::choose(double squaredRadius, std::size_t atRadius)
{
  const std::size_t count = this->fetched_.size();
  this->indices_.resize(count);
  this->squaredDistances_.resize(count);
  std::size_t chosen = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double squared = this->squared_[static_cast<Eigen::Index>(i)];
    const bool tied = squared == squaredRadius && atRadius > 0;
    this->indices_[chosen] = this->fetched_[i];
    this->squaredDistances_[chosen] = squared;
    chosen += squared < squaredRadius || tied ? 1 : 0;
    atRadius -= tied ? 1 : 0;
  }
  this->indices_.resize(chosen);
  this->squaredDistances_.resize(chosen);
}

} // namespace SurfaceScalars
