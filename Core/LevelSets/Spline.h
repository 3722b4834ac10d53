#pragma once

#include "Basics.h"

#include <vector>

namespace SurfaceScalars
{

/// A uniform cubic B-spline, closed or open, over the parameters [0, length].
class CubicSpline
{
public:
  /**
   * The spline with about `knotSpacing` between knots that is closest to the points in the sense of
   * weighted least squares.
   *
   * @param parameters ascending in [0, length]
   * @param weights positive
   */
  CubicSpline(const Points& points, const std::vector<double>& parameters,
    const std::vector<double>& weights, double length, double knotSpacing, bool closed);

  Vector3d operator()(double parameter) const;

private:
  struct Span
  {
    Eigen::Index indices[4]; ///< of the control points that count
    double weights[4];
  };
  Span spanAt(double parameter) const;

  Eigen::MatrixX3d controls_;
  Eigen::Index intervals_;
  double length_;
  bool closed_;
};

} // namespace SurfaceScalars
