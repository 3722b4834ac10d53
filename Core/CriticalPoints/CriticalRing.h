#pragma once

#include "CriticalModel.h"

#include <optional>

namespace SurfaceScalars
{

/// How f~ goes around a place: the signs of f~ less its value there.
struct RingCount
{
  int changes = 2; ///< of sign: 0 for extrema, 2 for regular places, 2 + 2 m for saddles
  int sign = 0;    ///< of f~ around an extremum
};

/// A circle on the surface around a place.
struct Ring
{
  Vector3d center; ///< relative to the cloud of the model
  Vector3d normal; ///< of the surface there
  double radius = 0.0;
};

/// Of a ring, before it is moved onto the surface.
Vector3d placeOn(const Ring& ring, double angle);

/// Centers the model on the surface next to a place. @returns whether there is one
bool centerOnSurface(CriticalModel& model, const Vector3d& place);

/// Moves a ring to where f~ changes around it as little to one side as to the other: around a
/// degenerate critical point, whose place fits see only vaguely. Its gradient there is as long on
/// all sides. @returns whether such a place is close
bool centerRing(CriticalModel& model, Ring& ring);

/**
 * What Hessians cannot tell: the sign changes on a ring of f~ less its value at the center.
 *
 * @returns none where noise hides signs, or where the surface ends
 */
std::optional<RingCount> countAround(CriticalModel& model, const Ring& ring);

} // namespace SurfaceScalars
