#pragma once

#include "ContourPatch.h"

namespace SurfaceScalars
{

/// The part of a vector along the plane of a unit normal; all of it if the normal is 0.
inline Vector3d alongPlane(const Vector3d& vector, const Vector3d& normal)
{
  return vector - vector.dot(normal) * normal;
}

struct RefinementLimits
{
  double tolerance; ///< of the distance between segments and the level set, length
  int maximumDepth; ///< how often a triangle is cut
};

/**
 * Cuts the pieces of a patch until the level set in each is one segment, at most the tolerance from
 * it, or it is known to have none there (design paper, sec. 6.1; see LevelBound).
 *
 * All levels of depth are done one after the other: the edges of pieces that are not good are cut
 * in the middle, their neighbors with them. Where that would take a gigabyte, as for levels of a
 * plateau, or a jump of a local scheme does not become smaller, it ends. A crossing is the root of
 * u - level on its edge, found once, from the vertex of the lower index: neighbors agree to the
 * bit.
 */
class ContourRefinement
{
public:
  ContourRefinement(ContourPatch& patch, LevelFunction& function, const LevelBound& bound,
    const RefinementLimits& limits, const Execution& execution);

  void run();
  /// Places of u that are not defined, at which curves end.
  std::size_t undefinedCount() const { return this->undefinedCount_; }

private:
  void evaluateVertices();
  void findCrossings();
  void examinePieces();
  void examine(PatchPiece& piece, LevelProbe& probe) const;
  /// u - level on a piece.
  struct PieceShape
  {
    double value = 0.0; ///< in the middle
    double slope = 0.0; ///< there, along the plane
    double curvature = 0.0;
    bool isFine = false; ///< known from the corners
  };
  FieldJet meanOfCorners(const PatchPiece& piece) const;
  PieceShape shapeOf(
    const PatchPiece& piece, const Ball& ball, const Vector3d& normal, LevelProbe& probe) const;
  bool isStuck(const PatchPiece& piece, bool isCrossed, double before, bool isFine) const;
  bool mayBulge(const PatchPiece& piece, const PieceShape& shape) const;
  double deviation(const PatchPiece& piece, const Vector3d& normal, const PieceShape& shape,
    LevelProbe& probe) const;
  bool cutUnsettled();
  Execution stage();

  ContourPatch& patch_;
  LevelFunction& function_;
  const LevelBound& bound_;
  RefinementLimits limits_;
  Execution execution_;
  double done_ = 0.0;
  std::size_t evaluated_ = 0; ///< vertices
  std::size_t firstCut_ = 0;  ///< pieces
  std::size_t undefinedCount_ = 0;
};

} // namespace SurfaceScalars
