#pragma once

#include "Basics.h"
#include "Execution.h"
#include "SurfaceScalarsCoreExport.h"

#include <memory>
#include <vector>

namespace SurfaceScalars
{

class PointTree;

/// Points found around a place, nearest first.
struct Neighborhood
{
  std::vector<Index> indices;
  std::vector<double> squaredDistances;
};

/**
 * The distinct points of a point set with a search tree.
 *
 * Points are centered, exact duplicates become one point, and the rest is sorted along a Morton
 * curve so that neighbors lie close in memory. Every index below is in that order; pointOfInput()
 * and inputOfPoint() lead there and back.
 *
 * Time O(n log n). Results do not depend on the number of threads.
 */
class SURFACESCALARSCORE_EXPORT PointCloud
{
public:
  /// @param points 3 x n, n >= 1, finite, length units @throws InvalidInput; Aborted
  explicit PointCloud(const PointsRef& points, const Execution& execution = {});
  ~PointCloud();
  PointCloud(PointCloud&&) noexcept;
  PointCloud& operator=(PointCloud&&) noexcept;

  Index pointCount() const;       ///< distinct points
  const Points& points() const;   ///< relative to origin()
  const Vector3d& origin() const; ///< center of the input's bounding box

  Index pointOfInput(std::size_t input) const;
  std::size_t inputOfPoint(Index point) const; ///< the first of its duplicates
  std::size_t inputCount() const;

  /// @param values one per input point @returns one per distinct point: the mean over its
  /// duplicates
  Values average(const ValuesRef& values) const;

  /// The `count` points nearest to `place` (relative to origin()), at most all.
  void nearest(const Vector3d& place, int count, Neighborhood& result) const;
  /// All points closer to `place` than `radius`, nearest first.
  void within(const Vector3d& place, double radius, Neighborhood& result) const;

  const PointTree& tree() const; ///< for searches that keep their buffers

private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

} // namespace SurfaceScalars
