#include "ContourRefinement.h"

#include "EdgeRoot.h"

#include <Eigen/Geometry>
#include <Eigen/QR>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace SurfaceScalars
{
namespace
{

constexpr std::array<double, 3> Checks{ 0.5, 0.25, 0.75 }; // of a segment
constexpr double FineFactor = 4.0;          // how much larger a ball must be in which u is smooth
constexpr std::size_t MostPieces = 2000000; // to be cut at once: a gigabyte
constexpr std::size_t ManyPieces = 200000;  // more than at first are too many: they fill an area
constexpr double StuckShare = 0.4;          // of a deviation, which a smooth u divides by four
constexpr double StageShare = 0.1;          // of the work left

} // namespace

ContourRefinement::ContourRefinement(ContourPatch& patch, LevelFunction& function,
  const LevelBound& bound, const RefinementLimits& limits, const Execution& execution)
  : patch_(patch)
  , function_(function)
  , bound_(bound)
  , limits_(limits)
  , execution_(execution)
{
}

void ContourRefinement::run()
{
  do
  {
    this->evaluateVertices();
    this->findCrossings();
    this->examinePieces();
  } while (this->cutUnsettled());
}

/// How much work is left is not known: each stage is a share of the rest.
Execution ContourRefinement::stage()
{
  const double from = this->done_;
  this->done_ += StageShare * (1.0 - from);
  return this->execution_.part(from, this->done_);
}

void ContourRefinement::evaluateVertices()
{
  std::vector<PatchVertex>& vertices = this->patch_.vertices;
  const std::size_t first = this->evaluated_;
  this->function_.forEach(vertices.size() - first, this->stage(),
    [&](std::size_t i, LevelProbe& probe)
    {
      PatchVertex& vertex = vertices[first + i];
      const FieldJet jet = probe(vertex.place, Derivatives::Gradient);
      vertex.height = vertex.node == PatchVertex::None ? jet.value : 0.0;
      vertex.gradient = jet.gradient;
    });
  this->evaluated_ = vertices.size();
  this->undefinedCount_ += this->patch_.dropUndefined();
}

void ContourRefinement::findCrossings()
{
  std::vector<ContourPatch::EdgeKey> crossed;
  for (const PatchPiece& piece : this->patch_.pieces)
  {
    for (std::size_t i = 0; i < 3 && !piece.isExamined; ++i)
    {
      const ContourPatch::EdgeKey key = ContourPatch::sideOf(piece, i);
      if (this->patch_.isCrossed(key) && this->patch_.edges[key].node == PatchVertex::None)
      {
        this->patch_.edges[key].node = this->patch_.addNode(Vector3d::Zero());
        crossed.push_back(key);
      }
    }
  }
  const std::size_t first = this->patch_.nodes.size() - crossed.size();
  this->function_.forEach(crossed.size(), this->stage(),
    [&](std::size_t i, LevelProbe& probe)
    {
      const auto [a, b] = ContourPatch::endsOf(crossed[i]);
      const PatchVertex& from = this->patch_.vertices[a];
      const PatchVertex& to = this->patch_.vertices[b];
      const Vector3d along = to.place - from.place;
      const double t = rootBetween({ from.height, from.gradient.dot(along) },
        { to.height, to.gradient.dot(along) },
        [&](double s)
        {
          const FieldJet jet = probe(from.place + s * along, Derivatives::Gradient);
          return Slope{ jet.value, jet.gradient.dot(along) };
        });
      this->patch_.nodes[first + i] = t < 1.0 ? Vector3d(from.place + t * along) : to.place;
    });
}

void ContourRefinement::examinePieces()
{
  std::vector<PatchPiece>& pieces = this->patch_.pieces;
  std::vector<std::size_t> fresh;
  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    if (!pieces[i].isExamined)
    {
      fresh.push_back(i);
    }
  }
  this->function_.forEach(fresh.size(), this->stage(),
    [&](std::size_t i, LevelProbe& probe) { this->examine(pieces[fresh[i]], probe); });
}

void ContourRefinement::examine(PatchPiece& piece, LevelProbe& probe) const
{
  piece.isExamined = true;
  const bool isCrossed = this->patch_.segment(piece).has_value();
  if (piece.isClear && !isCrossed)
  {
    piece.isSettled = true;
    return;
  }
  const Ball ball = this->patch_.ballAround(piece);
  const Vector3d normal = this->patch_.normal(piece);
  const PieceShape shape = this->shapeOf(piece, ball, normal, probe);
  const BallVerdict verdict = this->bound_.judge(ball, shape.value, shape.slope, shape.curvature);
  const double before =
    std::exchange(piece.deviation, this->deviation(piece, normal, shape, probe));
  piece.mayBeCritical = verdict.mayBeCritical;
  piece.isClear = verdict.isClear || verdict.isFlat;
  piece.isSettled = isCrossed ? verdict.isSteep && piece.deviation <= this->limits_.tolerance
                              : piece.isClear || (verdict.isSteep && !this->mayBulge(piece, shape));
  piece.isSettled = piece.isSettled || this->isStuck(piece, isCrossed, before, shape.isFine);
}

/// Whether a jump of u is what remains to be seen.
/// @param before the deviation of the piece that it was cut from
bool ContourRefinement::isStuck(
  const PatchPiece& piece, bool isCrossed, double before, bool isFine) const
{
  return this->bound_.isJumping() &&
    (isCrossed ? before > 0.0 && piece.deviation > StuckShare * before : isFine);
}

