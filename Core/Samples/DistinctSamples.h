#pragma once

#include "PointCloud.h"

#include <cstddef>
#include <vector>

namespace SurfaceScalars
{

/// Distinct samples in the order of their cloud, which is that of a cloud made of them alone: a
/// field made of its own model is the same.
class DistinctSamples
{
public:
  /// @param points as for PointCloud
  explicit DistinctSamples(const PointsRef& points, const Execution& execution = {});

  const PointCloud& cloud() const { return this->clouds_.back(); }
  const Points& centers() const { return this->centers_; } ///< in the caller's coordinates
  std::size_t inputCount() const { return this->clouds_.front().inputCount(); }

  /// One value for each center, the mean over its duplicates.
  Values average(const ValuesRef& values) const;

  /// How many centers have a duplicate whose value is not `average`, the mean.
  std::size_t contradictions(const ValuesRef& values, const Values& average) const;

private:
  Index centerOf(std::size_t input) const;
  void add(const PointsRef& points, const Execution& execution);

  std::vector<PointCloud> clouds_; // each made of the centers of the one before
  Points centers_;
};

} // namespace SurfaceScalars
