#include "TriangleSearch.h"

#include <algorithm>
#include <cmath>

namespace SurfaceScalars
{
namespace
{

constexpr double SharpFraction = 0.25; // of the linear term: up to which the rest may be unknown

/// u - level in the ball around a place that it was expanded for, as far as it is known.
struct Expansion
{
  bool isKnown = false;
  Vector3d center = Vector3d::Zero();
  double value = 0.0;
  Vector3d gradient = Vector3d::Zero();
  double curvature = 0.0;
  double unseen = 0.0;

  /// What the linear polynomial may miss in a part of the ball.
  double rest(const Ball& part) const
  {
    const double distance = (part.center - this->center).norm() + part.radius;
    return 0.5 * LevelBound::Safety * this->curvature * distance * distance + this->unseen;
  }
  bool isSharpIn(const Ball& part) const
  {
    return this->isKnown && this->rest(part) <= SharpFraction * this->gradient.norm() * part.radius;
  }
  bool excludes(const Ball& part) const
  {
    const double middle = this->value + this->gradient.dot(part.center - this->center);
    return this->isKnown &&
      std::abs(middle) > this->gradient.norm() * part.radius + this->rest(part);
  }
};

struct Candidate
{
  std::size_t block;
  Expansion expansion; ///< inherited, then its own
  bool isExcluded = false;
};

void examine(Candidate& candidate, const Ball& ball, const LevelBound& bound, LevelProbe& probe)
{
  Expansion& expansion = candidate.expansion;
  candidate.isExcluded = bound.isClear(ball) || expansion.excludes(ball);
  if (!candidate.isExcluded && !expansion.isSharpIn(ball) && bound.isSmall(ball))
  {
    const FieldJet jet = probe(ball.center, Derivatives::Hessian);
    expansion = { true, ball.center, jet.value, jet.gradient, jet.hessian.norm(),
      bound.unseen(ball).value };
    candidate.isExcluded = expansion.excludes(ball);
  }
}

std::vector<Candidate> partsOf(
  const std::vector<Candidate>& candidates, const TriangleBlocks& blocks, std::size_t layer)
{
  std::vector<Candidate> result;
  for (const Candidate& candidate : candidates)
  {
    const auto [first, end] = blocks.parts(layer, candidate.block);
    for (std::size_t part = first; !candidate.isExcluded && part < end; ++part)
    {
      result.push_back({ part, candidate.expansion });
    }
  }
  return result;
}

} // namespace

Ball ballAround(const Vector3d& a, const Vector3d& b, const Vector3d& c)
{
  const Vector3d center = (a + b + c) / 3.0;
  return { center,
    std::sqrt(std::max(
      { (a - center).squaredNorm(), (b - center).squaredNorm(), (c - center).squaredNorm() })) };
}

std::vector<Index> trianglesNear(LevelFunction& function, const LevelBound& bound,
  const Points& vertices, const Triangles& triangles, const TriangleBlocks& blocks,
  const Execution& execution)
{
  const std::size_t layers = blocks.layerCount();
  std::vector<Candidate> candidates;
  for (std::size_t block = 0; block < blocks.layer(layers - 1).size(); ++block)
  {
    candidates.push_back({ block, {} });
  }
  for (std::size_t layer = layers; layer-- > 0;)
  {
    const double done = static_cast<double>(layers - layer) / static_cast<double>(layers + 1);
    function.forEach(candidates.size(),
      execution.part(done - 1.0 / static_cast<double>(layers + 1), done),
      [&](std::size_t i, LevelProbe& probe)
      { examine(candidates[i], blocks.layer(layer)[candidates[i].block], bound, probe); });
    candidates = partsOf(candidates, blocks, layer);
  }
  function.forEach(candidates.size(), execution.part(1.0, 1.0),
    [&](std::size_t i, LevelProbe&)
    {
      const auto corners = triangles.col(blocks.triangle(candidates[i].block));
      candidates[i].isExcluded = candidates[i].expansion.excludes(
        ballAround(vertices.col(corners(0)), vertices.col(corners(1)), vertices.col(corners(2))));
    });
  std::vector<Index> result;
  for (const Candidate& candidate : candidates)
  {
    if (!candidate.isExcluded)
    {
      result.push_back(blocks.triangle(candidate.block));
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

} // namespace SurfaceScalars
