#pragma once

#include "Basics.h"

#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace SurfaceScalars
{

/// A front that passes points in the order of their distances from where it began.
class Front
{
public:
  explicit Front(Index count)
    : distances_(Values::Constant(count, std::numeric_limits<double>::infinity()))
  {
  }

  /// Infinite until one is offered.
  double distance(Index point) const { return this->distances_[point]; }
  const Values& distances() const { return this->distances_; }

  /// The points with a finite distance.
  const std::vector<Index>& reached() const { return this->reached_; }

  /// A way to a point; counts if it is shorter than those before.
  void offer(Index point, double distance)
  {
    if (distance < this->distances_[point])
    {
      if (std::isinf(this->distances_[point]))
      {
        this->reached_.push_back(point);
      }
      this->distances_[point] = distance;
      this->arrivals_.emplace(distance, point);
    }
  }

  /// Passes the nearest point to which a way was offered that it has not gone yet.
  /// @returns whether there is one
  bool pass(Index& point)
  {
    while (!this->arrivals_.empty())
    {
      const Arrival next = this->arrivals_.top();
      this->arrivals_.pop();
      if (next.first == this->distances_[next.second])
      {
        point = next.second;
        return true;
      }
    }
    return false;
  }

  /// Begins anew, in time that depends on the points that were reached only.
  void clear()
  {
    for (const Index point : this->reached_)
    {
      this->distances_[point] = std::numeric_limits<double>::infinity();
    }
    this->reached_.clear();
    this->arrivals_ = {};
  }

private:
  using Arrival = std::pair<double, Index>;

  Values distances_;
  std::vector<Index> reached_;
  std::priority_queue<Arrival, std::vector<Arrival>, std::greater<>> arrivals_;
};

} // namespace SurfaceScalars
