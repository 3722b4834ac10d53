#pragma once

#include "DisjointSets.h"
#include "MergeTrees.h"
#include "Persistence.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <unordered_map>
#include <vector>

namespace SurfaceScalars
{

/// In place of the index of a critical point.
constexpr std::size_t NoPoint = std::numeric_limits<std::size_t>::max();

/// What differs from a critical point by more of its resolutions is seen by the sampling.
constexpr double LeastResolutions = 4.0;

/// Where a critical point lies among the samples.
struct CriticalPlace
{
  std::vector<Index> samples; ///< those it may belong to, nearest first
  double step;                ///< sampling step
  double radius;              ///< within which f~ at the samples need not show it
  double resolution;          ///< by how much f~ at the nearest samples differs from its value
};

/// What both sweeps know of the critical points.
struct CriticalPairing
{
  std::vector<CriticalPoint>& points;
  const NeighborGraph& graph;
  const ValuesRef& values;
  std::vector<CriticalPlace> places = {};
  std::vector<int> freeCount = {};      ///< times that a saddle may still be paired
  std::vector<double> seen = {};        ///< persistence of graph pairs at a point
  std::vector<std::size_t> hidden = {}; ///< extrema in the basin of a deeper one
  std::vector<CriticalPair> pairs = {};

  bool isSaddle(std::size_t i) const { return this->points[i].type == CriticalType::Saddle; }
  void pair(std::size_t extremum, std::size_t saddle)
  {
    const double persistence = std::abs(this->points[saddle].value - this->points[extremum].value);
    this->points[extremum].persistence = persistence;
    this->pairs.push_back({ extremum, saddle, persistence });
    --this->freeCount[saddle];
  }
  void note(std::size_t point, double persistence)
  {
    this->seen[point] = std::max(this->seen[point], persistence);
  }
};

/// When basins of a merge tree come together in the graph.
class MergeTimes
{
public:
  explicit MergeTimes(const MergeTree& tree)
    : merges_(tree.merges)
    , times_(tree.basins.size(), tree.merges.size())
  {
    for (std::size_t i = 0; i < this->merges_.size(); ++i)
    {
      this->times_[this->merges_[i].younger] = i;
    }
  }

  /// The merge after which two extrema are in one component; none if there is no such merge.
  const Merge* mergeOf(Index a, Index b) const
  {
    std::size_t time = NoPoint;
    while (a != b)
    {
      Index& first = this->times_[a] < this->times_[b] ? a : b;
      time = this->times_[first];
      if (time == this->merges_.size())
      {
        return nullptr;
      }
      first = this->merges_[time].elder;
    }
    return time == NoPoint ? nullptr : &this->merges_[time];
  }

private:
  const std::vector<Merge>& merges_;
  std::vector<std::size_t> times_; ///< of the end of each extremum
};

/// A component of a sublevel set, or of a superlevel set.
struct MergeComponent
{
  Index root;                       ///< the extremum of the graph it is known by
  double birth;                     ///< height of its oldest extremum
  std::size_t extremum = NoPoint;   ///< that critical point, if it is one
  std::vector<std::size_t> saddles; ///< around which it lies, ascending
};

/// One sweep over the levels; superlevel sets are swept as the sublevel sets of -f.
class MergeSweep
{
public:
  MergeSweep(CriticalPairing& pairing, const MergeTree& tree, CriticalType extremumType);
  void run(double range);

private:
  double height(double value) const { return this->sign_ * value; }
  double height(std::size_t point) const { return this->height(this->all_.points[point].value); }
  double heightOfSample(Index sample) const { return this->height(this->all_.values[sample]); }

  MergeComponent& componentOf(Index sample);
  void placeExtremum(std::size_t extremum);
  void placeSaddle(std::size_t saddle);
  void placeUncertain(std::size_t point);
  bool isOlder(const MergeComponent& a, const MergeComponent& b) const;
  std::vector<std::size_t> saddlesBetween(
    const MergeComponent& a, const MergeComponent& b, double level) const;
  void pass(std::size_t saddle);
  void passMerge(const Merge& merge);
  void endAtSaddle(const MergeComponent& younger, std::size_t saddle);
  void endAtSample(
    const MergeComponent& younger, Index sample, const std::vector<std::size_t>& saddles);
  void absorb(MergeComponent& elder, MergeComponent& younger);

  CriticalPairing& all_;
  const MergeTree& tree_;
  double sign_;
  MergeTimes times_;
  DisjointSets sets_;
  std::unordered_map<Index, MergeComponent> components_;            ///< by root
  std::unordered_map<Index, std::vector<std::size_t>> uncertainAt_; ///< a sample
  std::vector<char> isPassed_;                                      ///< of saddles
  std::vector<std::vector<Merge>> waiting_; ///< merges that a saddle close by shall make
  std::vector<Merge> postponed_; ///< merges for which no saddle is left, until all had their turn
  bool isLast_ = false;
};

} // namespace SurfaceScalars
