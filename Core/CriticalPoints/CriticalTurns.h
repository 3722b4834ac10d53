#pragma once

#include "CriticalRing.h"

#include <optional>
#include <vector>

namespace SurfaceScalars
{

/**
 * The turns of the gradient along a ring: the sum of the indices of all critical points within
 * (Poincare and Hopf).
 *
 * @returns none where the surface ends or turns away, or the gradient nearly vanishes on the ring
 */
std::optional<int> indexWithin(CriticalModel& model, const Ring& ring);

/// An ellipse over the surface.
struct Ellipse
{
  Vector3d center; ///< relative to the cloud of the model
  Vector3d normal; ///< of the surface there
  Eigen::Matrix<double, 3, 2> halfAxes;
};

struct ClearIndex
{
  int index;
  double clearness; ///< least ratio of the gradient to its standard error
};

/// The same along an ellipse, and how far errors of f~ are from changing it.
std::optional<ClearIndex> indexWithin(CriticalModel& model, const Ellipse& ellipse);

/// A small cell of the surface with the turns of the gradient around it.
struct Turn
{
  Vector3d place; ///< its middle, relative to the cloud of the model
  int index;      ///< not 0
};

/// The cells that a disc is divided into around which the gradient turns. Their indices sum to
/// that of the outline of all cells, however wide the cells are.
std::vector<Turn> turnsWithin(CriticalModel& model, const Ring& disc, double cellWidth);

} // namespace SurfaceScalars
