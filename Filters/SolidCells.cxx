#include "SolidCells.h"

#include "vtkCellType.h"

#include <algorithm>

namespace SurfaceScalars
{
namespace
{

using Face = std::vector<int>; ///< corners in cyclic order

/// The faces of a type of cells, by the numbers of their corners. Null for types without.
const std::vector<Face>* facesOf(int cellType)
{
  static const std::vector<Face> tetrahedron{ { 0, 1, 2 }, { 0, 1, 3 }, { 0, 2, 3 }, { 1, 2, 3 } };
  static const std::vector<Face> voxel{ { 0, 2, 6, 4 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 },
    { 2, 3, 7, 6 }, { 0, 1, 3, 2 }, { 4, 5, 7, 6 } };
  static const std::vector<Face> hexahedron{ { 0, 4, 7, 3 }, { 1, 2, 6, 5 }, { 0, 1, 5, 4 },
    { 3, 7, 6, 2 }, { 0, 3, 2, 1 }, { 4, 5, 6, 7 } };
  static const std::vector<Face> wedge{ { 0, 1, 2 }, { 3, 4, 5 }, { 0, 3, 4, 1 }, { 1, 4, 5, 2 },
    { 2, 5, 3, 0 } };
  static const std::vector<Face> pyramid{ { 0, 3, 2, 1 }, { 0, 1, 4 }, { 1, 2, 4 }, { 2, 3, 4 },
    { 3, 0, 4 } };
  switch (cellType)
  {
    case VTK_TETRA:
      return &tetrahedron;
    case VTK_VOXEL:
      return &voxel;
    case VTK_HEXAHEDRON:
      return &hexahedron;
    case VTK_WEDGE:
      return &wedge;
    case VTK_PYRAMID:
      return &pyramid;
    default:
      return nullptr;
  }
}

} // namespace

int tetrahedronCount(int cellType)
{
  switch (cellType)
  {
    case VTK_TETRA:
      return 1;
    case VTK_VOXEL:
    case VTK_HEXAHEDRON:
      return 6;
    case VTK_WEDGE:
      return 3;
    case VTK_PYRAMID:
      return 2;
    default:
      return 0;
  }
}

void cutIntoTetrahedra(
  int cellType, const vtkIdType* corners, std::vector<std::array<vtkIdType, 4>>& result)
{
  const std::vector<Face>& faces = *facesOf(cellType);
  const auto isLess = [corners](int a, int b) { return corners[a] < corners[b]; };
  int apex = 0;
  for (const Face& face : faces)
  {
    apex = std::min(apex, *std::min_element(face.begin(), face.end(), isLess), isLess);
  }
  for (const Face& face : faces)
  {
    if (std::find(face.begin(), face.end(), apex) != face.end())
    {
      continue;
    }
    const auto size = static_cast<std::ptrdiff_t>(face.size());
    const auto first = std::min_element(face.begin(), face.end(), isLess) - face.begin();
    const auto corner = [&](std::ptrdiff_t i)
    { return corners[face[static_cast<std::size_t>((first + i) % size)]]; };
    for (std::ptrdiff_t i = 1; i + 1 < size; ++i)
    {
      result.push_back({ corners[apex], corner(0), corner(i), corner(i + 1) });
    }
  }
}

} // namespace SurfaceScalars
