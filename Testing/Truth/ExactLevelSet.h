#pragma once

#include "Functions.h"
#include "Torus.h"

#include <vector>

namespace SurfaceScalars::Truth
{

/// The curves of {f = isoValue} on the torus.
struct ExactLevelSet
{
  double isoValue;
  int closedCount = 0;
  int openCount = 0; ///< from boundary to boundary of the cut torus
  std::vector<Vector3d>
    points; ///< on the curves to rounding, no two neighbors further apart than the grid's diagonal
};

/**
 * The level sets of a function on the torus, from marching squares on a fine grid of the angles.
 *
 * The number of curves is exact if no two critical points, boundary extrema included, lie closer to
 * the level set than the grid resolves: true for iso-values a percent of the range away from
 * critical values. Where a cell has two crossings on either diagonal, the value at its center
 * decides.
 */
class LevelSetFamily
{
public:
  /// @param axialCells cells along u; half as many along v
  LevelSetFamily(SpaceFunction function, Torus torus, int axialCells = 1200);

  ExactLevelSet at(double isoValue) const;

private:
  Vector2d angles(double i, double j) const;
  std::size_t node(int i, int j) const;
  bool isAbove(int i, int j, double isoValue) const;
  Vector3d crossing(const Vector2d& from, const Vector2d& to, double isoValue) const;

  SpaceFunction function_;
  Torus torus_;
  int axialCells_;
  int tubeCells_;
  std::vector<double> values_; ///< at the nodes, v varies fastest; u wraps only on the closed torus
};

/// Moves a place to the point of {f = isoValue} on the (uncut) torus closest to it. @returns false
/// if that does not converge
bool projectOntoLevelSet(const SpaceFunction& function, double isoValue, Vector3d& place);

} // namespace SurfaceScalars::Truth
