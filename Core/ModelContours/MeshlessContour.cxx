#include "MeshlessContour.h"

#include "LevelExtraction.h"
#include "NumberText.h"
#include "Quantile.h"
#include "Require.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace SurfaceScalars
{
namespace
{

constexpr double AutomaticTolerance = 1e-3; // of the median edge
constexpr double FinestTolerance = 1e-10;   // of the mesh's diagonal: less is rounding
constexpr int MostRefinement = 20;
constexpr int SpacingNeighbors = 4; // centers: the spacing is the distance to the farthest of these
constexpr double BlockShare = 0.1;  // of the whole, to sort the triangles

void checkInput(const PointsRef& vertices, const Triangles& triangles,
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
}

/// What is used: not less than rounding lets curves reach.
double toleranceOf(const Points& vertices, const Triangles& triangles, double asked)
{
  const Vector3d extent = vertices.rowwise().maxCoeff() - vertices.rowwise().minCoeff();
  const auto lengthOf = [&](std::size_t i)
  {
    const auto corners = triangles.col(static_cast<Eigen::Index>(i / 3));
    const auto side = static_cast<Eigen::Index>(i % 3);
    return (vertices.col(corners((side + 1) % 3)) - vertices.col(corners(side))).norm();
  };
  const double tolerance = asked > 0.0
    ? asked
    : AutomaticTolerance * medianOfSome(static_cast<std::size_t>(triangles.size()), lengthOf);
  return std::max(tolerance, FinestTolerance * extent.norm());
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

} // namespace

MeshlessContours traceMeshlessContours(const Field& field, const PointsRef& vertices,
  const Triangles& triangles, const MeshlessContourParameters& parameters,
  const Execution& execution)
{
  checkInput(vertices, triangles, parameters);
  const PointCloud& cloud = field.cloud();
  const Points places = vertices.colwise() - cloud.origin();
  MeshlessContours result;
  result.tolerance = toleranceOf(places, triangles, parameters.tolerance);
  LevelSets& sets = result.sets;
  sets.isoValues = parameters.isoValues;
  std::sort(sets.isoValues.begin(), sets.isoValues.end());
  sets.isoValues.erase(
    std::unique(sets.isoValues.begin(), sets.isoValues.end()), sets.isoValues.end());

  LevelExtraction extraction(field, places, triangles,
    { result.tolerance, parameters.maximumRefinement }, execution.part(0.0, BlockShare));
  for (std::size_t level = 0; level < sets.isoValues.size(); ++level)
  {
    const double share = (1.0 - BlockShare) / static_cast<double>(sets.isoValues.size());
    const double from = BlockShare + share * static_cast<double>(level);
    std::vector<LevelSetCurve> curves =
      extraction.trace(sets.isoValues[level], execution.part(from, from + share));
    sets.componentCounts.push_back(static_cast<int>(curves.size()));
    for (std::size_t i = 0; i < curves.size(); ++i)
    {
      curves[i].level = level;
      curves[i].component = static_cast<int>(i);
      sets.curves.push_back(std::move(curves[i]));
    }
  }
  result.largestDeviation = extraction.largestDeviation();
  result.evaluations = extraction.evaluationCount();
  result.evaluatedVertices = extraction.evaluatedVertexCount();
  result.undefinedCount = extraction.undefinedCount();
  result.farDistance = farDistance(cloud);
  result.farShare = shareBeyond(sets.curves, cloud, result.farDistance);
  for (LevelSetCurve& curve : sets.curves)
  {
    for (LevelSetPoint& point : curve.points)
    {
      point.position += cloud.origin();
    }
  }
  return result;
}

} // namespace SurfaceScalars
