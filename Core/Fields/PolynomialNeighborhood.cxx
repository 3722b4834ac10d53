#include "PolynomialNeighborhood.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace SurfaceScalars
{
namespace
{

constexpr int LargestEnlargement = 8; // of a neighborhood that does not determine the polynomials
constexpr double LargestVoid = 0.5;   // distance to the nearest sample, in neighborhood radii
constexpr double VoidWidening = 2.0;  // of the neighborhood beyond that
constexpr double RoundingMargin = 1e-9;

/// More samples than count, so that places nearby need no search.
int enoughFor(int count)
{
  return count + count / 8 + 4;
}

} // namespace

PolynomialNeighborhood::PolynomialNeighborhood(
  const PointCloud& cloud, const Values& values, const FitSize& size, int degree)
  : cloud_(cloud)
  , values_(values)
  , size_{ std::min(size.count, static_cast<int>(cloud.pointCount())), size.radius }
  , degree_(degree)
  , search_(cloud,
      std::min<std::size_t>(
        static_cast<std::size_t>(enoughFor(this->size_.count)), cloud.pointCount()))
{
}

bool PolynomialNeighborhood::center(const Vector3d& place)
{
  if (!place.allFinite())
  {
    return false;
  }
  if (this->centered_ && place == this->fit_.center())
  {
    return true;
  }
  const int all = static_cast<int>(this->cloud_.pointCount());
  for (int degree = this->degree_; degree >= 1; --degree)
  {
    for (int more = 1;; more *= 2)
    {
      const bool last = more == LargestEnlargement || this->size_.count * more >= all;
      if (this->fitAround(place, this->size_.count * more, degree))
      {
        return this->centered_ = true;
      }
      if (last)
      {
        break;
      }
    }
  }
  return this->centered_ = false;
}

void PolynomialNeighborhood::gather(const Vector3d& place, int count)
{
  this->gatherPlace_ = place;
  this->gatheredCount_ = count;
  const auto enough = static_cast<std::size_t>(enoughFor(count));
  this->near_.indices.clear();
  if (this->size_.radius > 0.0)
  {
    this->gatherRadius_ = 1.1 * this->size_.radius;
    this->cloud_.within(place, this->gatherRadius_, this->near_);
    this->gatherMargin_ = 0.1 * this->size_.radius;
  }
  if (this->near_.indices.size() < std::min<std::size_t>(enough, this->cloud_.pointCount()))
  {
    this->gatherNearest(place, count);
  }
  this->copySamples();
}

void PolynomialNeighborhood::gatherNearest(const Vector3d& place, int count)
{
  if (count == this->size_.count)
  {
    const std::vector<NearestSearch::Found>& found = this->search_.find(place);
    this->near_.indices.resize(found.size());
    this->near_.squaredDistances.resize(found.size());
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      this->near_.indices[i] = found[i].index;
      this->near_.squaredDistances[i] = found[i].squaredDistance;
    }
  }
  else
  {
    this->cloud_.nearest(place, enoughFor(count), this->near_);
  }
  const auto& squared = this->near_.squaredDistances;
  const std::size_t last = std::min(squared.size(), static_cast<std::size_t>(count)) - 1;
  const bool all = squared.size() == this->cloud_.pointCount();
  this->gatherRadius_ = all ? std::numeric_limits<double>::infinity() : std::sqrt(squared.back());
  this->gatherMargin_ = 0.5 * (std::sqrt(squared.back()) - std::sqrt(squared[last]));
}

void PolynomialNeighborhood::copySamples()
{
  const Points& points = this->cloud_.points();
  const auto count = static_cast<Eigen::Index>(this->near_.indices.size());
  this->weighted_.points.resize(3, count);
  this->weighted_.values.setZero(count);
  this->weighted_.weights.resize(count);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    const Index sample = this->near_.indices[static_cast<std::size_t>(i)];
    this->weighted_.points.col(i) = points.col(sample);
    if (this->values_.size() > 0)
    {
      this->weighted_.values[i] = this->values_[sample];
    }
  }
}

/// Distance to the count-th sample; more in a void, so that samples from across a hole take part.
/// Continuous in the place. Leaves the squared distances where the weights, which come from them,
/// are to be.
double PolynomialNeighborhood::radiusAround(const Vector3d& place, int count)
{
  Values& squared = this->weighted_.weights;
  squared = (this->weighted_.points.colwise() - place).colwise().squaredNorm().transpose();
  const Eigen::Index last = std::min<Eigen::Index>(count, squared.size()) - 1;
  double squaredRadius = squared[last];
  // Where they were gathered, and next to it, the nearest come first.
  if (!std::is_sorted(squared.data(), squared.data() + squared.size()))
  {
    this->scratch_.assign(squared.data(), squared.data() + squared.size());
    // Few samples lie beyond: a heap of these costs less than std::nth_element.
    const auto found = this->scratch_.rbegin() + (squared.size() - 1 - last);
    std::partial_sort(this->scratch_.rbegin(), found + 1, this->scratch_.rend(), std::greater<>());
    squaredRadius = *found;
  }
  const double radius = std::max(std::sqrt(squaredRadius), this->size_.radius);
  const double nearest = std::sqrt(squared.minCoeff()) / radius;
  return radius * (1.0 + VoidWidening * std::max(0.0, nearest - LargestVoid));
}

bool PolynomialNeighborhood::fitAround(const Vector3d& place, int count, int degree)
{
  double moved = (place - this->gatherPlace_).norm();
  if (this->gatheredCount_ != count || !(moved <= this->gatherMargin_))
  {
    this->gather(place, count);
    moved = 0.0;
  }
  this->radius_ = this->radiusAround(place, count);
  if (this->radius_ > (1.0 + RoundingMargin) * (this->gatherRadius_ - moved))
  {
    // No more than that: near a stray point the radius may be that of everything.
    this->cloud_.nearest(place, LargestEnlargement * count, this->near_);
    this->radius_ = std::min(this->radius_, std::sqrt(this->near_.squaredDistances.back()));
    this->copySamples();
    this->weighted_.weights =
      (this->weighted_.points.colwise() - place).colwise().squaredNorm().transpose();
    this->gatheredCount_ = 0; // of no use for another place
  }
  this->weighted_.weights =
    (1.0 - this->weighted_.weights.array() / (this->radius_ * this->radius_)).max(0.0).square();
  return this->fit_.compute(place, this->weighted_, this->radius_, degree);
}

} // namespace SurfaceScalars
