#include "PatchSaddles.h"

#include "SaddleRing.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace SurfaceScalars
{
namespace
{

constexpr double DentReach = 3.0; // of the distance at which the level's branches are clear

/// A saddle with what makes its value the level's.
struct PinnedSaddle
{
  Index vertex;
  SaddleView view;
  double reach; ///< of the ring: a candidate nearer than that is the same
  Dent dent;
};

std::optional<PinnedSaddle> saddleAt(const ContourPatch& patch, Index vertex, const PatchStar& star,
  const LevelBound& bound, const Field& field, LevelProbe& probe)
{
  const std::vector<Index> link = linkOf(patch, vertex, star);
  if (link.empty())
  {
    return {};
  }
  const PatchVertex& center = patch.vertices[vertex];
  const SaddleRing ring(patch, vertex, link, star);
  const double radius = ringRadius(field, center.place);
  if (center.meshVertex != PatchVertex::None && ring.isRegular(radius, bound.rounding(), probe))
  {
    return {};
  }
  const SaddleView view = ring.view(radius, bound.rounding(), probe);
  if (view.marks.empty())
  {
    return {};
  }
  // As far as the height is that of a hyperbola, or of the branches of a degenerate saddle.
  const double height = probe(center.place, Derivatives::None).value;
  const double share = std::abs(height) / view.height;
  const double reach = DentReach * std::max(std::sqrt(share), std::cbrt(share * radius));
  return PinnedSaddle{ vertex, view, std::min(radius, ring.reach()),
    { center.place, reach, height } };
}

/// Those of some vertices that are saddles, in their order.
std::vector<PinnedSaddle> saddlesAt(const std::vector<Index>& vertices, const ContourPatch& patch,
  LevelFunction& function, const LevelBound& bound, const Execution& execution)
{
  const std::vector<PatchStar> stars = starsOf(patch, vertices);
  std::vector<std::optional<PinnedSaddle>> found(vertices.size());
  function.forEach(vertices.size(), execution,
    [&](std::size_t i, LevelProbe& probe)
    { found[i] = saddleAt(patch, vertices[i], stars[i], bound, function.field(), probe); });
  std::vector<PinnedSaddle> result;
  for (const std::optional<PinnedSaddle>& saddle : found)
  {
    if (saddle)
    {
      result.push_back(*saddle);
    }
  }
  return result;
}

std::vector<Index> patchVerticesOf(
  const ContourPatch& patch, const std::vector<Index>& meshVertices)
{
  std::vector<Index> vertices;
  for (Index i = 0; i < patch.vertices.size(); ++i)
  {
    if (std::binary_search(meshVertices.begin(), meshVertices.end(), patch.vertices[i].meshVertex))
    {
      vertices.push_back(i);
    }
  }
  return vertices;
}

} // namespace

bool pinSaddles(const SaddleCandidates& candidates, ContourPatch& patch, LevelFunction& function,
  const LevelBound& bound, const Execution& execution)
{
  std::vector<PinnedSaddle> saddles =
    saddlesAt(patchVerticesOf(patch, candidates.meshVertices), patch, function, bound, execution);
  const auto add = [&](const PatchPlace& candidate)
  {
    const auto isSame = [&](const PinnedSaddle& other)
    { return (other.dent.center - candidate.place).norm() < other.reach; };
    if (std::any_of(saddles.begin(), saddles.end(), isSame))
    {
      return;
    }
    if (const std::optional<Index> vertex = insertVertex(patch, candidate))
    {
      const std::vector<PinnedSaddle> found =
        saddlesAt({ *vertex }, patch, function, bound, execution.part(1.0, 1.0));
      saddles.insert(saddles.end(), found.begin(), found.end());
    }
  };
  std::for_each(candidates.onEdges.begin(), candidates.onEdges.end(), add);
  std::for_each(candidates.inTriangles.begin(), candidates.inTriangles.end(), add);
  for (const PinnedSaddle& saddle : saddles)
  {
    patch.pin(saddle.vertex);
    if (saddle.dent.height != 0.0)
    {
      function.add(saddle.dent);
    }
    for (const PatchPlace& mark : saddle.view.marks)
    {
      insertVertex(patch, mark);
    }
  }
  return !saddles.empty();
}

} // namespace SurfaceScalars
