#include "SaddleCandidates.h"

#include "EdgeRoot.h"
#include "SaddleRing.h"

#include <Eigen/Dense>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace SurfaceScalars
{
namespace
{

constexpr int MostNewtonSteps = 60;       // a degenerate point is approached by half each
constexpr double FarthestFromStart = 4.0; // radii of the piece
constexpr double SamePlace = 1e-4;        // of the piece where a point was first looked for
constexpr std::size_t MostPlaces = 2000;  // more than that are no saddles but a ridge

/// A place found, and the length that it was looked for on.
struct Found
{
  PatchPlace candidate;
  double scale;
};

/// A saddle of u in the plane of a piece, near it.
std::optional<Found> saddleInPlane(const ContourPatch& patch, const PatchPiece& piece,
  const LevelBound& bound, const Field& field, LevelProbe& probe)
{
  const Vector3d normal = patch.normal(piece);
  if (normal.isZero())
  {
    return {};
  }
  Eigen::Matrix<double, 3, 2> axes;
  axes.col(0) = normal.unitOrthogonal();
  axes.col(1) = normal.cross(axes.col(0));
  const Ball ball = patch.ballAround(piece);
  Vector3d place = ball.center;
  double step = ball.radius;
  for (int i = 0; i < MostNewtonSteps && step > 1e-13 * ball.radius; ++i)
  {
    const FieldJet jet = probe(place, Derivatives::Hessian);
    const Eigen::Matrix2d hessian = axes.transpose() * jet.hessian * axes;
    const Vector2d gradient = axes.transpose() * jet.gradient;
    const Vector2d move = -hessian.completeOrthogonalDecomposition().solve(gradient);
    place += axes * (move * std::min(1.0, ball.radius / move.norm()));
    step = move.norm();
    if (!((place - ball.center).norm() <= FarthestFromStart * ball.radius))
    {
      return {};
    }
  }
  const double radius = ringRadius(field, place);
  const bool isSaddle = std::abs(probe(place, Derivatives::None).value) <= bound.criticalMargin() &&
    !SaddleRing(place, axes, radius).view(radius, bound.rounding(), probe).marks.empty();
  return isSaddle ? std::optional<Found>({ { piece.triangle, place }, ball.radius }) : std::nullopt;
}

/// An edge between two triangles of the mesh.
struct MeshEdge
{
  ContourPatch::EdgeKey key;
  std::array<const PatchPiece*, 2> sides;
};

/// Along a piece, away from one of its sides.
Vector3d inwards(const ContourPatch& patch, const PatchPiece& piece, ContourPatch::EdgeKey side)
{
  const auto [a, b] = ContourPatch::endsOf(side);
  const Vector3d& from = patch.vertices[a].place;
  const Vector3d along = (patch.vertices[b].place - from).normalized();
  Vector3d inwards = Vector3d::Zero();
  for (const Index corner : piece.corners)
  {
    const Vector3d offset = patch.vertices[corner].place - from;
    inwards += offset - offset.dot(along) * along; // 0 for the ends
  }
  return inwards;
}

/// An extremum of u along an edge of the mesh, a maximum if u rises from there to both sides.
std::optional<Found> saddleOnEdge(
  const ContourPatch& patch, const MeshEdge& edge, double margin, LevelProbe& probe)
{
  const auto [a, b] = ContourPatch::endsOf(edge.key);
  const PatchVertex& from = patch.vertices[a];
  const PatchVertex& to = patch.vertices[b];
  const Vector3d along = to.place - from.place;
  const double start = from.gradient.dot(along);
  const double end = to.gradient.dot(along);
  if ((start < 0.0) == (end < 0.0))
  {
    return {};
  }
  const double t = rootBetween({ start, end - start }, { end, end - start },
    [&](double s)
    {
      const FieldJet jet = probe(from.place + s * along, Derivatives::Hessian);
      return Slope{ jet.gradient.dot(along), along.dot(jet.hessian * along) };
    });
  const Vector3d place = from.place + t * along;
  const FieldJet jet = probe(place, Derivatives::Gradient);
  const bool isMinimum = start < 0.0;
  const bool isSaddle = std::all_of(edge.sides.begin(), edge.sides.end(),
    [&](const PatchPiece* side)
    { return (jet.gradient.dot(inwards(patch, *side, edge.key)) < 0.0) == isMinimum; });
  if (!isSaddle || !(std::abs(jet.value) <= margin))
  {
    return {};
  }
  return Found{ { edge.sides[0]->triangle, place }, along.norm() };
}

/// Those between two pieces of different triangles; ascending.
std::vector<MeshEdge> meshEdges(const ContourPatch& patch)
{
  std::vector<std::pair<ContourPatch::EdgeKey, const PatchPiece*>> sides;
  for (const PatchPiece& piece : patch.pieces)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      sides.emplace_back(ContourPatch::sideOf(piece, i), &piece);
    }
  }
  std::sort(sides.begin(), sides.end());
  std::vector<MeshEdge> result;
  for (std::size_t i = 1; i < sides.size(); ++i)
  {
    const auto& [key, piece] = sides[i];
    const PatchPiece* other = sides[i - 1].second;
    if (key == sides[i - 1].first && piece->triangle != other->triangle)
    {
      result.push_back({ key, { other, piece } });
    }
  }
  return result;
}

std::vector<PatchPlace> distinct(const std::vector<std::optional<Found>>& found)
{
  std::vector<PatchPlace> result;
  for (const std::optional<Found>& one : found)
  {
    // From beside a triangle's side one is found on both; one of these does not lie on its
    // triangle.
    const auto isHere = [&](const PatchPlace& other)
    {
      return other.triangle == one->candidate.triangle &&
        (other.place - one->candidate.place).norm() <= SamePlace * one->scale;
    };
    if (one && std::none_of(result.begin(), result.end(), isHere))
    {
      result.push_back(one->candidate);
    }
    if (result.size() > MostPlaces)
    {
      return {};
    }
  }
  return result;
}

} // namespace

SaddleCandidates saddleCandidates(const ContourPatch& patch, LevelFunction& function,
  const LevelBound& bound, const Execution& execution)
{
  std::vector<const PatchPiece*> pieces;
  for (const PatchPiece& piece : patch.pieces)
  {
    if (piece.mayBeCritical)
    {
      pieces.push_back(&piece);
    }
  }
  const std::vector<MeshEdge> edges = meshEdges(patch);
  const double margin = bound.criticalMargin();
  std::vector<std::optional<Found>> onEdges(edges.size());
  std::vector<std::optional<Found>> inTriangles(pieces.size());
  function.forEach(edges.size() + pieces.size(), execution,
    [&](std::size_t i, LevelProbe& probe)
    {
      (i < edges.size() ? onEdges[i] : inTriangles[i - edges.size()]) = i < edges.size()
        ? saddleOnEdge(patch, edges[i], margin, probe)
        : saddleInPlane(patch, *pieces[i - edges.size()], bound, function.field(), probe);
    });
  SaddleCandidates result{ distinct(onEdges), distinct(inTriangles), {} };
  for (const PatchVertex& vertex : patch.vertices)
  {
    if (vertex.meshVertex != PatchVertex::None && std::abs(vertex.height) <= margin)
    {
      result.meshVertices.push_back(vertex.meshVertex);
    }
  }
  std::sort(result.meshVertices.begin(), result.meshVertices.end());
  return result;
}

} // namespace SurfaceScalars
