#pragma once

#include "Basics.h"
#include "Execution.h"
#include "NeighborGraph.h"
#include "SurfaceScalarsCoreExport.h"

#include <Eigen/SparseCore>

namespace SurfaceScalars
{

/// The weights of a Laplacian. The numbers are fixed.
enum class LaplacianWeights
{
  Gaussian = 0,            ///< (3): exp(-d^2 / h^2)
  DensityNormalized = 1,   ///< the second matrix of sec. 2.2
  LocalScale = 2,          ///< exp(-3 d^2 / (sigma_i sigma_j)): does not depend on the density
  Cotangent = 3,           ///< of triangles, as the following
  NormalizedCotangent = 4, ///< the same, each row divided by its sum
  MeanValue = 5            ///< not symmetric
};

/**
 * The Laplace-Beltrami operator of a sampled or meshed surface: -Laplacian f = mass^-1 stiffness f.
 *
 * f^T stiffness f is the Dirichlet energy of f, in f's unit squared; the mass is the area of a
 * vertex, length squared. Rows of the stiffness sum to 0.
 */
struct Laplacian
{
  Eigen::SparseMatrix<double> stiffness; ///< n x n
  Values mass;                           ///< n, positive
  bool symmetric = true;
};

/// Corners of triangles, one triangle per column.
using Triangles = Eigen::Matrix<Index, 3, Eigen::Dynamic>;

/**
 * Of a point set: Gaussian, DensityNormalized or LocalScale (point-set paper, (3) and what
 * follows).
 *
 * (How weights are made symmetric and how the scale is derived: to be written by the implementer.)
 *
 * @param kernelWidth h of (3), length; 0 = from the sampling
 * @throws InvalidInput for other weights; Aborted
 */
SURFACESCALARSCORE_EXPORT Laplacian pointSetLaplacian(const NeighborGraph& graph,
  LaplacianWeights weights, double kernelWidth = 0.0, const Execution& execution = {});

/**
 * Of a triangle mesh: Cotangent, NormalizedCotangent or MeanValue.
 *
 * @param vertices 3 x n
 * @throws InvalidInput for other weights, corners that do not exist; Aborted
 */
SURFACESCALARSCORE_EXPORT Laplacian meshLaplacian(const PointsRef& vertices,
  const Triangles& triangles, LaplacianWeights weights, const Execution& execution = {});

/// The connected components of a sparse matrix's graph: a number for each row, counted from 0 in
/// the order of their first rows.
SURFACESCALARSCORE_EXPORT std::vector<int> connectedComponents(
  const Eigen::SparseMatrix<double>& matrix);

} // namespace SurfaceScalars
