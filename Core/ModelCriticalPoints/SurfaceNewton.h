#pragma once

#include "CriticalPoint.h"
#include "Execution.h"
#include "Field.h"
#include "MeshChart.h"

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
  LocalFit::Jet restricted;          ///< of u there, in the last chart
  double spacing = 0.0;              ///< of the mesh there
  std::vector<double> residuals; ///< norm of the tangential gradient, at first and after each step
  int evaluations = 0;           ///< of u with its derivatives
  bool isCritical = false;       ///< the last residual is within the tolerance
  bool isOnMesh = false;         ///< and not beyond its boundary

  int stepCount() const { return std::max(0, static_cast<int>(this->residuals.size()) - 1); }
};

/// On which charts a search is.
enum class ChartChoice
{
  Nearest, ///< that of the nearest vertex, each at most once
  First    ///< that of the start only, within its radius
};

struct SearchLimits
{
  double tolerance; ///< of the tangential gradient
  int mostSteps = 10;
};

/**
 * A trust-region Newton method for critical points of a function u of space restricted to the
 * smooth surface that a mesh samples (design paper, sec. 5). Steps are taken in the chart of the
 * vertex at which the search is; where another vertex is nearer than that, its chart is entered,
 * each at most once: a surface that changed with every step would not let Newton's method converge.
 * Where charts of neighbors contradict each other, a single one may still have a critical point.
 *
 * In the axes of the Hessian H_g, with gradient g_i and eigenvalues l_i, a step is
 * -sign_i g_i / (|l_i| + mu), mu >= 0 such that it is not longer than the trust region. Near a
 * critical point of the type searched for that is Newton's own. For a minimum the signs are +1: it
 * goes down everywhere; for a maximum -1; for a saddle down along the axis of the larger eigenvalue
 * and up along the other. For any type they are those of the eigenvalues, and each step makes
 * |grad g| smaller. The region shrinks where the gradient is not what the Hessian predicts.
 *
 * Not for several threads at once.
 */
class SURFACESCALARSCORE_EXPORT SurfaceNewton
{
public:
  /// @param vertices of the mesh; it, they and the field must outlive this
  SurfaceNewton(const PointsRef& vertices, const MeshTopology& mesh, const Field& field,
    const SearchLimits& limits);

  /// @param place next to the vertex
  /// @param type Minimum, Saddle, Maximum, or Uncertain for any
  SurfaceSearch search(const Vector3d& place, Index vertex, CriticalType type,
    ChartChoice charts = ChartChoice::Nearest, const Poll& poll = {});

  /// The norm of the tangential gradient at a vertex; -1 where u has no derivatives.
  double residualAt(Index vertex);

private:
  struct Point
  {
    Vector2d st;
    LocalFit::Jet g;
    double residual = 0.0;
  };

  bool enter(Index vertex);
  bool evaluate(const Vector2d& st, Point& point);
  bool follow(Point& point, ChartChoice charts);
  bool step(Point& point, CriticalType type);
  bool isBetter(const Point& before, const Point& after, const Vector2d& step, CriticalType type);

  MeshChart chart_;
  const Field& field_;
  PointsRef vertices_;
  SearchLimits limits_;
  std::unique_ptr<FieldApproximation> approximation_;
  std::vector<Index> entered_; ///< vertices whose charts were
  double trust_ = 0.0;         ///< length of the longest step
  int evaluations_ = 0;
};

} // namespace SurfaceScalars
