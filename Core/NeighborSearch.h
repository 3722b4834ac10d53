#pragma once

#include "PointTree.h"

#include <vector>

namespace SurfaceScalars
{

/**
 * Finds the neighbors of many points that are sorted along a curve: a run of them shares one search
 * of the tree, and each then chooses among the few points around the run.
 */
class NeighborSearch
{
public:
  /// @param count neighbors of each point, fewer than there are points
  NeighborSearch(const Points& points, const PointTree& tree, std::size_t count);

  /// Writes `count` neighbors of each point in [begin, end), nearest first.
  void find(Index begin, Index end, Index* neighbors);

private:
  struct Candidate
  {
    double squaredDistance;
    Index index;
  };

  Index endOfRun(Index begin, Index end) const;
  bool gatherAround(Index begin, Index end);
  bool choose(Index point, Index* neighbors);
  void sortNear(std::size_t count);
  void searchTree(Index point, Index* neighbors);

  const Points& points_;
  const PointTree& tree_;
  std::size_t count_;
  double reach_ = 0.0; ///< how far the neighbors of the next point are expected; 0 = unknown

  // The candidates, which are the points around a run:
  std::vector<Index> candidates_;
  Eigen::ArrayX3d coordinates_;
  Eigen::ArrayXd squaredDistances_; ///< from the point that chooses
  std::vector<std::size_t> near_;   ///< those within reach of it

  std::vector<Candidate> sorted_;   ///< these, by squared distance, first into classes of it
  std::vector<std::size_t> starts_; ///< of the classes
  double classesPerArea_ = 0.0;
  Neighborhood found_;
};

} // namespace SurfaceScalars
