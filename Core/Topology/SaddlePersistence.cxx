#include "SaddlePersistence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace SurfaceScalars
{
namespace
{

constexpr double RingRadius = 2.0;  // in radii of what need not show the saddle
constexpr double LesserShare = 0.5; // of that, on narrow surfaces
constexpr double Infinity = std::numeric_limits<double>::infinity();

} // namespace

SaddlePersistence::SaddlePersistence(const NeighborGraph& graph, const ValuesRef& values)
  : graph_(graph)
  , values_(values)
  , marks_(graph.pointCount(), 0)
  , parents_(graph.pointCount())
{
}

SaddlePersistence::Sectors SaddlePersistence::sectorsOf(
  const Samples& ring, double value, double sign)
{
  const int unseen = ++this->lastMark_;
  for (const Index sample : ring)
  {
    if (sign * (this->values_[sample] - value) > 0.0)
    {
      this->marks_[sample] = unseen;
    }
  }
  Sectors sectors;
  for (const Index seed : ring)
  {
    Samples sector;
    const auto visit = [&](Index sample)
    {
      if (this->marks_[sample] == unseen)
      {
        this->marks_[sample] = 0;
        sector.push_back(sample);
      }
    };
    visit(seed);
    std::size_t next = 0;
    while (next < sector.size())
    {
      const Neighbors around = this->graph_.neighbors(sector[next++]);
      std::for_each(around.begin(), around.end(), visit);
    }
    if (sector.size() > sectors.first.size())
    {
      sectors.first.swap(sector);
    }
    if (sector.size() > sectors.second.size())
    {
      sectors.second.swap(sector);
    }
  }
  return sectors;
}

/// Steps to the largest sample, or to the least for sign -1, of those that one open neighbor lies
/// between: past extrema of single edges.
template <class Predicate>
Index SaddlePersistence::climb(Index sample, double sign, const Predicate& isOpen) const
{
  Index next = sample;
  do
  {
    sample = next;
    for (const Index between : this->graph_.neighbors(sample))
    {
      if (isOpen(between))
      {
        for (const Index end : this->graph_.neighbors(between))
        {
          const bool isFarther = sign * (this->values_[end] - this->values_[next]) > 0.0;
          next = isFarther && isOpen(end) ? end : next;
        }
      }
    }
  } while (next != sample);
  return sample;
}

/// Whether the ways up from both ends, or down for sign -1, lead to one extremum: whether there is
/// a path, known without a search, or nothing is known.
template <class Predicate>
bool SaddlePersistence::shareExtremum(
  const Sectors& ends, double sign, const Predicate& isOpen) const
{
  return this->climb(ends.first.front(), sign, isOpen) ==
    this->climb(ends.second.front(), sign, isOpen);
}

/// Through open points, from both ends by turns: in the time that the lesser of two components
/// takes if there is no path.
template <class Predicate>
SaddlePersistence::Connection SaddlePersistence::connect(
  const Sectors& ends, const Predicate& isOpen)
{
  std::array<Samples, 2> visited{ ends.first, ends.second };
  const std::array<int, 2> marks{ this->lastMark_ + 1, this->lastMark_ + 2 };
  this->lastMark_ += 2;
  for (std::size_t side = 0; side < 2; ++side)
  {
    for (const Index sample : visited[side])
    {
      this->marks_[sample] = marks[side];
      this->parents_[sample] = sample;
    }
  }
  Samples path;
  const auto trace = [&](Index sample)
  {
    for (; this->parents_[sample] != sample; sample = this->parents_[sample])
    {
      path.push_back(sample);
    }
    path.push_back(sample);
  };
  for (std::size_t i = 0; i < visited[0].size() && i < visited[1].size(); ++i)
  {
    for (std::size_t side = 0; side < 2; ++side)
    {
      const Index sample = visited[side][i];
      for (const Index neighbor : this->graph_.neighbors(sample))
      {
        if (this->marks_[neighbor] == marks[1 - side])
        {
          trace(sample);
          trace(neighbor);
          return { std::move(path), {} };
        }
        if (this->marks_[neighbor] != marks[side] && isOpen(neighbor))
        {
          this->marks_[neighbor] = marks[side];
          this->parents_[neighbor] = sample;
          visited[side].push_back(neighbor);
        }
      }
    }
  }
  return { {}, std::move(visited[visited[0].size() < visited[1].size() ? 0 : 1]) };
}

/// What no path may touch that shall not cross the loop.
int SaddlePersistence::buildWall(const Samples& center, const Sectors& loop, const Samples& path)
{
  const int wall = ++this->lastMark_;
  for (const Samples* part : { &center, &loop.first, &loop.second })
  {
    for (const Index sample : *part)
    {
      this->marks_[sample] = wall;
    }
  }
  for (const Index sample : path)
  {
    this->marks_[sample] = wall;
    for (const Index neighbor : this->graph_.neighbors(sample))
    {
      this->marks_[neighbor] = wall;
    }
  }
  return wall;
}

double SaddlePersistence::extent(const Samples& samples, double value, double sign) const
{
  double largest = 0.0;
  for (const Index sample : samples)
  {
    largest = std::max(largest, sign * (this->values_[sample] - value));
  }
  return largest;
}

/// What a loop through two sectors cuts off of the sides between, of this sign; infinity if
/// nothing.
double SaddlePersistence::cut(const Sectors& loop, const Samples& path, const Sectors& sides,
  const Samples& center, double value, double sign)
{
  const int wall = this->buildWall(center, loop, path);
  const auto isFree = [&](Index sample) { return this->marks_[sample] != wall; };
  Sectors free;
  std::copy_if(sides.first.begin(), sides.first.end(), std::back_inserter(free.first), isFree);
  std::copy_if(sides.second.begin(), sides.second.end(), std::back_inserter(free.second), isFree);
  const Connection around = this->connect(free, isFree);
  return around.path.empty() ? this->extent(around.enclosed, value, sign) : Infinity;
}

double SaddlePersistence::measureAround(const Vector3d& place, double value, double radius)
{
  Neighborhood around;
  this->graph_.within(place, radius, around);
  Samples center = around.indices;
  std::sort(center.begin(), center.end());
  this->graph_.within(place, RingRadius * radius, around);
  Samples ring;
  std::copy_if(around.indices.begin(), around.indices.end(), std::back_inserter(ring),
    [&](Index sample) { return !std::binary_search(center.begin(), center.end(), sample); });
  const Sectors below = this->sectorsOf(ring, value, -1.0);
  const Sectors above = this->sectorsOf(ring, value, 1.0);
  if (below.second.empty() || above.second.empty())
  {
    return 0.0;
  }
  // Loops do not pass through the saddle.
  const auto isOpen = [&](Index sample, double sign)
  {
    return sign * (this->values_[sample] - value) > 0.0 &&
      !std::binary_search(center.begin(), center.end(), sample);
  };
  const auto isBelow = [&](Index sample) { return isOpen(sample, -1.0); };
  const auto isAbove = [&](Index sample) { return isOpen(sample, 1.0); };
  if (this->shareExtremum(below, -1.0, isBelow) && this->shareExtremum(above, 1.0, isAbove))
  {
    return Infinity; // loops that cut the surface meet twice, these at the saddle only
  }
  const Connection lower = this->connect(below, isBelow);
  const Connection upper = this->connect(above, isAbove);
  if (!lower.path.empty() && !upper.path.empty())
  {
    return Infinity;
  }
  // Sides that are not connected yet end at the saddle.
  const double ofLower = lower.path.empty()
    ? this->extent(lower.enclosed, value, -1.0)
    : this->cut(below, lower.path, above, center, value, 1.0);
  const double ofUpper = upper.path.empty()
    ? this->extent(upper.enclosed, value, 1.0)
    : this->cut(above, upper.path, below, center, value, -1.0);
  return std::max(ofLower, ofUpper);
}

double SaddlePersistence::measure(const Vector3d& place, double value, double radius)
{
  const double persistence = this->measureAround(place, value, radius);
  return persistence > 0.0 ? persistence : this->measureAround(place, value, LesserShare * radius);
}

} // namespace SurfaceScalars
