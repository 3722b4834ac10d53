#pragma once

#include "ExactLevelSet.h"
#include "Functions.h"
#include "LevelSets.h"

#include <limits>
#include <vector>

namespace SurfaceScalars::Truth
{

/// How far traced curves and the exact level set are apart, in length units.
struct CurveScore
{
  std::size_t pointCount = 0;
  double pointSum = 0.0; ///< of the distances of the curves' points to the exact level set
  double pointMaximum = 0.0;
  double exactMaximum = 0.0; ///< distance of the exact level set to the curves
  double exactInnerMaximum =
    0.0; ///< the same, without exact points closer to the cut than `boundaryMargin`

  double pointMean() const;
  void add(const CurveScore& other); ///< pools two level sets
};

/**
 * Compares the curves of one level with the exact level set.
 *
 * @param boundaryMargin see CurveScore::exactInnerMaximum; 0 on the closed torus
 */
CurveScore scoreCurves(const std::vector<const LevelSetCurve*>& curves,
  const SpaceFunction& function, const ExactLevelSet& exact, double boundaryMargin);

/// Largest distance of the places to the polylines; infinite if there is no polyline.
double largestDistance(
  const std::vector<Vector3d>& places, const std::vector<const LevelSetCurve*>& curves);

} // namespace SurfaceScalars::Truth
