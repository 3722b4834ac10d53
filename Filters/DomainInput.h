#pragma once

#include "MeshInput.h"
#include "Tetrahedra.h"

#include "vtkType.h"

#include <vector>

class vtkDataSet;

namespace SurfaceScalars
{

/// What a filter for surfaces and volumes works on: simplices and, for each vertex, one value of f.
struct DomainInput
{
  MeshInput mesh;               ///< of a volume: without triangles
  Tetrahedra tetrahedra;        ///< of a volume
  std::vector<vtkIdType> cells; ///< of the input: the one each triangle or tetrahedron is a part
                                ///< of, ascending

  bool isVolume() const { return this->tetrahedra.cols() > 0; }
  const Points& vertices() const { return this->mesh.surface.vertices; }
  const VertexMap& map() const { return this->mesh.surface.map; }
};

/**
 * Reads any dataset and the array chosen by SetInputArrayToProcess(0, ...).
 *
 * - Polydata is a surface, as of readMesh().
 * - With tetrahedra, voxels, hexahedra, wedges or pyramids it is a volume: an unstructured grid, an
 *   image (a voxel becomes six tetrahedra along one diagonal), another grid. Flat cells, lines and
 *   vertices are ignored, with a note.
 * - Without, but with triangles, pixels, quads, polygons or strips it is a surface: a flat image,
 *   say, with two triangles for each pixel.
 *
 * Hidden cells are no part of it. Cells that another piece has, too, are.
 *
 * Points without a finite position or value are left out with what is around them, and counted in a
 * note; so are points in no triangle or tetrahedron, and what has the same corner twice. What is
 * left of a volume need not be a manifold.
 *
 * Memory of a volume: 24 bytes per tetrahedron, 210 per point of an image in all. VolumeTopology
 * says how many there can be.
 *
 * @param execution the part of run.execution() this is
 * @throws InvalidInput for cells of other types, which it names; if nothing is left; and as
 * chooseScalars(); Aborted
 */
DomainInput readDomain(FilterRun& run, const Execution& execution, vtkDataSet* input);

} // namespace SurfaceScalars
