#include "PointTree.h"

#include <nanoflann.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace SurfaceScalars
{
namespace
{

constexpr std::size_t PointsPerLeaf = 24; // measured
constexpr double Unbounded = std::numeric_limits<double>::max();

/// The points as nanoflann wants to see them.
struct PointAccess
{
  const double* coordinates;
  std::size_t count;

  std::size_t kdtree_get_point_count() const { return this->count; }
  double kdtree_get_pt(std::size_t point, std::size_t axis) const
  {
    return this->coordinates[3 * point + axis];
  }
  template <class Box>
  bool kdtree_get_bbox(Box&) const
  {
    return false;
  }
};

/// Squared Euclidean distance, as nanoflann's own but without its loop over axes.
struct Distance
{
  using ElementType = double;
  using DistanceType = double;

  const double* coordinates;

  explicit Distance(const PointAccess& access)
    : coordinates(access.coordinates)
  {
  }
  double evalMetric(const double* place, std::size_t point, std::size_t /*dimension*/) const
  {
    const double* other = this->coordinates + 3 * point;
    const double x = place[0] - other[0];
    const double y = place[1] - other[1];
    const double z = place[2] - other[2];
    return x * x + y * y + z * z;
  }
  double accum_dist(double a, double b, std::size_t /*axis*/) const { return (a - b) * (a - b); }
};

using KdTree = nanoflann::KDTreeSingleIndexAdaptor<Distance, PointAccess, 3, Index>;

/// nanoflann's result set for the k nearest, which may start with a bound on the largest distance.
class BoundedNearest
{
public:
  BoundedNearest(Index* indices, double* distances, std::size_t capacity, double bound)
    : indices_(indices)
    , distances_(distances)
    , capacity_(capacity)
    , worst_(bound)
  {
  }

  std::size_t size() const { return this->count_; }
  bool full() const { return this->count_ == this->capacity_; }
  double worstDist() const { return this->worst_; }

  bool addPoint(double distance, Index index)
  {
    if (distance >= this->worst_) // nanoflann asks for the bound only once per leaf
    {
      return true;
    }
    std::size_t i = this->full() ? this->capacity_ - 1 : this->count_++;
    for (; i > 0 && this->distances_[i - 1] > distance; --i)
    {
      this->distances_[i] = this->distances_[i - 1];
      this->indices_[i] = this->indices_[i - 1];
    }
    this->distances_[i] = distance;
    this->indices_[i] = index;
    if (this->full())
    {
      this->worst_ = std::min(this->worst_, this->distances_[this->capacity_ - 1]);
    }
    return true;
  }

private:
  Index* indices_;
  double* distances_;
  std::size_t capacity_;
  std::size_t count_ = 0;
  double worst_;
};

/// The same for large k: collects twice as many and drops the farther half, which costs less than
/// keeping them in order.
class BufferedNearest
{
public:
  using Found = std::pair<double, Index>;

  BufferedNearest(std::vector<Found>& buffer, std::size_t count)
    : buffer_(buffer)
    , count_(count)
  {
    buffer.clear();
    buffer.reserve(2 * count);
  }

  std::size_t size() const { return this->buffer_.size(); }
  bool full() const { return this->buffer_.size() >= this->count_; }
  double worstDist() const { return this->worst_; }

  bool addPoint(double distance, Index index)
  {
    this->buffer_.emplace_back(distance, index);
    if (this->buffer_.size() == 2 * this->count_)
    {
      this->dropFarther();
    }
    return true;
  }

  void finish()
  {
    this->dropFarther();
    std::sort(this->buffer_.begin(), this->buffer_.end());
  }

private:
  void dropFarther()
  {
    const auto last = this->buffer_.begin() + static_cast<std::ptrdiff_t>(this->count_) - 1;
    std::nth_element(this->buffer_.begin(), last, this->buffer_.end());
    this->buffer_.resize(this->count_);
    this->worst_ = last->first;
  }

  std::vector<Found>& buffer_;
  std::size_t count_;
  double worst_ = Unbounded;
};

constexpr std::size_t LargestOrderedCount = 64; // measured: from here on the buffer is faster

} // namespace

struct PointTree::Tree
{
  PointAccess access;
  KdTree index;

  explicit Tree(const Points& points)
    : access{ points.data(), static_cast<std::size_t>(points.cols()) }
    , index(3, access, nanoflann::KDTreeSingleIndexAdaptorParams(PointsPerLeaf))
  {
  }
};

PointTree::PointTree(const Points& points)
  : tree_(std::make_unique<Tree>(points))
{
}

PointTree::~PointTree() = default;

void PointTree::nearest(const Vector3d& place, std::size_t count, Neighborhood& result) const
{
  result.indices.resize(count);
  result.squaredDistances.resize(count);
  if (count > LargestOrderedCount)
  {
    std::vector<BufferedNearest::Found> buffer;
    BufferedNearest found(buffer, count);
    this->tree_->index.findNeighbors(found, place.data(), {});
    found.finish();
    for (std::size_t i = 0; i < count; ++i)
    {
      result.squaredDistances[i] = buffer[i].first;
      result.indices[i] = buffer[i].second;
    }
    return;
  }
  BoundedNearest found(result.indices.data(), result.squaredDistances.data(), count, Unbounded);
  this->tree_->index.findNeighbors(found, place.data(), {});
}

void PointTree::within(const Vector3d& place, double radius, Neighborhood& result) const
{
  std::vector<std::pair<Index, double>> found;
  this->tree_->index.radiusSearch(place.data(), radius * radius, found, {});
  result.indices.resize(found.size());
  result.squaredDistances.resize(found.size());
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    result.indices[i] = found[i].first;
    result.squaredDistances[i] = found[i].second;
  }
}

NearestSearch::NearestSearch(const PointTree& tree, std::size_t count)
  : tree_(tree)
  , indices_(count)
  , squaredDistances_(count, Unbounded)
{
}

const Index* NearestSearch::around(const Vector3d& place)
{
  // The points around the last place are within the last radius and the distance between the
  // places; a little more for rounding.
  const double radius = std::sqrt(this->squaredDistances_.back()) + (place - this->last_).norm();
  const double bound = std::min(Unbounded, radius * radius * (1.0 + 1e-12));
  BoundedNearest found(
    this->indices_.data(), this->squaredDistances_.data(), this->indices_.size(), bound);
  this->tree_.tree_->index.findNeighbors(found, place.data(), {});
  this->last_ = place;
  return this->indices_.data();
}

} // namespace SurfaceScalars
