#include "ModelCriticalPoints.h"

#include "Places.h"
#include "PointTree.h"
#include "Require.h"
#include "SurfaceNewton.h"
#include "SurfaceRestriction.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

namespace SurfaceScalars
{
namespace
{

constexpr double Tolerance = 1e-10; // of the tangential gradient, in its scale
constexpr double Rounding = 1e-12;  // of values, in their size: less is constant
constexpr double SamePlace = 0.1;   // of two points, in spacings of the mesh

struct Arrival
{
  SurfaceSearch search;
  int steps; ///< of this search and those in vain before it
};

/// Where the searches from one candidate lead: to points of its type.
struct Arrivals
{
  std::vector<Arrival> found; ///< different ones
  double residual = 0.0;      ///< at the candidate itself
};

bool isSame(const SurfaceSearch& one, const SurfaceSearch& other)
{
  return (one.place - other.place).norm() <= SamePlace * std::max(one.spacing, other.spacing);
}

/// Searches from candidates.
class CandidateSearch
{
public:
  CandidateSearch(const PointsRef& vertices, const MeshTopology& mesh, const Field& u, double scale)
    : vertices_(vertices)
    , mesh_(mesh)
    , newton_(vertices, mesh, u, { Tolerance * scale })
    , isConstant_(scale == 0.0)
  {
  }

  Arrivals from(const CriticalPoint& candidate, const Poll& poll)
  {
    const auto vertex = static_cast<Index>(candidate.input);
    Arrivals arrivals;
    arrivals.residual = this->newton_.residualAt(vertex);
    if (this->mesh_.isBoundary(vertex) || this->isConstant_)
    {
      return arrivals;
    }
    this->steps_ = 0;
    const auto wanted = static_cast<std::size_t>(candidate.multiplicity);
    const auto search = [&](Index start, ChartChoice charts)
    {
      if (arrivals.found.size() < wanted)
      {
        this->add(start, candidate.type, charts, poll, arrivals);
      }
    };
    search(vertex, ChartChoice::Nearest);
    search(vertex, ChartChoice::First);
    for (const Index neighbor : this->mesh_.link(vertex))
    {
      search(neighbor, ChartChoice::Nearest);
    }
    return arrivals;
  }

private:
  void add(Index start, CriticalType type, ChartChoice charts, const Poll& poll, Arrivals& arrivals)
  {
    const SurfaceSearch search =
      this->newton_.search(this->vertices_.col(start), start, type, charts, poll);
    this->steps_ += search.stepCount();
    const auto isKnown = [&](const Arrival& other) { return isSame(search, other.search); };
    if (search.isCritical && search.isOnMesh && typeOf(search.restricted.hessian) == type &&
      std::none_of(arrivals.found.begin(), arrivals.found.end(), isKnown))
    {
      arrivals.found.push_back({ search, this->steps_ });
      this->steps_ = 0;
    }
  }

  PointsRef vertices_;
  const MeshTopology& mesh_;
  SurfaceNewton newton_;
  bool isConstant_;
  int steps_ = 0; ///< since something was found
};

/// Tells which arrivals stand for points of u, and what becomes of the other candidates.
class Settlement
{
public:
  Settlement(const MeshTopology& mesh, const MeshCriticalPoints& candidates,
    const std::vector<Arrivals>& arrivals)
    : mesh_(mesh)
    , candidates_(candidates)
    , arrivals_(arrivals)
    , left_(candidates.points.size())
  {
    for (std::size_t i = 0; i < candidates.points.size(); ++i)
    {
      this->left_[i] = candidates.points[i].multiplicity;
      if (!this->isInside(i))
      {
        this->ofBoundary_[candidates.points[i].input] = candidates.points[i].type;
      }
    }
  }

  /// One point for all that arrive at a place: that of the most persistent candidate.
  void settle(ModelCriticalPoints& result)
  {
    const std::vector<Claim> claims = this->claims();
    const Points places =
      placesOf(claims, [](const Claim& claim) { return claim.arrival->search.place; });
    const PointTree tree(places);
    std::vector<char> isSettled(claims.size(), 0);
    Neighborhood near;
    for (std::size_t i = 0; i < claims.size(); ++i)
    {
      const Claim& claim = claims[i];
      const CriticalType type = this->candidates_.points[claim.candidate].type;
      tree.within(claim.arrival->search.place, SamePlace * claim.arrival->search.spacing, near);
      const auto isTaken = [&](Index other) {
        return isSettled[other] != 0 &&
          this->candidates_.points[claims[other].candidate].type == type;
      };
      if (!this->isHeldByBoundary(claim.arrival->search.vertex, type) &&
        std::none_of(near.indices.begin(), near.indices.end(), isTaken))
      {
        isSettled[i] = 1;
        --this->left_[claim.candidate];
        result.points.push_back(this->refined(claim));
      }
    }
  }

  /// Pairs neither of which stands for a point.
  void cancel(ModelCriticalPoints& result)
  {
    for (const CriticalPair& pair : this->candidates_.pairs)
    {
      if (this->left_[pair.extremum] > 0 && this->left_[pair.saddle] > 0 &&
        this->isInside(pair.extremum) && this->isInside(pair.saddle))
      {
        for (const std::size_t candidate : { pair.extremum, pair.saddle })
        {
          --this->left_[candidate];
          ++(this->arrivals_[candidate].found.empty() ? result.vanished : result.merged);
        }
      }
    }
  }

