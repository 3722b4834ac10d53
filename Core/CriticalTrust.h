#pragma once

#include "CriticalRefinement.h"
#include "PointTree.h"

#include <vector>

namespace SurfaceScalars
{

/// What the eigenvalues of the Hessian say.
CriticalType typeOf(const RefinedPoint& point);

/// How much is to be seen of a point for its type to be believed.
class Trust
{
public:
  explicit Trust(const CriticalScale& scale);

  /// Whether the Hessian tells the type for sure.
  bool isSure(const RefinedPoint& point) const;
  /// Whether it tells the type, if nothing else does.
  bool isLikely(const RefinedPoint& point) const;
  /// Whether it is a point of a ridge or valley at least.
  bool isCurved(const RefinedPoint& point) const;
  /// Whether enough fits see the point.
  bool isSeen(const RefinedPoint& point) const;

private:
  double strength(const RefinedPoint& point) const;

  bool isNoisy_;
  bool isFew_; ///< neighbors: then few fits see a point
};

/// The points that Hessians tell the types of.
class SurePoints
{
public:
  SurePoints(const std::vector<RefinedPoint>& points, const Trust& trust);
  bool isAnyWithin(const Vector3d& place, double radius) const;

private:
  Points places_;
  PointTree tree_;
};

} // namespace SurfaceScalars
