#pragma once

#include "Laplacian.h"
#include "MeshTopology.h"
#include "ParameterCurve.h"
#include "Tikhonov.h"
#include "VertexName.h"

#include <map>
#include <memory>
#include <optional>
#include <tuple>

namespace SurfaceScalars
{

/// What smoothing makes small and how it measures the distance to the data.
struct SmoothingNorms
{
  LaplacianWeights weights = LaplacianWeights::Cotangent;
  DataMetric metric = DataMetric::Identity;
  SmoothingEnergy energy = SmoothingEnergy::Biharmonic;
};

/**
 * A mesh and what is worth keeping between runs on it: topology, Laplacians, and smoothers with
 * their factors, each made when first asked for and kept. A run that differs from one before only
 * in f, epsilon or thresholds finds all of it, and the last curve of epsilons as long as f remains
 * the same. Not to be used by several threads at once.
 *
 * Memory: that of the topology, of each Laplacian and of each smoother asked for (Tikhonov.h).
 */
class SURFACESCALARSCORE_EXPORT SmoothingMesh
{
public:
  /// @param vertices 3 x n, finite, length units
  /// @param nameOf for messages
  /// @throws InvalidInput as MeshTopology does, or for a coordinate that is not finite; Aborted
  SmoothingMesh(Points vertices, const Triangles& triangles, const Execution& execution = {},
    VertexName nameOf = {});

  const Points& vertices() const { return this->vertices_; }
  const MeshTopology& topology() const { return this->topology_; }
  const VertexName& nameOf() const { return this->nameOf_; }

  /// @throws as meshLaplacian()
  std::shared_ptr<const Laplacian> laplacian(
    LaplacianWeights weights, const Execution& execution = {}) const;

  /// Its metric sums to the sum of the Laplacian's mass, which is no area for NormalizedCotangent:
  /// so epsilon has no unit whatever the weights.
  /// @throws as meshLaplacian()
  const TikhonovSmoother& smoother(
    const SmoothingNorms& norms, const Execution& execution = {}) const;

  /// parameterCurve() of the smoother with these norms.
  /// @throws as parameterCurve()
  const ParameterCurve& curve(const SmoothingNorms& norms, const ValuesRef& values,
    EpsilonChoice choice, const Execution& execution = {}) const;

private:
  using SmootherKey = std::tuple<LaplacianWeights, DataMetric, SmoothingEnergy>;

  struct KnownCurve
  {
    SmootherKey norms;
    Values values;
    EpsilonChoice choice;
    ParameterCurve curve;
  };

  static SmootherKey keyOf(const SmoothingNorms& norms)
  {
    return { norms.weights, norms.metric, norms.energy };
  }

  Points vertices_;
  VertexName nameOf_;
  MeshTopology topology_;
  mutable std::map<LaplacianWeights, std::shared_ptr<const Laplacian>> laplacians_;
  mutable std::map<SmootherKey, std::unique_ptr<const TikhonovSmoother>> smoothers_;
  mutable std::map<SmootherKey, NoiseShares> shares_;
  mutable std::optional<KnownCurve> curve_;
};

} // namespace SurfaceScalars
