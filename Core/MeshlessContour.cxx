#include "MeshlessContour.h"

#include "ContourRefinement.h"
#include "NumberText.h"
#include "PatchCurves.h"
#include "PatchSaddles.h"
#include "PointTree.h"
#include "Quantile.h"
#include "Require.h"
#include "TriangleBlocks.h"
#include "TriangleSearch.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

namespace SurfaceScalars
{
namespace
{

constexpr double AutomaticTolerance = 1e-3; // of the median edge
constexpr double FinestTolerance = 1e-10;   // of the mesh's diagonal: less is rounding
constexpr int MostRefinement = 20;
constexpr int SpacingNeighbors = 4; // centers: the spacing is the distance to the farthest of these

void checkInput(const Field& field, const PointsRef& vertices, const Triangles& triangles,
  const MeshlessContourParameters& parameters)
{
  require(std::all_of(parameters.isoValues.begin(), parameters.isoValues.end(),
            [](double value) { return std::isfinite(value); }),
    "finite iso-values", "NaN or infinity", "Remove it from the list.");
  require(std::isfinite(parameters.tolerance) && parameters.tolerance >= 0.0,
    "a Tolerance of 0 (automatic) or more, a length", textOf(parameters.tolerance),
    "Use 0 if in doubt.");
  require(parameters.maximumRefinement >= 0 && parameters.maximumRefinement <= MostRefinement,
    "a MaximumRefinement from 0 to " + std::to_string(MostRefinement),
    std::to_string(parameters.maximumRefinement), "Use 8 if in doubt.");
  require(triangles.cols() > 0, "a mesh of triangles", "none", "Choose another surface.");
  require(triangles.maxCoeff() < vertices.cols(),
    "corners below " + std::to_string(vertices.cols()), std::to_string(triangles.maxCoeff()),
    "Repair the mesh.");
  require(vertices.allFinite(), "vertices with finite positions", "NaN or infinity",
    "Leave out the triangles there.");
  (void)field;
}

/// The triangles around the vertices of a mesh.
class VertexStars
{
public:
  VertexStars(Eigen::Index vertexCount, const Triangles& triangles)
    : starts_(static_cast<std::size_t>(vertexCount) + 1)
    , triangles_(static_cast<std::size_t>(triangles.size()))
  {
    for (Eigen::Index i = 0; i < triangles.size(); ++i)
    {
      ++this->starts_[triangles.data()[i] + 1];
    }
    std::partial_sum(this->starts_.begin(), this->starts_.end(), this->starts_.begin());
    std::vector<std::size_t> next(this->starts_.begin(), this->starts_.end() - 1);
    for (Eigen::Index i = 0; i < triangles.size(); ++i)
    {
      this->triangles_[next[triangles.data()[i]]++] = static_cast<Index>(i / 3);
    }
  }

  void append(Index vertex, std::vector<Index>& triangles) const
  {
    const auto at = [&](Index i)
    { return this->triangles_.begin() + static_cast<std::ptrdiff_t>(this->starts_[i]); };
    triangles.insert(triangles.end(), at(vertex), at(vertex + 1));
  }

private:
  std::vector<std::size_t> starts_;
  std::vector<Index> triangles_;
};

/// The level sets of one field on one mesh.
class MeshContouring
{
public:
  MeshContouring(const Field& field, const PointsRef& vertices, const Triangles& triangles,
    const MeshlessContourParameters& parameters, const Execution& execution);

  std::vector<LevelSetCurve> trace(double level, const Execution& execution);
  void finish();

  MeshlessContours result;

private:
  std::vector<Index> beyondEnds(const ContourPatch& patch, const std::vector<Index>& selected);
  ContourPatch refined(LevelFunction& function, std::vector<Index>& selected,
    const SaddleCandidates& saddles, const Execution& execution);
  void measure(const ContourPatch& patch);

