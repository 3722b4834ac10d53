#pragma once

#include "Execution.h"
#include "MeshTopology.h"
#include "SurfaceVertices.h"

#include <functional>
#include <string>
#include <vector>

class vtkPolyData;

namespace SurfaceScalars
{

/// What a mesh filter works on: triangles and, for each vertex, one value of f; all finite.
struct MeshInput
{
  MeshedSurface surface;
  Values values;         ///< one per vertex
  std::string valueName; ///< the array's name
};

/**
 * Reads the triangles, quads, polygons and strips of polydata and the array chosen by
 * SetInputArrayToProcess(0, ...). Connectivity decides which triangles are neighbors; points at one
 * place remain several vertices. Cells that are hidden, or have a hidden point (vtkGhostType), are
 * no part of the mesh; duplicates of another piece's are.
 *
 * Notes say how much was left out: vertices and lines; triangles with the same corner twice; points
 * without a finite position or value, with their triangles (where such holes meet at a point, it
 * keeps the larger fan); points in no triangle.
 *
 * @param execution the part of run.execution() this is
 * @throws InvalidInput if no triangle is left, and as chooseScalars(); Aborted
 */
MeshInput readMesh(FilterRun& run, const Execution& execution, vtkPolyData* input);

/// A function that is not an array: its values at places, NaN where it has none.
struct PlaceFunction
{
  std::function<Values(const Points&, const Execution&)> values;
  std::string name;
};

/// The same with the values of such a function at the points, which takes most of the time.
MeshInput readMesh(
  FilterRun& run, const Execution& execution, vtkPolyData* input, const PlaceFunction& function);

/// The same without a function: reads the triangles only.
MeshedSurface readSurface(FilterRun& run, const Execution& execution, vtkPolyData* input);

/// For what needs no manifold: without duplicates of another piece's cells, and with all fans.
MeshedSurface readOwnSurface(FilterRun& run, const Execution& execution, vtkPolyData* input);

/// Not 0 for those without a finite position or value. @param values empty if there are none
/// @param leftOut not 0 for points that nobody misses; empty if there are none
std::vector<char> missingPoints(
  const Points& points, const Values& values, const std::vector<char>& leftOut);

/// Counts the vertices on the boundary that are at the place of another one in a note: where the
/// mesh may be torn by mistake.
/// @param values of f; empty if there is none
void noteSeams(
  FilterRun& run, const MeshedSurface& surface, const MeshTopology& topology, const Values& values);

/// The topology of the mesh, seams noted. @throws as MeshTopology; errors name points of the input
MeshTopology topologyOf(FilterRun& run, const MeshInput& mesh, const Execution& execution);

} // namespace SurfaceScalars
