#include "TriangleSearch.h"

#include <algorithm>
#include <cmath>

namespace SurfaceScalars
{
namespace
{

constexpr double SharpFraction = 0.25; // of the linear term: up to which the rest may be unknown

/// u - level around a place, as far as it is known.
struct Expansion
{
  bool isKnown = false;
  Vector3d center = Vector3d::Zero();
  double value = 0.0;
  Vector3d gradient = Vector3d::Zero();
  double curvature = 0.0;

  /// What the linear polynomial may miss at that distance.
  double rest(double distance) const
  {
    return 0.5 * LevelBound::Safety * this->curvature * distance * distance;
  }
  bool isSharpIn(const Ball& ball) const
  {
    return this->isKnown &&
      this->rest((ball.center - this->center).norm() + ball.radius) <=
      SharpFraction * this->gradient.norm() * ball.radius;
  }
  bool excludes(const LevelBound& bound, const Ball& ball) const;
};

bool Expansion::excludes(const LevelBound& bound, const Ball& ball) const
{
  if (!this->isKnown)
  {
    return false;
  }
  const Vector3d offset = ball.center - this->center;
  const double distance = offset.norm();
  const double least = std::abs(this->value + this->gradient.dot(offset)) - this->rest(distance);
  const double slope = this->gradient.norm() + LevelBound::Safety * this->curvature * distance;
  return bound.judge(ball, std::max(0.0, least), slope, this->curvature).isClear;
}

struct Candidate
{
  std::size_t block;
  Expansion expansion; ///< inherited, then its own
  bool isExcluded = false;
};

void examine(Candidate& candidate, const Ball& ball, const LevelBound& bound, LevelProbe& probe)
{
  Expansion& expansion = candidate.expansion;
  candidate.isExcluded = expansion.excludes(bound, ball);
  if (!candidate.isExcluded && !expansion.isSharpIn(ball) && bound.isSmall(ball))
  {
    const FieldJet jet = probe(ball.center, Derivatives::Hessian);
    expansion = { true, ball.center, jet.value, jet.gradient, jet.hessian.norm() };
    candidate.isExcluded = expansion.excludes(bound, ball);
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
      candidates[i].isExcluded = candidates[i].expansion.excludes(bound,
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