/// What is linear between the corners: the mean of the values and gradients, and the slope of the
/// gradient, which the turns to single corners do not show where these lie along a line.
FieldJet ContourRefinement::meanOfCorners(const PatchPiece& piece) const
{
  FieldJet mean{ 0.0, Vector3d::Zero(), Eigen::Matrix3d::Zero() };
  Eigen::Matrix<double, 3, 2> edges;
  Eigen::Matrix<double, 3, 2> turns;
  const PatchVertex& first = this->patch_.vertices[piece.corners[0]];
  for (int i = 0; i < 3; ++i)
  {
    const PatchVertex& vertex = this->patch_.vertices[piece.corners[static_cast<std::size_t>(i)]];
    mean.value += vertex.height / 3.0;
    mean.gradient += vertex.gradient / 3.0;
    if (i > 0)
    {
      edges.col(i - 1) = vertex.place - first.place;
      turns.col(i - 1) = vertex.gradient - first.gradient;
    }
  }
  mean.hessian = turns * edges.completeOrthogonalDecomposition().pseudoInverse();
  return mean;
}

/// From the corners alone where u is smooth on a far larger scale: the mean of the values there is
/// off by no more than the Taylor polynomial.
ContourRefinement::PieceShape ContourRefinement::shapeOf(
  const PatchPiece& piece, const Ball& ball, const Vector3d& normal, LevelProbe& probe) const
{
  PieceShape shape;
  shape.isFine = this->bound_.isSmall({ ball.center, FineFactor * ball.radius });
  FieldJet jet;
  if (shape.isFine)
  {
    jet = this->meanOfCorners(piece);
  }
  else
  {
    jet = probe(ball.center, Derivatives::Hessian);
  }
  const Eigen::Matrix3d along = Eigen::Matrix3d::Identity() - normal * normal.transpose();
  shape.value = jet.value;
  shape.slope = (along * jet.gradient).norm();
  shape.curvature = (along * jet.hessian * along).norm();
  for (const Index corner : piece.corners)
  {
    // The gradient may turn where the Hessian at the center happens to be small.
    const PatchVertex& vertex = this->patch_.vertices[corner];
    const double distance = (vertex.place - ball.center).norm();
    const double turn = (along * (vertex.gradient - jet.gradient)).norm();
    shape.curvature = std::max(shape.curvature, distance > 0.0 ? turn / distance : 0.0);
  }
  return shape;
}

/// Whether the level set may enter a piece, in which there is no critical point, through an edge
/// and leave it through the same, by more than the tolerance.
bool ContourRefinement::mayBulge(const PatchPiece& piece, const PieceShape& shape) const
{
  for (std::size_t i = 0; i < 3; ++i)
  {
    const PatchVertex& from = this->patch_.vertices[piece.corners[i]];
    const PatchVertex& to = this->patch_.vertices[piece.corners[(i + 1) % 3]];
    const double sagitta =
      LevelBound::Safety * shape.curvature * (to.place - from.place).squaredNorm() / 8.0;
    if (sagitta > std::min(std::abs(from.height), std::abs(to.height)) &&
      sagitta > this->limits_.tolerance * shape.slope)
    {
      return true;
    }
  }
  return false;
}

/// How far the segment in a piece, if there is one, is from the level set: to first order, and no
/// farther than from its ends.
double ContourRefinement::deviation(
  const PatchPiece& piece, const Vector3d& normal, const PieceShape& shape, LevelProbe& probe) const
{
  const std::optional<PatchSegment> segment = this->patch_.segment(piece);
  if (!segment)
  {
    return 0.0;
  }
  const Vector3d from = this->patch_.nodes[segment->from];
  const Vector3d along = this->patch_.nodes[segment->to] - from;
  // The sagitta of a curve of that curvature.
  const double foreseen =
    LevelBound::Safety * shape.curvature * along.squaredNorm() / (8.0 * shape.slope);
  if (shape.isFine && foreseen <= this->limits_.tolerance)
  {
    return foreseen;
  }
  double largest = 0.0;
  for (const double t : Checks)
  {
    const double toEnd = std::min(t, 1.0 - t) * along.norm();
    if (toEnd <= largest)
    {
      continue;
    }
    const FieldJet jet = probe(from + t * along, Derivatives::Gradient);
    const double slope = alongPlane(jet.gradient, normal).norm();
    const double value = std::max(0.0, std::abs(jet.value) - this->bound_.rounding());
    // At a critical point to second order.
    const double reach = 0.5 * shape.curvature * this->limits_.tolerance;
    const double distance = value / std::max(slope, reach);
    largest = std::max(largest, std::isfinite(distance) ? std::min(distance, toEnd) : toEnd);
  }
  return largest;
}

bool ContourRefinement::cutUnsettled()
{
  std::vector<const PatchPiece*> unsettled;
  for (const PatchPiece& piece : this->patch_.pieces)
  {
    if (!piece.isSettled && piece.halvings < 2 * this->limits_.maximumDepth)
    {
      unsettled.push_back(&piece);
    }
  }
  const bool isFirst = this->firstCut_ == 0;
  const std::size_t most = isFirst ? MostPieces : std::max(ManyPieces, this->firstCut_);
  if (unsettled.empty() || unsettled.size() > most)
  {
    return false;
  }
  this->firstCut_ = isFirst ? unsettled.size() : this->firstCut_;
  for (const PatchPiece* piece : unsettled)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const ContourPatch::EdgeKey key = ContourPatch::sideOf(*piece, i);
      PatchEdge& edge = this->patch_.edges[key];
      if (edge.midpoint == PatchVertex::None)
      {
        const auto [a, b] = ContourPatch::endsOf(key);
        edge.midpoint = this->patch_.addVertex(
          0.5 * (this->patch_.vertices[a].place + this->patch_.vertices[b].place));
      }
    }
  }
  this->patch_.cut();
  return true;
}

} // namespace SurfaceScalars
