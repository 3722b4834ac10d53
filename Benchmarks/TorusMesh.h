#pragma once

#include "Triangles.h"

#include <cmath>

namespace SurfaceScalars
{

struct TorusMesh
{
  Points vertices;
  Triangles triangles;
};

/// R = 1, r = 0.4: `around` times half as many squares, each cut in two. Vertex (i, j) is
/// i * around / 2 + j.
inline TorusMesh torusMesh(int around)
{
  const int tube = around / 2;
  TorusMesh result{ Points(3, around * tube), Triangles(3, 2 * around * tube) };
  const auto vertex = [&](int i, int j)
  { return static_cast<Index>((i % around) * tube + j % tube); };
  for (int i = 0; i < around; ++i)
  {
    for (int j = 0; j < tube; ++j)
    {
      const double u = 2 * Pi * i / around;
      const double v = 2 * Pi * j / tube;
      const double axial = 1.0 + 0.4 * std::cos(v);
      const Index place = vertex(i, j);
      result.vertices.col(place) << axial * std::cos(u), axial * std::sin(u), 0.4 * std::sin(v);
      result.triangles.col(2 * place) << place, vertex(i + 1, j), vertex(i + 1, j + 1);
      result.triangles.col(2 * place + 1) << place, vertex(i + 1, j + 1), vertex(i, j + 1);
    }
  }
  return result;
}

} // namespace SurfaceScalars
