#pragma once

#include "LevelCurve.h"
#include "MeshFront.h"

#include <cstddef>
#include <vector>

namespace SurfaceScalars
{

/**
 * The shortest straight way along a mesh from a place on an edge to a curve: a straight line once
 * the triangles on the way are unfolded into a plane. The shortest way of all is straight unless it
 * bends at a vertex, which only one with a total angle above 2 pi or on the boundary makes it do.
 *
 * What can be seen from the place through edges is followed from triangle to triangle as far as the
 * distances of a front from the curve leave hope for a shorter way, the more promising side first.
 * The front may be too large by a share of the distance and of the edge; where it is by more, the
 * way that is found may not be the shortest, but there is one of that length.
 *
 * Time and the number of views: some 3 w^2 for a curve at a distance of w edges.
 */
class StraightWays
{
public:
  /// @param front that has gone from the curve past all places @param mostViews of all searches
  StraightWays(const MeshTopology& mesh, const LevelCurve& curve, const MeshFront& front,
    std::size_t mostViews);

  /// The length of the shortest that is below a bound, or infinite if none was found.
  /// @param place on the edge between these vertices
  double shortest(const Vector3d& place, Index a, Index b, double bound);

  /// Whether there were too many views to look for the shortest way.
  bool isExhausted() const { return this->viewsLeft_ == 0; }

private:
  /// What is seen through an edge from the place, which is at the origin of the plane; right to
  /// left is counterclockwise.
  struct View
  {
    Index left;
    Index right;
    Index behind; ///< the third corner of the triangle on this side of the edge
    Vector2d leftPlace;
    Vector2d rightPlace;
    Vector2d leftmost; ///< directions that are seen
    Vector2d rightmost;
    double bound; ///< below all ways through it
  };

  Vector2d placeBeyond(const View& view, Index corner) const;
  void meet(const View& view, Index corner, const Vector2d& place);
  void pass(const View& view);
  void passInto(const View& view, Index corner);
  void push(const View& view);
  double boundOf(const View& view) const;
  template <class Visit>
  void forEachOpposite(Index a, Index b, const Visit& visit) const;

  const MeshTopology& mesh_;
  const LevelCurve& curve_;
  const MeshFront& front_;
  std::size_t viewsLeft_;
  std::vector<View> views_; ///< not followed so far
  double shortest_ = 0.0;   ///< or the bound
  bool isFound_ = false;
};

} // namespace SurfaceScalars
