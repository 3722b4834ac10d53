#include "PointTree.h"

#include "NearestSets.h"

#include <nanoflann.hpp>

#include <algorithm>

namespace SurfaceScalars
{
namespace
{

constexpr std::size_t PointsPerLeaf = 24; // measured
// Parts are built side by side; more of them than threads only costs searches.
constexpr Eigen::Index PointsPerPart = 32768;
constexpr Eigen::Index MostParts = 2;

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

constexpr std::size_t LargestOrderedCount = 64; // measured: from here on the buffer is faster

/// A tree over a run of the points, with its bounding box.
struct Part
{
  Index first;
  PointAccess access;
  KdTree index;
  Vector3d low;
  Vector3d high;

  Part(const Points& points, Eigen::Index begin, Eigen::Index count)
    : first(static_cast<Index>(begin))
    , access{ points.data() + 3 * begin, static_cast<std::size_t>(count) }
    , index(3, this->access, nanoflann::KDTreeSingleIndexAdaptorParams(PointsPerLeaf))
    , low(points.middleCols(begin, count).rowwise().minCoeff())
    , high(points.middleCols(begin, count).rowwise().maxCoeff())
  {
  }

  double squaredDistance(const Vector3d& place) const
  {
    return (place - place.cwiseMax(this->low).cwiseMin(this->high)).squaredNorm();
  }
};

} // namespace

struct PointTree::Tree
{
  std::vector<std::unique_ptr<Part>> parts;

  template <class ResultSet>
  void search(const Vector3d& place, ResultSet& found) const
  {
    const auto searchPart = [&](const Part& part)
    {
      Shifted<ResultSet> shifted{ found, part.first };
      part.index.findNeighbors(shifted, place.data(), {});
    };
    // The part that the place lies in or next to bounds what the others can add.
    if (this->parts.empty())
    {
      return;
    }
    double distances[MostParts];
    std::size_t closest = 0;
    for (std::size_t i = 0; i < this->parts.size(); ++i)
    {
      distances[i] = this->parts[i]->squaredDistance(place);
      closest = distances[i] < distances[closest] ? i : closest;
    }
    searchPart(*this->parts[closest]);
    for (std::size_t i = 0; i < this->parts.size(); ++i)
    {
      if (i != closest && distances[i] < found.worstDist())
      {
        searchPart(*this->parts[i]);
      }
    }
  }
};

PointTree::PointTree(const Points& points, const Execution& execution)
  : tree_(std::make_unique<Tree>())
{
  const Eigen::Index count = points.cols();
  const Eigen::Index parts =
    std::min(count, std::clamp<Eigen::Index>(count / PointsPerPart, 1, MostParts));
  this->tree_->parts.resize(static_cast<std::size_t>(parts));
  parallelForEach(this->tree_->parts.size(), execution,
    [&](std::size_t i, const Poll&)
    {
      const auto part = static_cast<Eigen::Index>(i);
      const Eigen::Index begin = part * count / parts;
      this->tree_->parts[i] =
        std::make_unique<Part>(points, begin, (part + 1) * count / parts - begin);
    });
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
    this->tree_->search(place, found);
    found.finish();
    for (std::size_t i = 0; i < count; ++i)
    {
      result.squaredDistances[i] = buffer[i].first;
      result.indices[i] = buffer[i].second;
    }
    return;
  }
  BoundedNearest found(result.indices.data(), result.squaredDistances.data(), count);
  this->tree_->search(place, found);
}

void PointTree::within(const Vector3d& place, double radius, Neighborhood& result) const
{
  std::vector<std::pair<Index, double>> pairs;
  nanoflann::RadiusResultSet<double, Index> found(radius * radius, pairs);
  this->tree_->search(place, found);
  std::sort(pairs.begin(), pairs.end(), nanoflann::IndexDist_Sorter());
  result.indices.resize(pairs.size());
  result.squaredDistances.resize(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    result.indices[i] = pairs[i].first;
    result.squaredDistances[i] = pairs[i].second;
  }
}

bool PointTree::gather(
  const Vector3d& place, double radius, std::size_t most, std::vector<Index>& result) const
{
  Gathered found(result, radius * radius, most);
  this->tree_->search(place, found);
  return result.size() <= most;
}

} // namespace SurfaceScalars
