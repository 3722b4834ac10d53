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
  /// Whether a place lies within `distance` of a curve, as far as seeds around it tell.
  bool isOnCurve(const Vector3d& place, double distance);

private:
  struct Segment
  {
    Vector3d from;
    Vector3d to;
  };
  static constexpr std::size_t None = static_cast<std::size_t>(-1);

  void passSegment(const Vector3d& from, const Vector3d& to, double distance);

  Points positions_;
  PointTree tree_;
  std::vector<std::size_t> passedBy_; ///< a segment close to each seed
  std::vector<Segment> segments_;
  Neighborhood near_; // scratch
};

} // namespace SurfaceScalars
