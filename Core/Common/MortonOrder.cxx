#include "MortonOrder.h"

#include <algorithm>
#include <tuple>

namespace SurfaceScalars
{
namespace
{

constexpr int BitsPerAxis = 21;
constexpr int BucketBits = 12; // the leading bits: one bucket is sorted by one thread
constexpr std::size_t Grain = 8192;

struct Entry
{
  std::uint64_t key;
  Index index;
};

/// Puts two zero bits before each of the 21 bits of `value`.
std::uint64_t spreadBits(std::uint64_t value)
{
  value = (value | value << 32) & 0x001f00000000ffff;
  value = (value | value << 16) & 0x001f0000ff0000ff;
  value = (value | value << 8) & 0x100f00f00f00f00f;
  value = (value | value << 4) & 0x10c30c30c30c30c3;
  return (value | value << 2) & 0x1249249249249249;
}

class MortonKeys
{
public:
  explicit MortonKeys(const PointsRef& points)
    : low_(points.rowwise().minCoeff())
  {
    // Halved first: the extent of finite coordinates need not be finite.
    const double half = (0.5 * points.rowwise().maxCoeff() - 0.5 * this->low_).maxCoeff();
    this->scale_ = half > 0.0 ? 0.5 * ((1 << BitsPerAxis) - 1) / half : 0.0;
  }

  std::uint64_t operator()(const Vector3d& point) const
  {
    const Vector3d cell = (point - this->low_) * this->scale_;
    return spreadBits(static_cast<std::uint64_t>(cell.x())) |
      spreadBits(static_cast<std::uint64_t>(cell.y())) << 1 |
      spreadBits(static_cast<std::uint64_t>(cell.z())) << 2;
  }

private:
  Vector3d low_;
  double scale_;
};

std::size_t bucketOf(std::uint64_t key)
{
  return key >> (3 * BitsPerAxis - BucketBits);
}

/// Distributes the points over buckets by the leading bits of their keys; returns the bucket
/// bounds.
std::vector<std::size_t> distribute(
  const std::vector<std::uint64_t>& keys, std::vector<Entry>& entries)
{
  std::vector<std::size_t> bounds((1 << BucketBits) + 1, 0);
  for (const std::uint64_t key : keys)
  {
    ++bounds[bucketOf(key) + 1];
  }
  for (std::size_t i = 1; i < bounds.size(); ++i)
  {
    bounds[i] += bounds[i - 1];
  }
  std::vector<std::size_t> next(bounds.begin(), bounds.end() - 1);
  for (std::size_t i = 0; i < keys.size(); ++i)
  {
    entries[next[bucketOf(keys[i])]++] = { keys[i], static_cast<Index>(i) };
  }
  return bounds;
}

} // namespace

std::vector<Index> mortonOrder(const PointsRef& points, const Execution& execution)
{
  const auto count = static_cast<std::size_t>(points.cols());
  const auto column = [&](Index i) { return points.col(static_cast<Eigen::Index>(i)); };

  const MortonKeys keyOf(points);
  std::vector<std::uint64_t> keys(count);
  parallelFor(count, Grain, execution.part(0.0, 0.3),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        keys[i] = keyOf(column(static_cast<Index>(i)));
      }
    });

  std::vector<Entry> entries(count);
  const std::vector<std::size_t> bounds = distribute(keys, entries);
  std::vector<std::uint64_t>().swap(keys);

  const auto before = [&](const Entry& a, const Entry& b)
  {
    if (a.key != b.key)
    {
      return a.key < b.key;
    }
    const auto p = column(a.index);
    const auto q = column(b.index);
    return std::make_tuple(p.x(), p.y(), p.z(), a.index) <
      std::make_tuple(q.x(), q.y(), q.z(), b.index);
  };
  std::vector<Index> order(count);
  parallelFor(bounds.size() - 1, 16, execution.part(0.3, 1.0),
    [&](std::size_t begin, std::size_t end)
    {
      const auto at = [&](std::size_t bucket)
      { return entries.begin() + static_cast<std::ptrdiff_t>(bounds[bucket]); };
      for (std::size_t bucket = begin; bucket < end; ++bucket)
      {
        std::sort(at(bucket), at(bucket + 1), before);
      }
      std::transform(at(begin), at(end), order.begin() + static_cast<std::ptrdiff_t>(bounds[begin]),
        [](const Entry& entry) { return entry.index; });
    });
  return order;
}

} // namespace SurfaceScalars
