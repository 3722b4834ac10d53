#pragma once

#include "Basics.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

// Result sets in nanoflann's sense: what a search of a tree fills.

namespace SurfaceScalars
{

constexpr double Unbounded = std::numeric_limits<double>::max();

/// The k nearest, kept in order.
class BoundedNearest
{
public:
  BoundedNearest(Index* indices, double* distances, std::size_t capacity)
    : indices_(indices)
    , distances_(distances)
    , capacity_(capacity)
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
      this->worst_ = this->distances_[this->capacity_ - 1];
    }
    return true;
  }

private:
  Index* indices_;
  double* distances_;
  std::size_t capacity_;
  std::size_t count_ = 0;
  double worst_ = Unbounded;
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

/// All that are closer than a radius, in no order, until there are too many.
class Gathered
{
public:
  Gathered(std::vector<Index>& indices, double squaredRadius, std::size_t most)
    : indices_(indices)
    , squaredRadius_(squaredRadius)
    , most_(most)
  {
  }

  std::size_t size() const { return this->indices_.size(); }
  bool full() const { return this->size() > this->most_; }
  double worstDist() const { return this->squaredRadius_; }

  bool addPoint(double /*distance*/, Index index)
  {
    this->indices_.push_back(index);
    return !this->full();
  }

private:
  std::vector<Index>& indices_;
  double squaredRadius_;
  std::size_t most_;
};

/// Hands what a part finds on, with the indices of the whole.
template <class ResultSet>
struct Shifted
{
  ResultSet& found;
  Index shift;

  std::size_t size() const { return this->found.size(); }
  bool full() const { return this->found.full(); }
  double worstDist() const { return this->found.worstDist(); }
  bool addPoint(double distance, Index index)
  {
    return this->found.addPoint(distance, index + this->shift);
  }
};

} // namespace SurfaceScalars
