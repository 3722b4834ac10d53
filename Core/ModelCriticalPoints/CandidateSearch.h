#pragma once

#include "CriticalPoint.h"
#include "SurfaceNewton.h"

#include <vector>

namespace SurfaceScalars
{

/// On which surfaces is searched for what a candidate stands for.
enum class SearchStage
{
  Certain, ///< the most certain charts of the vertex and of its neighbors
  Other    ///< the other fits to the vertices around these, the more certain first
};

/// Where one search from a candidate leads.
struct Arrival
{
  SurfaceSearch search;
  int steps = 0; ///< of this search and those in vain before it
  SearchStage stage = SearchStage::Certain;
};

/// Where the searches from one candidate lead: to points of its type.
struct Arrivals
{
  std::vector<Arrival> found; ///< different ones
  int steps = 0;              ///< in vain since the last of them
  int searches = 0;           ///< of all stages
  double residual = 0.0;      ///< at the candidate itself
};

constexpr int MostSearchSteps = 10; ///< for a point

/// How far points may lie that are the same, length: a fraction of the spacing of the mesh.
double reachOf(const SurfaceSearch& search);

/// What is searched: u on a mesh.
struct ModelOnMesh
{
  const PointsRef& vertices;
  const MeshTopology& mesh;
  const ValuesRef& values; ///< of u at the vertices
  const Field& u;
  double tolerance; ///< of the tangential gradient; 0 = u is constant: no searches
};

/**
 * Searches for critical points of u from each candidate, a critical vertex of the mesh: for one of
 * its type, or several if it is a saddle of that multiplicity, in at most 10 steps for each, those
 * of searches in vain included. Searches begin at predictedPlaces(), where there are any.
 * Critical vertices of the boundary are not searched from.
 *
 * @param wanted from each candidate, beside those that it has led to
 * @param arrivals of each candidate; more are added @throws Aborted
 */
void searchFromAll(const ModelOnMesh& model, const std::vector<CriticalPoint>& candidates,
  SearchStage stage, const std::vector<int>& wanted, std::vector<Arrivals>& arrivals,
  const Execution& execution);

} // namespace SurfaceScalars
