#pragma once

#include "Tetrahedra.h"

#include "vtkType.h"

#include <array>
#include <cstddef>
#include <vector>

namespace SurfaceScalars
{

/// How many tetrahedra a cell of this VTK type is cut into: a tetrahedron, voxel, hexahedron, wedge
/// or pyramid; 0 for others.
int tetrahedronCount(int cellType);

/**
 * Cuts such a cell into tetrahedra: from the corner with the least id to the faces without it, each
 * cut from its corner with the least id. Cells that share a face cut it in the same way, so that
 * tetrahedra meet in whole faces; voxels of an image are cut along parallel diagonals.
 *
 * @param corners ids of points in VTK's order
 * @param result gets the tetrahedra; of a cell with the same corner twice some have a corner twice
 */
void cutIntoTetrahedra(
  int cellType, const vtkIdType* corners, std::vector<std::array<vtkIdType, 4>>& result);

} // namespace SurfaceScalars