  /// The others remain vertices.
  void keepRest(ModelCriticalPoints& result) const
  {
    for (std::size_t i = 0; i < this->left_.size(); ++i)
    {
      if (this->left_[i] > 0)
      {
        ModelCriticalPoint kept{ this->candidates_.points[i], this->candidates_.points[i].input };
        kept.point.multiplicity = this->left_[i];
        kept.point.residual = this->arrivals_[i].residual;
        result.points.push_back(kept);
      }
    }
  }

private:
  struct Claim
  {
    std::size_t candidate;
    const Arrival* arrival;
  };

  bool isInside(std::size_t candidate) const
  {
    return !this->mesh_.isBoundary(static_cast<Index>(this->candidates_.points[candidate].input));
  }

  /// Whether a critical vertex of the boundary, which remains, is next to where a search ends.
  bool isHeldByBoundary(Index vertex, CriticalType type) const
  {
    const auto isHeld = [&](Index other)
    {
      const auto found = this->ofBoundary_.find(other);
      return found != this->ofBoundary_.end() && found->second == type;
    };
    const VertexRange link = this->mesh_.link(vertex);
    return isHeld(vertex) || std::any_of(link.begin(), link.end(), isHeld);
  }

  /// The most persistent first.
  std::vector<Claim> claims() const
  {
    std::vector<Claim> claims;
    for (std::size_t i = 0; i < this->arrivals_.size(); ++i)
    {
      for (const Arrival& arrival : this->arrivals_[i].found)
      {
        claims.push_back({ i, &arrival });
      }
    }
    std::stable_sort(claims.begin(), claims.end(),
      [&](const Claim& a, const Claim& b)
      {
        return this->candidates_.points[a.candidate].persistence >
          this->candidates_.points[b.candidate].persistence;
      });
    return claims;
  }

  ModelCriticalPoint refined(const Claim& claim) const
  {
    const CriticalPoint& candidate = this->candidates_.points[claim.candidate];
    ModelCriticalPoint result{ candidate, candidate.input, true };
    result.point.position = claim.arrival->search.place;
    result.point.multiplicity = 1;
    result.point.value = claim.arrival->search.restricted.value;
    result.point.input = claim.arrival->search.vertex;
    result.point.residual = claim.arrival->search.residuals.back();
    result.iterations = claim.arrival->steps;
    return result;
  }

  const MeshTopology& mesh_;
  const MeshCriticalPoints& candidates_;
  const std::vector<Arrivals>& arrivals_;
  std::map<std::size_t, CriticalType> ofBoundary_; ///< critical vertices
  std::vector<int> left_; ///< of the multiplicity of each candidate, what stands for no point yet
};

std::vector<Arrivals> searchFromAll(const PointsRef& vertices, const MeshTopology& mesh,
  const Field& u, const MeshCriticalPoints& candidates, double scale, const Execution& execution)
{
  std::vector<Arrivals> arrivals(candidates.points.size());
  parallelForEach(candidates.points.size(), execution,
    [&](std::size_t i, const Poll& poll)
    {
      const CriticalPoint& candidate = candidates.points[i];
      arrivals[i] = CandidateSearch(vertices, mesh, u, scale).from(candidate, poll);
    });
  return arrivals;
}

} // namespace

double gradientScale(const PointsRef& vertices, const Triangles& triangles, const ValuesRef& values)
{
  if (values.maxCoeff() - values.minCoeff() <= Rounding * values.cwiseAbs().maxCoeff())
  {
    return 0.0;
  }
  double energy = 0.0;
  double area = 0.0;
  for (const auto corners : triangles.colwise())
  {
    Eigen::Matrix<double, 3, 2> edges;
    edges << vertices.col(corners[1]) - vertices.col(corners[0]),
      vertices.col(corners[2]) - vertices.col(corners[0]);
    const Vector2d changes(
      values[corners[1]] - values[corners[0]], values[corners[2]] - values[corners[0]]);
    const double twice = edges.col(0).cross(edges.col(1)).norm();
    const double square = changes.dot((edges.transpose() * edges).inverse() * changes);
    if (std::isfinite(square)) // else the triangle has no area
    {
      energy += twice * square;
      area += twice;
    }
  }
  return area > 0.0 ? std::sqrt(energy / area) : 0.0;
}

ModelCriticalPoints refineOnModel(const PointsRef& vertices, const MeshTopology& mesh,
  const ValuesRef& values, const Field& u, const MeshCriticalPoints& candidates,
  const Execution& execution)
{
  require(vertices.cols() == mesh.vertexCount() && values.size() == mesh.vertexCount(),
    "a place and a value for each of the " + std::to_string(mesh.vertexCount()) + " vertices",
    std::to_string(vertices.cols()) + " places and " + std::to_string(values.size()) + " values",
    "Choose those of the mesh.");
  ModelCriticalPoints result;
  result.gradientScale = gradientScale(vertices, mesh.triangles(), values);
  const std::vector<Arrivals> arrivals =
    searchFromAll(vertices, mesh, u, candidates, result.gradientScale, execution);
  Settlement settlement(mesh, candidates, arrivals);
  settlement.settle(result);
  settlement.cancel(result);
  settlement.keepRest(result);
  std::stable_sort(result.points.begin(), result.points.end(),
    [](const ModelCriticalPoint& a, const ModelCriticalPoint& b) { return a.origin < b.origin; });
  return result;
}

double indexSum(const std::vector<ModelCriticalPoint>& points, const MeshTopology& mesh)
{
  double sum = 0.0;
  for (const ModelCriticalPoint& point : points)
  {
    const bool isHalf = !point.isRefined && mesh.isBoundary(static_cast<Index>(point.origin));
    sum += (isHalf ? 0.5 : 1.0) * indexOf(point.point);
  }
  return sum;
}

} // namespace SurfaceScalars
