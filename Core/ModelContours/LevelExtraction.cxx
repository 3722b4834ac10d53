#include "LevelExtraction.h"

#include "PatchCurves.h"
#include "TriangleSearch.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <unordered_map>

namespace SurfaceScalars
{
namespace
{

constexpr double TurnShare = 0.8; // of the work left: how many turns it takes is not known
constexpr double PinShare = 0.1;  // of a turn

/// The pieces at edges that the level set crosses and that have no other piece: in which curves
/// end.
std::vector<const PatchPiece*> endsOf(const ContourPatch& patch)
{
  std::unordered_map<ContourPatch::EdgeKey, const PatchPiece*> single;
  for (const PatchPiece& piece : patch.pieces)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const ContourPatch::EdgeKey side = ContourPatch::sideOf(piece, i);
      if (patch.isCrossed(side))
      {
        const auto [found, isNew] = single.emplace(side, &piece);
        found->second = isNew ? &piece : nullptr;
      }
    }
  }
  std::vector<const PatchPiece*> ends;
  for (const auto& [side, piece] : single)
  {
    if (piece)
    {
      ends.push_back(piece);
    }
  }
  return ends;
}

/// The first-order distances of the curves' points from the level set.
void setResiduals(
  std::vector<LevelSetCurve>& curves, LevelFunction& function, const Execution& execution)
{
  std::vector<LevelSetPoint*> points;
  for (LevelSetCurve& curve : curves)
  {
    for (LevelSetPoint& point : curve.points)
    {
      points.push_back(&point);
    }
  }
  function.forEach(points.size(), execution,
    [&](std::size_t i, LevelProbe& probe)
    {
      const FieldJet jet = probe(points[i]->position, Derivatives::Gradient);
      const double slope = alongPlane(jet.gradient, points[i]->normal).norm();
      points[i]->residual = slope > 0.0 ? std::abs(jet.value) / slope : 0.0;
    });
}

} // namespace

LevelExtraction::LevelExtraction(const Field& field, const Points& vertices,
  const Triangles& triangles, const RefinementLimits& limits, const Execution& execution)
  : field_(field)
  , vertices_(vertices)
  , triangles_(triangles)
  , limits_(limits)
  , blocks_(vertices, triangles, execution)
  , isEvaluated_(static_cast<std::size_t>(vertices.cols()))
{
}

std::size_t LevelExtraction::evaluatedVertexCount() const
{
  return static_cast<std::size_t>(
    std::count(this->isEvaluated_.begin(), this->isEvaluated_.end(), true));
}

/// The triangles around those in which curves end, that are not selected yet; ascending.
std::vector<Index> LevelExtraction::beyondEnds(
  const ContourPatch& patch, const std::vector<Index>& selected)
{
  std::vector<Index> found;
  for (const PatchPiece* piece : endsOf(patch))
  {
    if (!this->stars_)
    {
      this->stars_ = std::make_unique<VertexStars>(this->vertices_.cols(), this->triangles_);
    }
    for (const Index corner : this->triangles_.col(piece->triangle))
    {
      const VertexRange star = this->stars_->of(corner);
      found.insert(found.end(), star.begin(), star.end());
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  std::vector<Index> added;
  std::set_difference(
    found.begin(), found.end(), selected.begin(), selected.end(), std::back_inserter(added));
  return added;
}

/// The patch of the selected triangles, and of those beyond that curves lead into. With saddles, if
/// none of the candidates is one, it is not refined.
LevelExtraction::RefinedPatch LevelExtraction::refined(LevelFunction& function,
  const LevelBound& bound, std::vector<Index>& selected, const SaddleCandidates& saddles,
  const Execution& execution)
{
  for (double done = 0.0;; done += TurnShare * (1.0 - done))
  {
    const Execution turn = execution.part(done, done + TurnShare * (1.0 - done));
    ContourPatch patch(this->vertices_, this->triangles_, selected);
    if (!saddles.empty() && !pinSaddles(saddles, patch, function, bound, turn.part(0.0, PinShare)))
    {
      return { std::move(patch), 0 };
    }
    ContourRefinement refinement(patch, function, bound, this->limits_, turn.part(PinShare, 1.0));
    refinement.run();
    const std::vector<Index> added = this->beyondEnds(patch, selected);
    if (added.empty())
    {
      return { std::move(patch), refinement.undefinedCount() };
    }
    std::vector<Index> all;
    std::merge(
      selected.begin(), selected.end(), added.begin(), added.end(), std::back_inserter(all));
    selected = std::move(all);
  }
}

void LevelExtraction::measure(const RefinedPatch& refined)
{
  for (const PatchPiece& piece : refined.patch.pieces)
  {
    this->largestDeviation_ = std::max(this->largestDeviation_, piece.deviation);
  }
  for (const PatchVertex& vertex : refined.patch.vertices)
  {
    if (vertex.meshVertex != PatchVertex::None)
    {
      this->isEvaluated_[vertex.meshVertex] = true;
    }
  }
  this->undefinedCount_ += refined.undefinedCount;
}

std::vector<LevelSetCurve> LevelExtraction::trace(double level, const Execution& execution)
{
  const auto plateau = PlateauLevel::find(this->field_, this->vertices_, level);
  if (plateau && !plateau->hasRims())
  {
    return {};
  }
  LevelFunction function = plateau ? LevelFunction(*plateau) : LevelFunction(this->field_, level);
  const LevelBound bound(function);
  std::vector<Index> selected = trianglesNear(
    function, bound, this->vertices_, this->triangles_, this->blocks_, execution.part(0.0, 0.1));
  RefinedPatch result = this->refined(function, bound, selected, {}, execution.part(0.1, 0.5));
  const SaddleCandidates candidates =
    saddleCandidates(result.patch, function, bound, execution.part(0.5, 0.6));
  if (!candidates.empty())
  {
    RefinedPatch pinned =
      this->refined(function, bound, selected, candidates, execution.part(0.6, 0.9));
    if (pinned.patch.hasSaddles())
    {
      result = std::move(pinned);
    }
  }
  this->measure(result);
  std::vector<LevelSetCurve> curves = curvesOf(result.patch);
  setResiduals(curves, function, execution.part(0.9, 1.0));
  this->evaluationCount_ += function.evaluationCount();
  return curves;
}

} // namespace SurfaceScalars