  const Field& field_;
  Points vertices_; ///< relative to the origin of the field's cloud
  const Triangles& triangles_;
  LevelBound bound_;
  RefinementLimits limits_;
  TriangleBlocks blocks_;
  std::unique_ptr<VertexStars> stars_; ///< once it has been needed
  std::vector<bool> isEvaluated_;      ///< vertices
};

double toleranceOf(const Points& vertices, const Triangles& triangles, double asked)
{
  const Vector3d extent = vertices.rowwise().maxCoeff() - vertices.rowwise().minCoeff();
  const double tolerance = asked > 0.0 ? asked
                                       : AutomaticTolerance *
      medianOfSome(static_cast<std::size_t>(triangles.cols()),
        [&](std::size_t i)
        {
          const auto corners = triangles.col(static_cast<Eigen::Index>(i));
          return (vertices.col(corners(1)) - vertices.col(corners(0))).norm();
        });
  return std::max(tolerance, FinestTolerance * extent.norm());
}

MeshContouring::MeshContouring(const Field& field, const PointsRef& vertices,
  const Triangles& triangles, const MeshlessContourParameters& parameters,
  const Execution& execution)
  : field_(field)
  , vertices_(vertices.colwise() - field.cloud().origin())
  , triangles_(triangles)
  , bound_(field)
  , limits_{ toleranceOf(this->vertices_, triangles, parameters.tolerance),
    parameters.maximumRefinement }
  , blocks_(this->vertices_, triangles, execution)
  , isEvaluated_(static_cast<std::size_t>(vertices.cols()))
{
  this->result.tolerance = this->limits_.tolerance;
}

/// The triangles around those in which curves end, that are not selected yet; ascending.
std::vector<Index> MeshContouring::beyondEnds(
  const ContourPatch& patch, const std::vector<Index>& selected)
{
  std::unordered_map<ContourPatch::EdgeKey, int> uses;
  const auto crossedSides = [&](const PatchPiece& piece, const auto& action)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const ContourPatch::EdgeKey side = ContourPatch::sideOf(piece, i);
      if (patch.isCrossed(side))
      {
        action(side);
      }
    }
  };
  for (const PatchPiece& piece : patch.pieces)
  {
    crossedSides(piece, [&](ContourPatch::EdgeKey side) { ++uses[side]; });
  }
  std::vector<Index> found;
  for (const PatchPiece& piece : patch.pieces)
  {
    crossedSides(piece,
      [&](ContourPatch::EdgeKey side)
      {
        if (uses[side] == 1)
        {
          if (!this->stars_)
          {
            this->stars_ = std::make_unique<VertexStars>(this->vertices_.cols(), this->triangles_);
          }
          for (const Index corner : this->triangles_.col(piece.triangle))
          {
            this->stars_->append(corner, found);
          }
        }
      });
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  std::vector<Index> added;
  std::set_difference(
    found.begin(), found.end(), selected.begin(), selected.end(), std::back_inserter(added));
  return added;
}

/// The patch of the selected triangles, and of those beyond that curves lead into.
ContourPatch MeshContouring::refined(LevelFunction& function, std::vector<Index>& selected,
  const SaddleCandidates& saddles, const Execution& execution)
{
  while (true)
  {
    ContourPatch patch(this->vertices_, this->triangles_, selected);
    if (!saddles.empty() && !pinSaddles(saddles, patch, function, this->bound_, execution))
    {
      return patch;
    }
    ContourRefinement refinement(patch, function, this->bound_, this->limits_, execution);
    refinement.run();
    const std::vector<Index> added = this->beyondEnds(patch, selected);
    if (added.empty())
    {
      this->result.undefinedCount += refinement.undefinedCount();
      return patch;
    }
    std::vector<Index> all;
    std::merge(
      selected.begin(), selected.end(), added.begin(), added.end(), std::back_inserter(all));
    selected = std::move(all);
  }
}

void MeshContouring::measure(const ContourPatch& patch)
{
  for (const PatchPiece& piece : patch.pieces)
  {
    this->result.largestDeviation = std::max(this->result.largestDeviation, piece.deviation);
  }
  for (const PatchVertex& vertex : patch.vertices)
  {
    if (vertex.meshVertex != PatchVertex::None)
    {
      this->isEvaluated_[vertex.meshVertex] = true;
    }
  }
}

std::vector<LevelSetCurve> MeshContouring::trace(double level, const Execution& execution)
{
  LevelFunction function(this->field_, level);
  std::vector<Index> selected = trianglesNear(function, this->bound_, this->vertices_,
    this->triangles_, this->blocks_, execution.part(0.0, 0.1));
  ContourPatch patch = this->refined(function, selected, {}, execution.part(0.1, 0.5));
  const SaddleCandidates candidates =
    saddleCandidates(patch, function, this->bound_, execution.part(0.5, 0.6));
  if (!candidates.empty())
  {
    ContourPatch withSaddles =
      this->refined(function, selected, candidates, execution.part(0.6, 1.0));
    const auto isSaddle = [](const PatchVertex& vertex)
    { return vertex.node != PatchVertex::None; };
    if (std::any_of(withSaddles.vertices.begin(), withSaddles.vertices.end(), isSaddle))
    {
      patch = std::move(withSaddles);
    }
  }
  this->measure(patch);
  std::vector<LevelSetCurve> curves = curvesOf(patch);
  // The last word on how far the points are from the level set.
  function.forEach(curves.size(), execution.part(1.0, 1.0),
    [&](std::size_t i, LevelProbe& probe)
    {
      for (LevelSetPoint& point : curves[i].points)
      {
        const FieldJet jet = probe(point.position, Derivatives::Gradient);
        const double slope = alongPlane(jet.gradient, point.normal).norm();
        point.residual = slope > 0.0 ? std::abs(jet.value) / slope : 0.0;
      }
    });
  this->result.evaluations += function.evaluationCount();
  return curves;
}

/// Twice the widest distance of a center to the nearest few.
double farDistance(const PointCloud& cloud)
{
  double widest = 0.0;
  Neighborhood near;
  for (Index i = 0; i < cloud.pointCount(); ++i)
  {
    cloud.nearest(cloud.points().col(i), SpacingNeighbors + 1, near);
    widest = std::max(widest, near.squaredDistances.back());
  }
  return 2.0 * std::sqrt(widest);
}

/// The share of the curves' length whose points are farther than that from every center.
double shareBeyond(
  const std::vector<LevelSetCurve>& curves, const PointCloud& cloud, double distance)
{
  double total = 0.0;
  double beyond = 0.0;
  Neighborhood near;
  for (const LevelSetCurve& curve : curves)
  {
    for (std::size_t i = 1; i < curve.points.size(); ++i)
    {
      const Vector3d& place = curve.points[i].position;
      const double length = (place - curve.points[i - 1].position).norm();
      cloud.nearest(place, 1, near);
      total += length;
      beyond += near.squaredDistances.front() > distance * distance ? length : 0.0;
    }
  }
  return total > 0.0 ? beyond / total : 0.0;
}

void MeshContouring::finish()
{
  MeshlessContours& contours = this->result;
  const PointCloud& cloud = this->field_.cloud();
  contours.evaluatedVertices = static_cast<std::size_t>(
    std::count(this->isEvaluated_.begin(), this->isEvaluated_.end(), true));
  contours.farDistance = farDistance(cloud);
  contours.farShare = shareBeyond(contours.sets.curves, cloud, contours.farDistance);
  for (LevelSetCurve& curve : contours.sets.curves)
  {
    for (LevelSetPoint& point : curve.points)
    {
      point.position += cloud.origin();
    }
  }
}

} // namespace

