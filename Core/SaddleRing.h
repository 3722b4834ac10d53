#pragma once

#include "LevelFunction.h"
#include "PatchStars.h"

#include <vector>

namespace SurfaceScalars
{

/// Where u - u(p) has one sign around a vertex p.
struct Sector
{
  bool isAbove;
  double height;   ///< the largest |u - u(p)|, by the squared distance from p
  PatchPlace peak; ///< where that is, moved on to the link
};

/// The places around a vertex, evenly by angle.
class SaddleRing
{
public:
  /// @param link of the center, in cyclic order @param star the pieces around it
  SaddleRing(
    const ContourPatch& patch, Index center, const std::vector<Index>& link, const PatchStar& star);

  /// In cyclic order, on a ring of at most this radius; places where the sign is not clear count
  /// for none.
  std::vector<Sector> sectors(double radius, double rounding, LevelProbe& probe) const;

private:
  Vector3d center_;
  std::vector<PatchPlace> places_; ///< on the link
};

} // namespace SurfaceScalars
