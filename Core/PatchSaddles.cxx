#include "PatchSaddles.h"

#include "ContourRefinement.h"
#include "EdgeRoot.h"

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
constexpr int RingSize = 64;              // places, about
constexpr double RingFraction = 0.02;     // of the distance to the nearest few centers
constexpr int NearCenters = 4;
constexpr double ClearFraction = 1e-3; // of the largest height on a ring
constexpr double DentReach = 3.0;      // of the distance at which the level's branches are clear

/// A place found, and the length that it was looked for on.
struct Found
{
  PatchPlace candidate;
  double scale;
};

/// A critical point of u in the plane of a piece, near it.
std::optional<Found> criticalPoint(
  const ContourPatch& patch, const PatchPiece& piece, double margin, LevelProbe& probe)
{
  const Vector3d normal = normalOf(patch, piece);
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
  if (!(std::abs(probe(place, Derivatives::None).value) <= margin))
  {
    return {};
  }
  return Found{ { piece.triangle, place }, ball.radius };
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
    const auto isHere = [&](const PatchPlace& other)
    { return (other.place - one->candidate.place).norm() <= SamePlace * one->scale; };
    if (one && std::none_of(result.begin(), result.end(), isHere))
    {
      result.push_back(one->candidate);
    }
  }
  return result;
}

/// Where u - u(p) has one sign around a vertex p.
struct Sector
{
  bool isAbove;
  double height;   ///< the largest |u - u(p)|, by the squared distance from p
  PatchPlace peak; ///< where that is, moved on to the link
};

/// The places around a vertex, evenly by angle.
class Ring
{
public:
  /// @param link of the center, in cyclic order @param star the pieces around it
  Ring(const ContourPatch& patch, Index center, const std::vector<Index>& link,
    const std::vector<std::size_t>& star);

  /// In cyclic order, on a ring of at most this radius; places where the sign is not clear count
  /// for none.
  std::vector<Sector> sectors(double radius, double rounding, LevelProbe& probe) const;

private:
  Vector3d center_;
  std::vector<PatchPlace> places_; ///< on the link
};

Ring::Ring(const ContourPatch& patch, Index center, const std::vector<Index>& link,
  const std::vector<std::size_t>& star)
  : center_(patch.vertices[center].place)
{
  for (std::size_t i = 0; i < link.size(); ++i)
  {
    const std::array<Index, 2> side{ link[i], link[(i + 1) % link.size()] };
    const auto triangle = std::find_if(star.begin(), star.end(),
      [&](std::size_t piece)
      {
        const std::array<Index, 3>& corners = patch.pieces[piece].corners;
        return std::count(corners.begin(), corners.end(), side[0]) +
          std::count(corners.begin(), corners.end(), side[1]) ==
          2;
      });
    const Vector3d from = patch.vertices[side[0]].place - this->center_;
    const Vector3d to = patch.vertices[side[1]].place - this->center_;
    const double angle = std::atan2(from.cross(to).norm(), from.dot(to));
    const int parts = 2 + static_cast<int>(angle / (2.0 * Pi) * RingSize);
    for (int part = 0; part < parts; ++part)
    {
      const double here = angle * part / parts;
      const double before = from.norm() * std::sin(here);
      const double after = to.norm() * std::sin(angle - here);
      const double t = before / (before + after);
      this->places_.push_back(
        { patch.pieces[*triangle].triangle, this->center_ + (1.0 - t) * from + t * to });
    }
  }
}

std::vector<Sector> Ring::sectors(double radius, double rounding, LevelProbe& probe) const
{
  const double middle = probe(this->center_, Derivatives::None).value;
  std::vector<double> heights;
  double largest = 0.0;
  for (const PatchPlace& onLink : this->places_)
  {
    const Vector3d offset = onLink.place - this->center_;
    const double distance = std::min(0.5 * offset.norm(), radius);
    const double difference =
      probe(this->center_ + distance * offset.normalized(), Derivatives::None).value - middle;
    heights.push_back(std::abs(difference) > rounding ? difference / (distance * distance) : 0.0);
    largest = std::max(largest, std::abs(heights.back()));
  }
  std::vector<Sector> sectors;
  for (std::size_t i = 0; i < heights.size(); ++i)
  {
    const double height = std::abs(heights[i]);
    const bool isAbove = heights[i] > 0.0;
    if (height <= ClearFraction * largest)
    {
      continue;
    }
    if (sectors.empty() || sectors.back().isAbove != isAbove)
    {
      sectors.push_back({ isAbove, height, this->places_[i] });
    }
    else if (height > sectors.back().height)
    {
      sectors.back() = { isAbove, height, this->places_[i] };
    }
  }
  if (sectors.size() > 1 && sectors.front().isAbove == sectors.back().isAbove)
  {
    if (sectors.back().height > sectors.front().height)
    {
      sectors.front() = sectors.back();
    }
    sectors.pop_back();
  }
  return sectors;
}

/// A saddle with what makes its value the level's.
struct PinnedSaddle
{
  Index vertex;
  std::vector<Sector> sectors;
  Dent dent;
};

std::optional<PinnedSaddle> saddleAt(const ContourPatch& patch, Index vertex,
  const std::vector<std::size_t>& star, const LevelBound& bound, const Field& field,
  LevelProbe& probe)
{
  const std::vector<Index> link = patch.link(vertex, star);
  if (link.empty())
  {
    return {};
  }
  const Vector3d& place = patch.vertices[vertex].place;
  Neighborhood near;
  field.cloud().nearest(place, NearCenters, near);
  const double radius = RingFraction * std::sqrt(near.squaredDistances.back());
  PinnedSaddle saddle{ vertex,
    Ring(patch, vertex, link, star).sectors(radius, bound.rounding(), probe), {} };
  if (saddle.sectors.size() < 4)
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
      found[i] = i < pieces.size() ? criticalPoint(patch, *pieces[i], margin, probe)
                                   : extremumOnEdge(patch, edges[i - pieces.size()].first,
                                       edges[i - pieces.size()].second, margin, probe);
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
    vertices.push_back(patch.insert(candidate));
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  const std::vector<std::vector<std::size_t>> stars = patch.starsOf(vertices);
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
      patch.insert(sector.peak); // so that the link has vertices on both sides of every branch
    }
  }
  return isAny;
}

} // namespace SurfaceScalars