MeshlessContours traceMeshlessContours(const Field& field, const PointsRef& vertices,
  const Triangles& triangles, const MeshlessContourParameters& parameters,
  const Execution& execution)
{
  checkInput(field, vertices, triangles, parameters);
  std::vector<double> isoValues = parameters.isoValues;
  std::sort(isoValues.begin(), isoValues.end());
  isoValues.erase(std::unique(isoValues.begin(), isoValues.end()), isoValues.end());

  MeshContouring contouring(field, vertices, triangles, parameters, execution.part(0.0, 0.1));
  LevelSets& sets = contouring.result.sets;
  for (std::size_t level = 0; level < isoValues.size(); ++level)
  {
    const double share = 0.9 / static_cast<double>(isoValues.size());
    const double from = 0.1 + share * static_cast<double>(level);
    std::vector<LevelSetCurve> curves =
      contouring.trace(isoValues[level], execution.part(from, from + share));
    sets.componentCounts.push_back(static_cast<int>(curves.size()));
    for (std::size_t i = 0; i < curves.size(); ++i)
    {
      curves[i].level = level;
      curves[i].component = static_cast<int>(i);
      sets.curves.push_back(std::move(curves[i]));
    }
  }
  sets.isoValues = std::move(isoValues);
  contouring.finish();
  return std::move(contouring.result);
}

} // namespace SurfaceScalars
