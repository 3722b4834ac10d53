#include "ModelCriticalPoints.h"

#include "CandidateSearch.h"
#include "ConstantValues.h"
#include "Places.h"
#include "PointTree.h"
#include "Require.h"

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

constexpr double Tolerance = 1e-10;  // of the tangential gradient, in its scale
constexpr double CertainShare = 0.7; // of the time for searches

/// Tells which arrivals stand for points of u, and what becomes of the other candidates.
class Settlement
{
public:
  Settlement(const MeshTopology& mesh, const MeshCriticalPoints& candidates,
    const std::vector<Arrivals>& arrivals)
    : mesh_(mesh)
    , candidates_(candidates)
    , arrivals_(arrivals)
  {
    for (std::size_t i = 0; i < candidates.points.size(); ++i)
    {
      this->left_.push_back(candidates.points[i].multiplicity);
      if (!this->isInside(i))
      {
        this->ofBoundary_[candidates.points[i].input] = candidates.points[i].type;
      }
    }
    this->settle();
    this->cancel();
  }

  /// Of the multiplicity of each candidate, what neither stands for a point nor has vanished.
  const std::vector<int>& left() const { return this->left_; }

  /// What is left remains vertices.
  ModelCriticalPoints result() const
  {
    ModelCriticalPoints result = this->settled_;
    for (std::size_t i = 0; i < this->left_.size(); ++i)
    {
      if (this->left_[i] > 0)
      {
        ModelCriticalPoint kept{ this->candidates_.points[i], this->candidates_.points[i].input,
          this->endOf(i) };
        kept.point.multiplicity = this->left_[i];
        kept.point.residual = this->arrivals_[i].residual;
        kept.iterations = this->arrivals_[i].steps;
        result.points.push_back(kept);
      }
    }
    std::stable_sort(result.points.begin(), result.points.end(),
      [](const ModelCriticalPoint& a, const ModelCriticalPoint& b) { return a.origin < b.origin; });
    return result;
  }

private:
  struct Claim
  {
    std::size_t candidate;
    const Arrival* arrival;
  };

  /// One point for all that arrive at a place: that of the most persistent candidate.
  void settle()
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
      tree.within(claim.arrival->search.place, reachOf(claim.arrival->search), near);
      const auto isTaken = [&](Index other) {
        return isSettled[other] != 0 &&
          this->candidates_.points[claims[other].candidate].type == type;
      };
      if (!this->isHeldByBoundary(claim.arrival->search.vertex, type) &&
        std::none_of(near.indices.begin(), near.indices.end(), isTaken))
      {
        isSettled[i] = 1;
        --this->left_[claim.candidate];
        this->settled_.points.push_back(this->refined(claim));
      }
    }
  }

  /// Pairs neither of which stands for a point.
  void cancel()
  {
    for (const CriticalPair& pair : this->candidates_.pairs)
    {
      if (this->left_[pair.extremum] > 0 && this->left_[pair.saddle] > 0 &&
        this->isInside(pair.extremum) && this->isInside(pair.saddle))
      {
        for (const std::size_t candidate : { pair.extremum, pair.saddle })
        {
          --this->left_[candidate];
          ++(this->arrivals_[candidate].found.empty() ? this->settled_.vanished
                                                      : this->settled_.merged);
        }
      }
    }
  }

  bool isInside(std::size_t candidate) const
  {
    return !this->mesh_.isBoundary(static_cast<Index>(this->candidates_.points[candidate].input));
  }

  /// Why something of a candidate is left.
  RefinementEnd endOf(std::size_t candidate) const
  {
    const Arrivals& arrivals = this->arrivals_[candidate];
    return !this->isInside(candidate)     ? RefinementEnd::OnBoundary
      : arrivals.residual < 0.0           ? RefinementEnd::NoDerivative
      : arrivals.searches == 0            ? RefinementEnd::NotPredicted
      : !arrivals.found.empty()           ? RefinementEnd::Taken
      : arrivals.steps >= MostSearchSteps ? RefinementEnd::OutOfSteps
                                          : RefinementEnd::NotFound;
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

  /// Those on the most certain charts first, and of these the most persistent.
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
        return a.arrival->stage != b.arrival->stage
          ? a.arrival->stage < b.arrival->stage
          : this->candidates_.points[a.candidate].persistence >
            this->candidates_.points[b.candidate].persistence;
      });
    return claims;
  }

  ModelCriticalPoint refined(const Claim& claim) const
  {
    const CriticalPoint& candidate = this->candidates_.points[claim.candidate];
    ModelCriticalPoint result{ candidate, candidate.input };
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
  std::vector<int> left_;
  ModelCriticalPoints settled_;
};

} // namespace

double gradientScale(const PointsRef& vertices, const Triangles& triangles, const ValuesRef& values)
{
  if (areConstant(values))
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
  const double scale = gradientScale(vertices, mesh.triangles(), values);
  const ModelOnMesh model{ vertices, mesh, values, u, Tolerance * scale };
  std::vector<Arrivals> arrivals(candidates.points.size());
  std::vector<int> wanted;
  for (const CriticalPoint& candidate : candidates.points)
  {
    wanted.push_back(candidate.multiplicity);
  }
  searchFromAll(model, candidates.points, SearchStage::Certain, wanted, arrivals,
    execution.part(0.0, CertainShare));
  searchFromAll(model, candidates.points, SearchStage::Other,
    Settlement(mesh, candidates, arrivals).left(), arrivals, execution.part(CertainShare, 1.0));
  ModelCriticalPoints result = Settlement(mesh, candidates, arrivals).result();
  result.gradientScale = scale;
  return result;
}

double indexSum(const std::vector<ModelCriticalPoint>& points, const MeshTopology& mesh)
{
  double sum = 0.0;
  for (const ModelCriticalPoint& point : points)
  {
    const bool isHalf = !point.isRefined() && mesh.isBoundary(static_cast<Index>(point.origin));
    sum += (isHalf ? 0.5 : 1.0) * indexOf(point.point);
  }
  return sum;
}

} // namespace SurfaceScalars
