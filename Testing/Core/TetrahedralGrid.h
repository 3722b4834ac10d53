#pragma once

#include "Simplices.h"

#include <array>

namespace SurfaceScalars::Truth
{

struct SimplicialMesh
{
  Points vertices;
  Simplices simplices;
};

/// The unit cube in size^3 cubes, each cut into six tetrahedra along the same diagonal.
inline SimplicialMesh tetrahedralGrid(int size)
{
  const int side = size + 1;
  const auto vertex = [side](int x, int y, int z) { return (z * side + y) * side + x; };
  SimplicialMesh grid{ Points(3, side * side * side), Simplices(4, 6 * size * size * size) };
  Eigen::Index tetrahedron = 0;
  for (int z = 0; z < side; ++z)
  {
    for (int y = 0; y < side; ++y)
    {
      for (int x = 0; x < side; ++x)
      {
        grid.vertices.col(vertex(x, y, z)) = Vector3d(x, y, z) / size;
        if (x == size || y == size || z == size)
        {
          continue;
        }
        for (const auto& axes : { std::array{ 0, 1, 2 }, { 0, 2, 1 }, { 1, 0, 2 }, { 1, 2, 0 },
               { 2, 0, 1 }, { 2, 1, 0 } })
        {
          Eigen::Vector3i corner(x, y, z);
          for (int i = 0; i < 4; ++i)
          {
            grid.simplices(i, tetrahedron) =
              static_cast<Index>(vertex(corner.x(), corner.y(), corner.z()));
            if (i < 3)
            {
              ++corner[axes[static_cast<std::size_t>(i)]];
            }
          }
          ++tetrahedron;
        }
      }
    }
  }
  return grid;
}

} // namespace SurfaceScalars::Truth
