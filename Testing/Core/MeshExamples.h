#pragma once

#include "Meshes.h"
#include "Sampling.h"
#include "Torus.h"
#include "Triangles.h"

#include <cmath>

/// Meshes of known surfaces, for the core's tests.
namespace SurfaceScalars::Truth
{

struct Mesh
{
  Points vertices;
  Triangles triangles;
};

/// (size + 1)^2 vertices of a unit square; inner ones are moved by up to `shake` of an edge.
inline Mesh squareMesh(int size, double shake)
{
  Random random(1);
  Mesh result = { squareGrid(size + 1, 1.0 / size), Triangles(3, 2 * size * size) };
  for (Eigen::Index i = 0; i < result.vertices.cols(); ++i)
  {
    auto place = result.vertices.col(i);
    if (place.head(2).minCoeff() > 0.5 / size && place.head(2).maxCoeff() < 1.0 - 0.5 / size)
    {
      place.head(2) +=
        shake / size * Vector2d(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
    }
  }
  Eigen::Index triangle = 0;
  for (int row = 0; row < size; ++row)
  {
    for (int column = 0; column < size; ++column)
    {
      const auto corner = static_cast<Index>(row * (size + 1) + column);
      const auto above = static_cast<Index>(corner + size + 1);
      result.triangles.col(triangle++) << corner, corner + 1, above + 1;
      result.triangles.col(triangle++) << corner, above + 1, above;
    }
  }
  return result;
}

/// Each triangle of an octahedron divided `times` times into four, on the unit sphere.
inline Mesh sphereMesh(int times)
{
  const TriangleMesh mesh = subdividedSphere(times);
  return { mesh.points, trianglesOf(mesh) };
}

/// `around` times half as many vertices on the torus. Irregular: spacings differ by up to 1 to 5,
/// vertices are moved by up to 0.3 of these, diagonals are random.
inline Mesh torusMesh(int around, bool irregular)
{
  Random random(2);
  const int tube = around / 2;
  const double bend = irregular ? 0.65 : 0.0; // of the angles, so that their spacing varies
  const double shake = irregular ? 0.3 : 0.0;
  Mesh result = { Points(3, around * tube), Triangles(3, 2 * around * tube) };
  const auto angle = [&](int i, int count)
  {
    const double even = 2 * Pi * (i + shake * random.uniform(-1.0, 1.0)) / count;
    return even + bend * std::sin(even);
  };
  Eigen::Index triangle = 0;
  for (int i = 0; i < around; ++i)
  {
    for (int j = 0; j < tube; ++j)
    {
      const auto vertex = [&](int u, int v)
      { return static_cast<Index>((u % around) * tube + v % tube); };
      const double u = angle(i, around);
      result.vertices.col(vertex(i, j)) = torusPoint({ u, angle(j, tube) });
      const Index a = vertex(i, j);
      const Index b = vertex(i + 1, j);
      const Index c = vertex(i + 1, j + 1);
      const Index d = vertex(i, j + 1);
      if (irregular && random.uniform() < 0.5)
      {
        result.triangles.col(triangle++) << a, b, d;
        result.triangles.col(triangle++) << b, c, d;
      }
      else
      {
        result.triangles.col(triangle++) << a, b, c;
        result.triangles.col(triangle++) << a, c, d;
      }
    }
  }
  return result;
}

} // namespace SurfaceScalars::Truth
