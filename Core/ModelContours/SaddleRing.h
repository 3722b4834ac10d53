#pragma once

#include "LevelFunction.h"
#include "PatchStars.h"

#include <vector>

namespace SurfaceScalars
{

/// Where u - u(p) has one sign around a place p.
struct Sector
{
  bool isAbove = false;
  double height = 0.0; ///< the largest |u - u(p)|, by the squared distance from p
  PatchPlace peak;     ///< where that is, moved outwards on to the link
};

/// The places around one, evenly by angle.
class SaddleRing
{
public:
  /// In a plane, twice the radius away, of no triangle. @param axes of the plane, orthonormal
  SaddleRing(const Vector3d& center, const Eigen::Matrix<double, 3, 2>& axes, double radius);
  /// On the link of a vertex. @param link in cyclic order @param star the pieces around it
  SaddleRing(
    const ContourPatch& patch, Index center, const std::vector<Index>& link, const PatchStar& star);

  /// In cyclic order, on a ring of at most this radius; places where the sign is not clear count
  /// for none.
  std::vector<Sector> sectors(double radius, double rounding, LevelProbe& probe) const;

private:
  Vector3d center_;
  std::vector<PatchPlace> places_;
};

} // namespace SurfaceScalars
