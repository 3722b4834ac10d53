#include "PatchSaddles.h"

#include "EdgeRoot.h"
#include "SaddleRing.h"

#include <Eigen/Dense>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace SurfaceScalars
{
namespace
{

constexpr int MostNewtonSteps = 60;       // a degenerate point is approached by half each
constexpr double FarthestFromStart = 4.0; // radii of the piece
constexpr double SamePlace = 1e-4;        // of the piece where a point was first looked for
constexpr double ExpectedFraction = 0.1;  // of the change along an edge, to which it is foreseen
constexpr double RingFraction = 0.02;     // of the distance to the nearest few centers
constexpr int NearCenters = 4;
constexpr double FlatAngle = 1e-9;
constexpr std::size_t MostPlaces = 2000; // more than that are no saddles but a ridge
constexpr int MostRings = 4;
constexpr double RingRatio = 0.125;      // of the radius of one to that of the one before
constexpr std::size_t FewestSectors = 4; // around a saddle
constexpr double DentReach = 3.0;        // of the distance at which the level's branches are clear

/// A place found, and the length that it was looked for on.
struct Found
{
  PatchPlace candidate;
  double scale;
};

/// Of a ring on which u is what its Taylor polynomial says.
double ringRadius(const Field& field, const Vector3d& place)
{
  Neighborhood near;
  field.cloud().nearest(place, NearCenters, near);
  return RingFraction * std::sqrt(near.squaredDistances.back());
}

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
    SaddleRing(place, axes, radius).sectors(radius, bound.rounding(), probe).size() >=
      FewestSectors;
  return isSaddle ? std::optional<Found>({ { piece.triangle, place }, ball.radius }) : std::nullopt;
}

/// An extremum of u along an edge between two triangles of the mesh.
std::optional<Found> extremumOnEdge(const ContourPatch& patch, ContourPatch::EdgeKey key,
  Index triangle, double margin, LevelProbe& probe)
{
  const auto [a, b] = ContourPatch::endsOf(key);
  const PatchVertex& from = patch.vertices[a];
  const PatchVertex& to = patch.vertices[b];
  const Vector3d along = to.place - from.place;
  const double start = from.gradient.dot(along);
  const double end = to.gradient.dot(along);
  if ((start < 0.0) == (end < 0.0))
  {
    return {};
  }
  const double expected = from.height + 0.5 * start * start / (start - end);
  if (std::abs(expected) > ExpectedFraction * (std::abs(start) + std::abs(end)) + 2.0 * margin)
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
  if (!(std::abs(probe(place, Derivatives::None).value) <= margin))
  {
    return {};
  }
  return Found{ { triangle, place }, along.norm() };
}

/// The edges between pieces of different triangles, with one of these; ascending.
std::vector<std::pair<ContourPatch::EdgeKey, Index>> meshEdges(const ContourPatch& patch)
{
  std::vector<std::pair<ContourPatch::EdgeKey, Index>> sides;
  for (const PatchPiece& piece : patch.pieces)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      sides.emplace_back(ContourPatch::sideOf(piece, i), piece.triangle);
    }
  }
  std::sort(sides.begin(), sides.end());
  std::vector<std::pair<ContourPatch::EdgeKey, Index>> result;
  for (std::size_t i = 1; i < sides.size(); ++i)
  {
    if (sides[i].first == sides[i - 1].first && sides[i].second != sides[i - 1].second)
    {
      result.push_back(sides[i]);
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

/// A saddle with what makes its value the level's.
struct PinnedSaddle
{
  Index vertex;
  std::vector<Sector> sectors;
  Dent dent;
};

bool isPlane(const ContourPatch& patch, const PatchStar& star)
{
  const Vector3d normal = patch.normal(patch.pieces[star.front()]);
  return std::all_of(star.begin(), star.end(),
    [&](std::size_t i) { return patch.normal(patch.pieces[i]).cross(normal).norm() <= FlatAngle; });
}

std::optional<PinnedSaddle> saddleAt(const ContourPatch& patch, Index vertex, const PatchStar& star,
  const LevelBound& bound, const Field& field, LevelProbe& probe)
{
  const std::vector<Index> link = linkOf(patch, vertex, star);
  if (link.empty())
  {
    return {};
  }
  const Vector3d& place = patch.vertices[vertex].place;
  const SaddleRing ring(patch, vertex, link, star);
  PinnedSaddle saddle{ vertex, {}, {} };
  // Where the mesh bends by little, what is a saddle for that is seen from close by only.
  double radius = ringRadius(field, place);
  const int rings = isPlane(patch, star) ? 1 : MostRings;
  for (int i = 0; i < rings && saddle.sectors.size() < FewestSectors; ++i)
  {
    radius *= i > 0 ? RingRatio : 1.0;
    saddle.sectors = ring.sectors(radius, bound.rounding(), probe);
  }
  if (saddle.sectors.size() < FewestSectors)
  {
    return {};
  }
  double least = std::numeric_limits<double>::infinity();
  for (const Sector& sector : saddle.sectors)
  {
    least = std::min(least, sector.height);
  }
  // As far as the height is that of a hyperbola, or of the branches of a degenerate saddle.
  const double height = probe(place, Derivatives::None).value;
  const double share = std::abs(height) / least;
  saddle.dent = { place, DentReach * std::max(std::sqrt(share), std::cbrt(share * radius)),
    height };
  return saddle;
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
  const auto edges = meshEdges(patch);
  const double margin = bound.criticalMargin();
  std::vector<std::optional<Found>> found(pieces.size() + edges.size());
  function.forEach(found.size(), execution,
    [&](std::size_t i, LevelProbe& probe)
    {
      found[i] = i < pieces.size()
        ? saddleInPlane(patch, *pieces[i], bound, function.field(), probe)
        : extremumOnEdge(
            patch, edges[i - pieces.size()].first, edges[i - pieces.size()].second, margin, probe);
    });
  SaddleCandidates result{ distinct(found), {} };
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

bool pinSaddles(const SaddleCandidates& candidates, ContourPatch& patch, LevelFunction& function,
  const LevelBound& bound, const Execution& execution)
{
  std::vector<Index> vertices;
  for (Index i = 0; i < patch.vertices.size(); ++i)
  {
    if (std::binary_search(candidates.meshVertices.begin(), candidates.meshVertices.end(),
          patch.vertices[i].meshVertex))
    {
      vertices.push_back(i);
    }
  }
  for (const PatchPlace& candidate : candidates.places)
  {
    if (const std::optional<Index> vertex = insertVertex(patch, candidate))
    {
      vertices.push_back(*vertex);
    }
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  const std::vector<PatchStar> stars = starsOf(patch, vertices);
  std::vector<std::optional<PinnedSaddle>> saddles(vertices.size());
  function.forEach(vertices.size(), execution,
    [&](std::size_t i, LevelProbe& probe)
    { saddles[i] = saddleAt(patch, vertices[i], stars[i], bound, function.field(), probe); });
  bool isAny = false;
  for (const std::optional<PinnedSaddle>& saddle : saddles)
  {
    if (!saddle)
    {
      continue;
    }
    isAny = true;
    patch.pin(saddle->vertex);
    if (saddle->dent.height != 0.0)
    {
      function.add(saddle->dent);
    }
    for (const Sector& sector : saddle->sectors)
    {
      insertVertex(
        patch, sector.peak); // so that the link has vertices on both sides of every branch
    }
  }
  return isAny;
}

} // namespace SurfaceScalars
