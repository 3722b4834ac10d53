#pragma once

#include "CutLocus.h"
#include "MorsePoints.h"
#include "Precedence.h"

#include <vector>

namespace SurfaceScalars
{

/// A way from a saddle to the network.
struct NetworkPath
{
  std::vector<Index> vertices; ///< between the two, from the saddle on; empty if there is none
  Index end = 0;               ///< on the network, next to the last of them
};

/// What ways cost, in diagonals of the mesh.
struct PathCosts
{
  double rise;    ///< of the range of the values
  bool keepsAway; ///< from the network, not only off its sides
};

/**
 * Ways from a saddle through one of its lower sectors to a network, for a function that shall
 * descend along them: one for each class of homotopic ones. Cheap are short ways on which the given
 * function descends, and which keep away from other points and from the network.
 */
class NetworkPaths
{
public:
  /// @param stars what waits for what around the points; all arguments outlive this
  NetworkPaths(const DesignMesh& mesh, const Values& values, const std::vector<MorsePoint>& points,
    const Precedence& stars, const PathCosts& costs);

  /// An edge of the cut locus of the cheapest ways: where a way leaves their tree.
  struct Crossing
  {
    MeshEdge edge; ///< from a vertex of the tree, to one as well or to the network
    double cost;
  };

  /// Finds the ways.
  /// @param saddle on the network, but not to be met again
  /// @param sector its neighbors, none of them on the network
  /// @param isInNetwork by vertex; outlives this
  /// @param obstacles that tell ways apart
  void search(Index saddle, const std::vector<Index>& sector, const std::vector<char>& isInNetwork,
    const std::vector<Index>& obstacles, const Execution& execution);

  /// Cheapest first.
  const std::vector<Crossing>& crossings() const { return this->crossings_; }

  /// The way over an edge, and back to the network without crossing the cut locus again if
  /// `isNarrow`, otherwise the cheapest.
  NetworkPath path(const Crossing& crossing, bool isNarrow);

private:
  class Search;

  bool isOnNetwork(Index vertex) const;
  bool isFree(Index vertex) const;
  double stepCost(Index from, Index to) const;
  double endCost(Index vertex, Index end) const;
  void addTolls(const std::vector<Index>& centers, double toll, double leastToll,
    std::vector<double>& tolls) const;
  void spanRest(std::vector<Index> reached);
  void collectCrossings();
  std::vector<Index> wayTo(Index vertex) const;

  const DesignMesh& mesh_;
  const Values& values_;
  const Precedence& stars_;
  double leastSideToll_;
  double unitLength_; ///< cost of a unit of length
  double unitRise_;   ///< and of the values
  std::vector<char> isCritical_;
  std::vector<double> tolls_;     ///< costs of vertices in and around stars
  std::vector<double> sideTolls_; ///< and along the network
  CutLocus cutLocus_;

  // Of the last search:
  Index saddle_ = 0;
  const std::vector<char>* isInNetwork_ = nullptr;
  std::vector<double> costs_;
  std::vector<Index> previous_; ///< towards the saddle
  std::vector<Crossing> crossings_;
};

} // namespace SurfaceScalars
