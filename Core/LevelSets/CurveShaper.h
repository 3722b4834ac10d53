#pragma once

#include "CurveTracer.h"

namespace SurfaceScalars
{

/// How the points of a curve are chosen along it.
struct CurveShape
{
  CurveFit fit = CurveFit::Interpolate;
  double spacing = 0.0;   ///< of the points along the curve, length; 0 = where they are
  bool onLevelSet = true; ///< new points of an interpolated curve are put on the level set again
};

/**
 * Chooses the points of a traced curve anew: evenly spaced on the cubic Hermite spline through its
 * points and tangents, or on a cubic spline fitted to them by least squares (sec. 4.2). Normals and
 * residuals are those of the model at the new points. Saddles stay where they are.
 */
class CurveShaper
{
public:
  CurveShaper(LevelSetModel& model, double level, const TracingLimits& limits,
    const CurveShape& shape, const Poll& poll);

  TracedCurve operator()(const TracedCurve& curve) const;

private:
  TracedCurve shapeSmooth(const TracedCurve& curve) const;
  TracedCurve shapeLoop(const TracedCurve& loop) const;
  LevelSetPoint measure(const Vector3d& place, const LevelSetPoint& nearby, double step) const;

  LevelSetModel& model_;
  double level_;
  TracingLimits limits_;
  CurveShape shape_;
  const Poll& poll_;
};

} // namespace SurfaceScalars
