#pragma once

#include "LocalFit.h"
#include "MeshTopology.h"

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace SurfaceScalars
{

/**
 * The smooth surface that a mesh samples, around one of its vertices: a polynomial height over the
 * tangent plane, fitted to the vertices around with the weights (1 - r^2 / radius^2)^2. It need not
 * go through them. Of the degrees 2 to 4, with 1.6 and 3.2 times as many vertices as unknowns, it
 * is the fit whose slope is most certain, deviation / (radius sqrt(count)): of degree 4 with few
 * vertices on smooth surfaces, with many where these are noisy, of degree 2 where they bend much
 * within a few triangles. Vertices are gathered along the edges, so that a thin plate has two
 * sides; a planar mesh is its own chart. A function known at the vertices is fitted with it.
 *
 * Not for several threads at once.
 */
class SURFACESCALARSCORE_EXPORT MeshChart
{
public:
  static constexpr int LowestDegree = 2;
  static constexpr std::size_t MostFits =
    2 * std::size_t(LocalFit::MaximumDegree - LowestDegree + 1);

  /// @param vertices of the mesh; these must outlive this
  /// @param values of the function at the vertices
  MeshChart(const PointsRef& vertices, const MeshTopology& mesh, const ValuesRef& values);

  /// Chooses the most certain fit. @returns false where the vertices do not determine a surface
  bool center(Index vertex);

  // After center() returned true:
  std::size_t fitCount() const { return this->order_.size(); }
  void choose(std::size_t rank) { this->rank_ = rank; } ///< a fit, 0 = the most certain
  Index vertex() const { return this->vertex_; }
  const LocalFit& fit() const { return this->fits_[this->order_[this->rank_].second]; }
  double radius() const { return this->fit().scale(); } ///< of the vertices fitted to
  double spacing() const { return this->spacing_; }     ///< mean length of the edges at the vertex
  /// The vertex next to a place, going from neighbor to neighbor.
  Index nearestVertex(const Vector3d& place) const;
  /// Whether a place near the surface is not beyond the boundary of the mesh.
  bool covers(const Vector3d& place) const;

private:
  void gather(Index vertex, std::size_t count);
  bool fitTo(Index vertex, std::size_t count, int degree, LocalFit& fit);

  static constexpr double VerticesPerTerm[] = { 1.6, 3.2 }; ///< the second for noise
  PointsRef vertices_;
  const MeshTopology& mesh_;
  ValuesRef values_;
  Index vertex_ = 0;
  std::array<LocalFit, MostFits> fits_;
  std::vector<std::pair<double, std::size_t>> order_; ///< of the fits, by uncertainty
  std::size_t rank_ = 0;
  double spacing_ = 0.0;
  std::vector<Index> gathered_; ///< ring by ring
  WeightedSamples samples_;
};

} // namespace SurfaceScalars
