#pragma once

#include "SmoothingMesh.h"

#include <array>
#include <memory>

namespace SurfaceScalars
{

class GreensFunctions;
class PoissonSolver;

/**
 * A mesh and what is worth keeping between designs on it: topology, Laplacian, its factors, and
 * what is known of the Green's functions of vertices asked for before, so that a design that
 * differs in one point is made in a fraction of the time. Not to be used by several threads at
 * once.
 */
class SURFACESCALARSCORE_EXPORT DesignMesh
{
public:
  /// @param vertices 3 x n, finite, length units
  /// @param nameOf vertices, for messages
  /// @throws InvalidInput as MeshTopology does, or for a coordinate that is not finite; Aborted
  DesignMesh(Points vertices, const Triangles& triangles, const Execution& execution = {},
    VertexName nameOf = {});

  ~DesignMesh();

  const Points& vertices() const { return this->mesh_.vertices(); }
  const MeshTopology& topology() const { return this->mesh_.topology(); }
  const VertexName& nameOf() const { return this->mesh_.nameOf(); }

  /// With cotangent weights and, biharmonic with MassMatrix, the consistent mass matrix, else the
  /// lumped one. @throws as meshLaplacian() and SparseCholesky
  GreensFunctions& greensFunctions(
    SmoothingEnergy energy, DataMetric metric, const Execution& execution) const;

  /// W of the metric (interface: (area / n) I, the mass matrix or the lumped one).
  /// @throws as meshLaplacian()
  Eigen::SparseMatrix<double> metric(DataMetric metric, const Execution& execution) const;
  double area(const Execution& execution) const; ///< the sum of the mass

private:
  std::shared_ptr<const Laplacian> laplacian(const Execution& execution) const;

  SmoothingMesh mesh_; ///< keeps topology and Laplacian
  mutable std::shared_ptr<const PoissonSolver> poisson_;
  mutable std::array<std::unique_ptr<GreensFunctions>, 3> functions_;
};

} // namespace SurfaceScalars
