#pragma once

#include "Functions.h"

#include <functional>
#include <string>

namespace SurfaceScalars::Truth
{

/// A closed surface {g = 0}, known exactly.
struct ClosedSurface
{
  std::string name;
  SpaceFunction implicit; ///< g, whose gradient does not vanish on the surface
  std::function<Points(int count, unsigned seed)> sample; ///< uniform by area
  int eulerCharacteristic;
};

ClosedSurface unitSphere();
ClosedSurface closedTorus();

/// (x^4 - x^2 + y^2)^2 + z^2 = 0.15^2: a tube around a figure eight, of genus 2.
ClosedSurface doubleTorus();

/// (y^2 - 4 (1 - s) (s - 1/4)^2)^2 + z^2 = 0.16^2 with s = x^2 / 2.5: a tube around three loops, of
/// genus 3.
ClosedSurface tripleTorus();

/**
 * Points of {g = 0}, uniform by area: where isotropic random lines meet it (Crofton).
 *
 * @param radius of a ball about the origin that contains the surface; lines are searched for
 * crossings in steps of a hundredth of it
 */
Points randomCrossings(const SpaceFunction& implicit, double radius, int count, unsigned seed);

} // namespace SurfaceScalars::Truth
