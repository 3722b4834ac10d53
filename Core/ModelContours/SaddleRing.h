#pragma once

#include "LevelFunction.h"
#include "PatchStars.h"

#include <vector>

namespace SurfaceScalars
{

/// What is seen of a saddle on a ring around a place p.
struct SaddleView
{
  double height = 0.0; ///< |u - u(p)| of the lowest sector, by the squared distance
  /// On the link, one in each sector, where u - u(p) has one sign. At a bend also one toward each
  /// corner of the link, all as far outwards only as the sign remains: with vertices there the link
  /// has the signs of the ring.
  std::vector<PatchPlace> marks; ///< none if p is no saddle
};

/// Of a ring on which u is what its Taylor polynomial says.
double ringRadius(const Field& field, const Vector3d& place);

/// The places around one, evenly by angle.
class SaddleRing
{
public:
  /// In a plane, twice the radius away, of no triangle. @param axes of the plane, orthonormal
  SaddleRing(const Vector3d& center, const Eigen::Matrix<double, 3, 2>& axes, double radius);
  /// On the link of a vertex. @param link in cyclic order @param star the pieces around it
  SaddleRing(
    const ContourPatch& patch, Index center, const std::vector<Index>& link, const PatchStar& star);

  /// On the largest ring, up to this radius, on which there are four sectors; where the mesh bends
  /// by little, that may be a small one. Places where the sign is not clear are in none.
  SaddleView view(double radius, double rounding, LevelProbe& probe) const;
  /// Whether u rises to one side and falls to the other, by its gradient: p is no saddle, though
  /// there may be one within the rings.
  bool isRegular(double radius, double rounding, LevelProbe& probe) const;
  /// Half the way to the nearest corner of the link.
  double reach() const { return this->reach_; }

private:
  Vector3d directionTo(std::size_t i) const;
  /// The way to a place, no farther than half to the link.
  double distanceTo(std::size_t i, double radius) const;
  /// (u - u(p)) / r^2 around, 0 if that is rounding.
  std::vector<double> heights(double radius, double rounding, LevelProbe& probe) const;
  PatchPlace mark(std::size_t i, bool isAbove, double radius, LevelProbe& probe) const;

  Vector3d center_;
  std::vector<PatchPlace> places_; ///< on the link
  std::vector<bool> isCorner_;     ///< of it
  double reach_;
  bool isPlane_ = true; ///< all around
};

} // namespace SurfaceScalars
