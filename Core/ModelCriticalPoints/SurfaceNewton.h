#pragma once

#include "CriticalPoint.h"
#include "Execution.h"
#include "Field.h"
#include "MeshChart.h"
#include "TrustRegion.h"

#include <algorithm>
#include <memory>
#include <vector>

namespace SurfaceScalars
{

/// Where a search ends.
struct SurfaceSearch
{
  Vector3d place = Vector3d::Zero(); ///< on the smooth surface, in the caller's coordinates
  Index vertex = 0;                  ///< the nearest of the mesh
  LocalFit::Jet restricted;          ///< of u there, on the chart
  double spacing = 0.0;              ///< of the mesh there
  std::vector<double> residuals; ///< norm of the tangential gradient, at first and after each step
  int evaluations = 0;           ///< of u with its derivatives
  bool isOnChart = false;        ///< else the search ends where it left the chart's radius
  bool isOnMesh = false;         ///< not beyond its boundary
  bool isCritical = false;       ///< the last residual, on the chart, is within the tolerance

  int stepCount() const { return std::max(0, static_cast<int>(this->residuals.size()) - 1); }
};

struct SearchEffort
{
  int mostSteps = 10;
  /// Goes on after a step that does not halve the tangential gradient, as far from critical points.
  bool isPatient = false;
};

/**
 * Newton's method for critical points of a function u of space restricted to the smooth surface
 * that a mesh samples (design paper, sec. 5), within trust regions. A search stays on one chart,
 * and ends where it leaves its radius: a surface that changed from step to step would not let
 * Newton's method converge.
 *
 * Not for several threads at once.
 */
class SURFACESCALARSCORE_EXPORT SurfaceNewton
{
public:
  /// @param vertices of the mesh; it, they, the values and the field must outlive this
  /// @param values of the field at the vertices
  /// @param tolerance of the tangential gradient
  SurfaceNewton(const PointsRef& vertices, const MeshTopology& mesh, const ValuesRef& values,
    const Field& field, double tolerance);

  /// Takes the chart of a vertex. @returns false where there is none
  bool enter(Index vertex);
  MeshChart& chart() { return this->chart_; }

  /// On the chart that was entered.
  /// @param place next to its vertex
  /// @param type Minimum, Saddle, Maximum, or Uncertain for any
  SurfaceSearch search(
    const Vector3d& place, CriticalType type, const SearchEffort& effort, const Poll& poll = {});

  /// The norm of the tangential gradient at a vertex, whose chart is entered; -1 where u has no
  /// derivatives.
  double residualAt(Index vertex);

private:
  bool begin(const Vector3d& place, PlanarPoint& point);
  bool evaluate(const Vector2d& st, PlanarPoint& point);

  MeshChart chart_;
  const Field& field_;
  PointsRef vertices_;
  double tolerance_;
  std::unique_ptr<FieldApproximation> approximation_;
  int evaluations_ = 0;
};

} // namespace SurfaceScalars
