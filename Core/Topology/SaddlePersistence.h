#pragma once

#include "NeighborGraph.h"

#include <vector>

namespace SurfaceScalars
{

/**
 * The persistence of single saddles, by Jordan's theorem: a loop that descends from a saddle on
 * both sides and closes below it cuts the surface in two, unless it goes around a handle. What
 * rises on the lesser side then ends at the saddle; likewise for loops above it.
 *
 * Loops are paths in the graph and as wide as its edges, so that no edge jumps over them. Where
 * f~ is rough, and edges jump over ridges, they know what the order of all merges does not.
 */
class SaddlePersistence
{
public:
  /// @param values f~, one per point of the graph
  SaddlePersistence(const NeighborGraph& graph, const ValuesRef& values);

  /**
   * Time O(n) for a handle on which the ways up from the saddle, or down, end at different extrema
   * of the graph; else that of the ways, or of the lesser side.
   *
   * @param place of the saddle, relative to the graph's origin
   * @param value of f~ there
   * @param radius within which f~ at the samples need not show the saddle: they are asked at up to
   * twice the radius and, where the surface is too narrow for that, at half as much
   * @returns infinity for a handle; 0 if they show none
   */
  double measure(const Vector3d& place, double value, double radius);

private:
  using Samples = std::vector<Index>;

  /// The largest two components, in a ring, of what lies above the saddle, or below for sign -1.
  struct Sectors
  {
    Samples first;
    Samples second; ///< empty where there is one only
  };

  /// A path from one set to another, or else what is connected to the lesser of them.
  struct Connection
  {
    Samples path;
    Samples enclosed;
  };

  Sectors sectorsOf(const Samples& ring, double value, double sign);
  template <class Predicate>
  Index climb(Index sample, double sign, const Predicate& isOpen) const;
  template <class Predicate>
  bool shareExtremum(const Sectors& ends, double sign, const Predicate& isOpen) const;
  template <class Predicate>
  Connection connect(const Sectors& ends, const Predicate& isOpen);
  int buildWall(const Samples& center, const Sectors& loop, const Samples& path);
  double extent(const Samples& samples, double value, double sign) const;
  double cut(const Sectors& loop, const Samples& path, const Sectors& sides, const Samples& center,
    double value, double sign);
  double measureAround(const Vector3d& place, double value, double radius);

  const NeighborGraph& graph_;
  const ValuesRef& values_;
  std::vector<int> marks_;     ///< who was at a point last
  std::vector<Index> parents_; ///< whence
  int lastMark_ = 0;
};

} // namespace SurfaceScalars
