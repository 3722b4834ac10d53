#pragma once

#include "CurveTracer.h"
#include "PointTree.h"

#include <vector>

namespace SurfaceScalars
{

/// Which seeds of a level set the curves traced so far have passed, so that no curve is traced
/// twice.
class SeedCover
{
public:
  explicit SeedCover(const std::vector<LevelSetPoint>& seeds);

  /// Marks the seeds along a curve, and beyond its ends: those would only trace it again.
  void pass(const TracedCurve& curve);
  bool isPassed(std::size_t seed) const { return this->passedBy_[seed] != None; }
  /// Whether a place lies within `distance` of a curve, as far as seeds around it tell; of one that
  /// runs along `direction`, either way, unless that is zero.
  bool isOnCurve(const Vector3d& place, double distance, const Vector3d& direction);

private:
  struct Segment
  {
    Vector3d from;
    Vector3d to;
  };
  static constexpr std::size_t None = static_cast<std::size_t>(-1);
  static constexpr std::size_t PastEnd = static_cast<std::size_t>(-2); // of an open curve

  void passAlong(const Segment& segment, double distance, std::size_t by);

  Points positions_;
  PointTree tree_;
  std::vector<std::size_t> passedBy_; ///< a segment close to each seed, None or PastEnd
  std::vector<Segment> segments_;
  Neighborhood near_; // scratch
};

} // namespace SurfaceScalars
