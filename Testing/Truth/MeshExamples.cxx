#include "MeshExamples.h"

#include "Sampling.h"
#include "Torus.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace SurfaceScalars::Truth
{
namespace
{

TriangleMesh icosahedron()
{
  const double t = (1.0 + std::sqrt(5.0)) / 2.0;
  TriangleMesh mesh;
  mesh.points.resize(3, 12);
  int next = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double one : { -1.0, 1.0 })
    {
      for (const double other : { -t, t })
      {
        Vector3d place = Vector3d::Zero();
        place[axis] = one;
        place[(axis + 1) % 3] = other;
        mesh.points.col(next++) = place.normalized();
      }
    }
  }
  const double edge = 2.0 / std::sqrt(1.0 + t * t);
  const auto isEdge = [&](int a, int b)
  { return std::abs((mesh.points.col(a) - mesh.points.col(b)).norm() - edge) < 1e-9; };
  for (int a = 0; a < 12; ++a)
  {
    for (int b = a + 1; b < 12; ++b)
    {
      for (int c = b + 1; c < 12; ++c)
      {
        if (isEdge(a, b) && isEdge(b, c) && isEdge(c, a))
        {
          const Vector3d pa = mesh.points.col(a);
          const Vector3d pb = mesh.points.col(b);
          const bool outward = pa.cross(pb).dot(mesh.points.col(c)) > 0.0;
          mesh.triangles.push_back({ a, outward ? b : c, outward ? c : b });
        }
      }
    }
  }
  return mesh;
}

/// The triangles of a grid, the last row and column joined to the first if it is periodic.
std::vector<std::array<int, 3>> gridTriangles(int columns, int rows, bool isPeriodic)
{
  std::vector<std::array<int, 3>> triangles;
  const int shortage = isPeriodic ? 0 : 1;
  for (int j = 0; j + shortage < rows; ++j)
  {
    for (int i = 0; i + shortage < columns; ++i)
    {
      const int right = (i + 1) % columns;
      const int above = (j + 1) % rows * columns;
      const int here = j * columns;
      triangles.push_back({ here + i, here + right, above + right });
      triangles.push_back({ here + i, above + right, above + i });
    }
  }
  return triangles;
}

} // namespace

TriangleMesh subdividedSphere(int times)
{
  TriangleMesh mesh = icosahedron();
  for (; times > 0; --times)
  {
    std::map<std::pair<int, int>, int> middles;
    std::vector<Vector3d> added;
    const auto middle = [&](int a, int b)
    {
      const int known = static_cast<int>(mesh.points.cols() + static_cast<int>(added.size()));
      const auto [place, isNew] = middles.insert({ std::minmax(a, b), known });
      if (isNew)
      {
        added.emplace_back((mesh.points.col(a) + mesh.points.col(b)).normalized());
      }
      return place->second;
    };
    std::vector<std::array<int, 3>> triangles;
    for (const auto& [a, b, c] : mesh.triangles)
    {
      const int ab = middle(a, b);
      const int bc = middle(b, c);
      const int ca = middle(c, a);
      triangles.insert(
        triangles.end(), { { a, ab, ca }, { b, bc, ab }, { c, ca, bc }, { ab, bc, ca } });
    }
    mesh.triangles = std::move(triangles);
    const Eigen::Index known = mesh.points.cols();
    mesh.points.conservativeResize(3, known + static_cast<Eigen::Index>(added.size()));
    for (std::size_t i = 0; i < added.size(); ++i)
    {
      mesh.points.col(known + static_cast<Eigen::Index>(i)) = added[i];
    }
  }
  return mesh;
}

TriangleMesh griddedTorus(int around, int across, double shake, unsigned seed)
{
  Random random(seed);
  TriangleMesh mesh;
  mesh.points.resize(3, around * across);
  for (int j = 0; j < across; ++j)
  {
    for (int i = 0; i < around; ++i)
    {
      const double u = i + shake * random.uniform(-1.0, 1.0);
      const double v = j + shake * random.uniform(-1.0, 1.0);
      mesh.points.col(j * around + i) =
        torusPoint({ 2.0 * Pi * u / around, 2.0 * Pi * v / across });
    }
  }
  mesh.triangles = gridTriangles(around, across, true);
  return mesh;
}

TriangleMesh griddedSquare(int count, double shake, unsigned seed)
{
  Random random(seed);
  TriangleMesh mesh;
  mesh.points.resize(3, count * count);
  for (int j = 0; j < count; ++j)
  {
    for (int i = 0; i < count; ++i)
    {
      const bool isInside = i > 0 && i + 1 < count && j > 0 && j + 1 < count;
      const double reach = isInside ? shake : 0.0;
      const double x = i + reach * random.uniform(-1.0, 1.0);
      const double y = j + reach * random.uniform(-1.0, 1.0);
      mesh.points.col(j * count + i) = Vector3d(x, y, 0.0) / (count - 1);
    }
  }
  mesh.triangles = gridTriangles(count, count, false);
  return mesh;
}

TriangleMesh together(const TriangleMesh& one, const TriangleMesh& other)
{
  TriangleMesh mesh = one;
  const auto shift = static_cast<int>(one.points.cols());
  mesh.points.conservativeResize(3, shift + other.points.cols());
  mesh.points.rightCols(other.points.cols()) = other.points;
  for (const auto& [a, b, c] : other.triangles)
  {
    mesh.triangles.push_back({ a + shift, b + shift, c + shift });
  }
  return mesh;
}

TriangleMesh centered(TriangleMesh mesh)
{
  const Vector3d low = mesh.points.rowwise().minCoeff();
  const Vector3d high = mesh.points.rowwise().maxCoeff();
  mesh.points = (mesh.points.colwise() - 0.5 * (low + high)) * (2.0 / (high - low).norm());
  return mesh;
}

Triangles trianglesOf(const TriangleMesh& mesh)
{
  Triangles triangles(3, static_cast<Eigen::Index>(mesh.triangles.size()));
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      triangles(static_cast<Eigen::Index>(c), static_cast<Eigen::Index>(t)) =
        static_cast<Index>(mesh.triangles[t][c]);
    }
  }
  return triangles;
}

} // namespace SurfaceScalars::Truth
