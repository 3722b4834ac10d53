#include "MeshInput.h"

#include "FilterRun.h"
#include "GhostMarks.h"
#include "PointSetInput.h"
#include "Require.h"
#include "ScalarChoice.h"
#include "SurfaceTriangles.h"
#include "TriangleSelection.h"

#include "vtkDataSetAttributes.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace SurfaceScalars
{
namespace
{

// The shares of the whole that end with the triangles, the points and the values.
constexpr double TriangleShare = 0.6;
constexpr double PointShare = 0.8;
constexpr double ValueShare = 0.9;
constexpr double EvaluationShare = 0.1; // and where the evaluation of a function begins

void noteOtherCells(FilterRun& run, vtkPolyData* input)
{
  const vtkIdType count = input->GetNumberOfVerts() + input->GetNumberOfLines();
  if (count > 0)
  {
    run.note(std::to_string(count) + " of " + std::to_string(input->GetNumberOfCells()) +
      " cells are vertices or lines and ignored: the function is taken on the triangles.");
  }
}

/// @param input null: a block of a composite dataset is of another type
/// @param marks of cells to be left out
/// @throws InvalidInput if there are none
SurfaceCells readTriangles(FilterRun& run, const Execution& execution, vtkPolyData* input,
  unsigned char marks = vtkDataSetAttributes::HIDDENCELL)
{
  require(input != nullptr, "blocks that are polydata", "one of another type",
    "Apply Extract Surface first.");
  SurfaceCells read = trianglesOf(input, execution, marks);
  require(read.triangles.cols() > 0 || read.leftOut.empty(),
    (marks & vtkDataSetAttributes::DUPLICATECELL) == 0
      ? "cells that are not hidden"
      : "cells that are neither hidden nor duplicates of another piece's",
    "none among " + std::to_string(input->GetNumberOfCells()), "Check what is upstream.");
  require(read.triangles.cols() > 0, "a mesh of triangles, quads or strips",
    "no triangle among " + std::to_string(input->GetNumberOfCells()) + " cells",
    "Use Fuzzy Critical Points, Point Set Contour or another point-set filter for points without "
    "a mesh, or apply Extract Surface to a mesh of another type.");
  noteOtherCells(run, input);
  return read;
}

/// Drops the triangles that have the same corner twice, which are edges.
void dropEdges(FilterRun& run, Triangles& triangles)
{
  const Eigen::Index total = triangles.cols();
  Eigen::Index count = 0;
  for (Eigen::Index i = 0; i < total; ++i)
  {
    const auto corners = triangles.col(i);
    if (corners(0) != corners(1) && corners(1) != corners(2) && corners(2) != corners(0))
    {
      triangles.col(count++) = corners;
    }
  }
  if (count < total)
  {
    triangles.conservativeResize(3, count);
    run.note(std::to_string(total - count) + " of " + std::to_string(total) +
      " triangles have the same corner twice and are ignored.");
  }
}

/// Cuts out the triangles around some points.
/// @param torn points around which some are gone already
void dropMissing(FilterRun& run, const std::vector<char>& missing, bool hasValues,
  const std::vector<char>& torn, Triangles& triangles)
{
  const Eigen::Index count = std::count(missing.begin(), missing.end(), 1);
  const Eigen::Index total = triangles.cols();
  if (count > 0 || !torn.empty())
  {
    triangles = trianglesWithout(triangles, missing, torn);
  }
  if (count > 0)
  {
    run.note("Left out " + std::to_string(count) + " of " + std::to_string(missing.size()) +
      " points whose position" + (hasValues ? " or value" : "") + " is NaN or infinite, with " +
      std::to_string(total - triangles.cols()) + " of " + std::to_string(total) +
      " triangles: the mesh has holes there.");
  }
  require(triangles.cols() > 0,
    std::string("triangles between points with a finite position") +
      (hasValues ? " and value" : ""),
    "none", hasValues ? "Choose another array or another input." : "Choose another input.");
}

enum class Fans
{
  One, ///< of each vertex the largest
  All
};

/// What is left of the triangles between points. @param values empty if there are none
MeshedSurface usableSurface(FilterRun& run, const Points& points, const Values& values,
  SurfaceCells read, Fans fans = Fans::One)
{
  dropEdges(run, read.triangles);
  const std::vector<char> leftOut = pointsLeftOut(read.leftOut, read.triangles);
  const std::vector<char> missing = missingPoints(points, values, leftOut);
  dropMissing(run, missing, values.size() > 0,
    fans == Fans::One ? read.leftOut : std::vector<char>(), read.triangles);
  MeshedSurface surface = surfaceOf(points, std::move(read.triangles), allPoints(points.cols()));
  noteOutside(run, surface.map,
    std::count(missing.begin(), missing.end(), 1) + std::count(leftOut.begin(), leftOut.end(), 1));
  return surface;
}

/// @param read with the share TriangleShare of the execution
MeshedSurface surfaceWithoutValues(
  FilterRun& run, const Execution& execution, vtkPolyData* input, SurfaceCells read, Fans fans)
{
  const Points points = readPoints(input->GetPoints(), execution.part(TriangleShare, PointShare));
  MeshedSurface surface = usableSurface(run, points, {}, std::move(read), fans);
  execution.report(1.0);
  return surface;
}

/// The vertices on the boundary, those at one place beside each other.
std::vector<Index> boundaryByPlace(const Points& places, const MeshTopology& topology)
{
  std::vector<Index> rim;
  for (Index vertex = 0; vertex < topology.vertexCount(); ++vertex)
  {
    if (topology.isBoundary(vertex))
    {
      rim.push_back(vertex);
    }
  }
  std::sort(rim.begin(), rim.end(),
    [&](Index a, Index b)
    {
      return std::lexicographical_compare(
        places.col(a).begin(), places.col(a).end(), places.col(b).begin(), places.col(b).end());
    });
  return rim;
}

} // namespace

std::vector<char> missingPoints(
  const Points& points, const Values& values, const std::vector<char>& leftOut)
{
  std::vector<char> missing(static_cast<std::size_t>(points.cols()));
  for (Eigen::Index i = 0; i < points.cols(); ++i)
  {
    const auto place = static_cast<std::size_t>(i);
    missing[place] = (leftOut.empty() || leftOut[place] == 0) &&
      ((values.size() > 0 && !std::isfinite(values(i))) || !points.col(i).allFinite());
  }
  return missing;
}

MeshInput readMesh(FilterRun& run, const Execution& execution, vtkPolyData* input)
{
  SurfaceCells read = readTriangles(run, execution.part(0.0, TriangleShare), input);
  const ScalarChoice choice = chooseScalars(run.filter(), { input });
  const Points points = readPoints(input->GetPoints(), execution.part(TriangleShare, PointShare));
  Values values(points.cols());
  copyNumbers(choice.arrays.front(), values.data(), execution.part(PointShare, ValueShare));

  MeshInput mesh;
  mesh.surface = usableSurface(run, points, values, std::move(read));
  mesh.values = values(mesh.surface.map.pointOfVertex);
  mesh.valueName = choice.name;
  execution.report(1.0);
  return mesh;
}

MeshInput readMesh(
  FilterRun& run, const Execution& execution, vtkPolyData* input, const PlaceFunction& function)
{
  SurfaceCells read = readTriangles(run, execution.part(0.0, EvaluationShare), input);
  const Points points = readPoints(input->GetPoints(), {});
  const Values values = function.values(points, execution.part(EvaluationShare, 1.0));

  MeshInput mesh;
  mesh.surface = usableSurface(run, points, values, std::move(read));
  mesh.values = values(mesh.surface.map.pointOfVertex);
  mesh.valueName = function.name;
  return mesh;
}

MeshedSurface readSurface(FilterRun& run, const Execution& execution, vtkPolyData* input)
{
  return surfaceWithoutValues(run, execution, input,
    readTriangles(run, execution.part(0.0, TriangleShare), input), Fans::One);
}

MeshedSurface readOwnSurface(FilterRun& run, const Execution& execution, vtkPolyData* input)
{
  constexpr unsigned char marks =
    vtkDataSetAttributes::HIDDENCELL | vtkDataSetAttributes::DUPLICATECELL;
  return surfaceWithoutValues(run, execution, input,
    readTriangles(run, execution.part(0.0, TriangleShare), input, marks), Fans::All);
}

void noteSeams(
  FilterRun& run, const MeshedSurface& surface, const MeshTopology& topology, const Values& values)
{
  const Points& places = surface.vertices;
  const std::vector<Index> rim = boundaryByPlace(places, topology);
  std::size_t doubled = 0;
  std::size_t different = 0;
  for (std::size_t i = 1; i < rim.size(); ++i)
  {
    const bool isSame = places.col(rim[i]) == places.col(rim[i - 1]);
    doubled += isSame;
    different += isSame && values.size() > 0 && values(rim[i]) != values(rim[i - 1]);
  }
  if (doubled > 0)
  {
    run.note(std::to_string(doubled) + " of " + std::to_string(rim.size()) +
      " vertices on the boundary are at the place of another: if the mesh should not be torn "
      "there, apply Clean first, which makes them one" +
      (different > 0 ? " and keeps the first of their values, which differ at " +
            std::to_string(different) + " of them."
                     : "."));
  }
}

MeshTopology topologyOf(FilterRun& run, const MeshInput& mesh, const Execution& execution)
{
  const MeshedSurface& surface = mesh.surface;
  MeshTopology topology(
    static_cast<Index>(surface.vertices.cols()), surface.triangles, execution, surface.map.names());
  noteSeams(run, surface, topology, mesh.values);
  return topology;
}

} // namespace SurfaceScalars
