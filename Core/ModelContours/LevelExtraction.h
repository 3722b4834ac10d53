#pragma once

#include "ContourRefinement.h"
#include "LevelSets.h"
#include "PatchSaddles.h"
#include "TriangleBlocks.h"
#include "VertexStars.h"

#include <memory>
#include <vector>

namespace SurfaceScalars
{

/// The level sets of a field on a mesh, one after the other.
class LevelExtraction
{
public:
  /// @param vertices relative to the origin of the field's cloud; they, the field and the triangles
  /// must outlive this
  LevelExtraction(const Field& field, const Points& vertices, const Triangles& triangles,
    const RefinementLimits& limits, const Execution& execution);

  /// The curves of a level, in the coordinates of the vertices; level and component are not set.
  std::vector<LevelSetCurve> trace(double level, const Execution& execution);

  // Of all levels so far:
  double largestDeviation() const { return this->largestDeviation_; }
  std::size_t evaluationCount() const { return this->evaluationCount_; }
  std::size_t evaluatedVertexCount() const;
  std::size_t undefinedCount() const { return this->undefinedCount_; }

private:
  struct RefinedPatch
  {
    ContourPatch patch;
    std::size_t undefinedCount = 0;
  };

  std::vector<Index> beyondEnds(const ContourPatch& patch, const std::vector<Index>& selected);
  RefinedPatch refined(LevelFunction& function, const LevelBound& bound,
    std::vector<Index>& selected, const SaddleCandidates& saddles, const Execution& execution);
  void measure(const RefinedPatch& refined);

  const Field& field_;
  const Points& vertices_;
  const Triangles& triangles_;
  RefinementLimits limits_;
  TriangleBlocks blocks_;
  std::unique_ptr<VertexStars> stars_; ///< once they have been needed
  std::vector<bool> isEvaluated_;      ///< vertices
  double largestDeviation_ = 0.0;
  std::size_t evaluationCount_ = 0;
  std::size_t undefinedCount_ = 0;
};

} // namespace SurfaceScalars
