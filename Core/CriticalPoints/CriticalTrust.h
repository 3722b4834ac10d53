#pragma once

#include "CriticalRefinement.h"
#include "PointTree.h"

#include <vector>

namespace SurfaceScalars
{

/// 1 or -1 where small rings around a point agree on it, and a large one does not enclose more.
std::optional<int> clearIndex(const RefinedPoint& point);

/// What the gradient around says where that is clear, else the eigenvalues of the Hessian.
CriticalType typeOf(const RefinedPoint& point);

/// How much is to be seen of a point for its type to be believed.
class Trust
{
public:
  explicit Trust(const CriticalScale& scale);

  /// Whether the Hessian, or the gradient around, tells the type for sure.
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
