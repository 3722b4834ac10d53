#pragma once

#include "Basics.h"
#include "Execution.h"
#include "NeighborGraph.h"
#include "SurfaceScalarsCoreExport.h"
#include "Triangles.h"

#include <Eigen/SparseCore>

#include <vector>

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

/**
 * Of a point set: Gaussian, DensityNormalized or LocalScale (point-set paper, sec. 2.2).
 *
 * Two points are linked if either is among the neighbors of the other, and one width serves both,
 * so that the weights are symmetric where the paper's are not. In place of a division of rows by
 * their sums there is a mass:
 *
 * - LocalScale: exp(-3 d^2 / (sigma_i sigma_j)), sigma the distance that holds k neighbors; the
 *   mass is the area of a sample, pi sigma^2 / k. As density sigma^2 is constant, so is the energy
 *   of a gradient, whatever the density.
 * - Gaussian: a_ij of (3); the mass is proportional to the row sums alpha_i, so that mass^-1
 *   stiffness is (3) up to a factor. Where the density varies, this is the Laplacian of a surface
 *   that is weighted with the density's square, not of the surface.
 * - DensityNormalized: a_ij / (alpha_i alpha_j), mass proportional to the row sums of these, which
 *   tend to the area of a sample. (The condition "p_i in N(p_i)" of the paper should read p_j.)
 *
 * A weight is at least exp(-12), where neighbors differ in density by more than one to sixteen.
 *
 * The scale follows from an identity: the Dirichlet energies of the three coordinates sum to twice
 * the area of a surface. Between irregular samples, however, solutions are not smooth: they give
 * way where links are weak and so have less energy than smooth functions. The coordinates are
 * therefore relaxed at the scale of some sampling steps before their energy is measured.
 *
 * Memory: some 280 bytes per point for 16 neighbors.
 *
 * @param kernelWidth h of (3), length; 0 = such that h^2 is the mean of sigma^2 / 3. LocalScale
 * needs none.
 * @throws InvalidInput for other weights or another width; Aborted
 */
SURFACESCALARSCORE_EXPORT Laplacian pointSetLaplacian(const NeighborGraph& graph,
  LaplacianWeights weights, double kernelWidth = 0.0, const Execution& execution = {});

/**
 * Of a triangle mesh: Cotangent, NormalizedCotangent or MeanValue.
 *
 * - Cotangent: linear finite elements; the mass is a third of the area of the triangles around.
 * - NormalizedCotangent: the same stiffness, its diagonal as mass. Eigenvalues are between 0 and 2
 *   in practice and have no unit.
 * - MeanValue: (tan(alpha / 2) + tan(beta / 2)) / d with the angles at the vertex itself; not
 *   symmetric. Rows are scaled such that a regular star differentiates quadratic functions exactly.
 *
 * All vanish on linear functions where the mesh is planar. The height of a triangle counts as at
 * least 1e-8 of its longest edge: slivers tie their corners together, and the stiffness remains
 * positive semidefinite. A vertex without area has the mean mass.
 *
 * @param vertices 3 x n
 * @throws InvalidInput for other weights, corners that do not exist, coordinates that are not
 * finite, triangles without area; Aborted
 */
SURFACESCALARSCORE_EXPORT Laplacian meshLaplacian(const PointsRef& vertices,
  const Triangles& triangles, LaplacianWeights weights, const Execution& execution = {});

/// The connected components of the graph that a sparse matrix's nonzero entries make, of either
/// triangle: a number for each row, counted from 0 in the order of their first rows.
SURFACESCALARSCORE_EXPORT std::vector<int> connectedComponents(
  const Eigen::SparseMatrix<double>& matrix);

} // namespace SurfaceScalars
