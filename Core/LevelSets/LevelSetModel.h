#pragma once

#include "FieldApproximation.h"
#include "LevelSets.h"
#include "PolynomialNeighborhood.h"

#include <memory>
#include <optional>
#include <vector>

namespace SurfaceScalars
{

/// A function and its values at the points of a graph; values are scaled to a range of 1, so that
/// thresholds are fractions of f's range.
struct SampledFunction
{
  const NeighborGraph& graph;
  Values values;
  VolumeFunction volumeFunction; ///< scaled too, of places relative to graph.origin(); may be empty
  Points normals;                ///< oriented; only for SurfaceModel::RBF
  std::vector<char> missed;      ///< only for Scheme::Hybrid: see makeHybrid()
};

/// A saddle of the local model.
struct Saddle
{
  Vector3d position;
  double value;
};

/**
 * F and g of the point-set paper around one place, with what projection and tracing need of them.
 * center() builds the model of a place from the samples around it; the other functions ask that
 * model and are valid after center() returned true.
 *
 * Not for several threads at once: it holds the samples it works on.
 */
class LevelSetModel
{
public:
  virtual ~LevelSetModel();

  virtual bool center(const Vector3d& place) = 0;

  /// The place where F = level and g = 0 in the model as it is, found from `start`; none if there
  /// is none nearby.
  virtual std::optional<Vector3d> solve(double level, const Vector3d& start) const = 0;

  /// A saddle close to the center, if the model has one. Only the polynomial model looks for it.
  virtual std::optional<Saddle> nearbySaddle() const { return {}; }

  /// How far the samples around the center deviate from F, root mean square.
  virtual double deviation() const { return 0.0; }

  // At the center:
  double value = 0.0;        ///< F
  Vector3d valueGradient;    ///< of F, in space
  double distance = 0.0;     ///< g
  Vector3d distanceGradient; ///< of g
  double reach = 0.0;        ///< radius of the neighborhood, length

  Vector3d normal() const { return this->distanceGradient.normalized(); }
  /// Along the level set, unit; larger values to the left, seen against normal(). Zero where F is
  /// critical.
  Vector3d tangent() const;
  /// The first-order way to the common zero of F - level and g: the solution of least norm.
  /// Infinite where F is critical.
  Vector3d firstOrderStep(double level) const;

  /// The samples around the center, or a few more.
  virtual const std::vector<Index>& samples() const = 0;

protected:
  /// The shortest step that changes F and g to first order by what is missing; none where their
  /// gradients are parallel or zero.
  static std::optional<Vector3d> leastNormStep(
    const Vector3d& valueGradient, const Vector3d& distanceGradient, const Vector2d& missing);
};

/// Parameterised MLS: polynomials for surface and f over the tangent plane, (4)(5); f may be a
/// volume function instead.
std::unique_ptr<LevelSetModel> makePolynomialModel(
  const SampledFunction& function, const FitSize& size, int degree);

/// Explicit MLS: the average (6) for F and (2) for g; `kernelWidth` 0 = sigma / sqrt(3).
std::unique_ptr<LevelSetModel> makeAverageModel(
  const SampledFunction& function, const FitSize& size, double kernelWidth);

/// Any F and any g (see ImplicitSurface.h). `size` is that of g's neighborhoods.
std::unique_ptr<LevelSetModel> makeImplicitModel(const NeighborGraph& graph, const FitSize& size,
  std::unique_ptr<FieldApproximation> function, std::unique_ptr<FieldApproximation> surface);

} // namespace SurfaceScalars
