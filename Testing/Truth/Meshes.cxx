#include "Meshes.h"

#include "Sampling.h"
#include "Torus.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace SurfaceScalars::Truth
{
namespace
{

using Corner = std::array<int, 3>;

void addSquare(TriangleMesh& mesh, int a, int b, int c, int d)
{
  mesh.triangles.push_back({ a, b, c });
  mesh.triangles.push_back({ a, c, d });
}

Vector3d gridPoint(Grid grid, double u, double v)
{
  const double angle = 2.0 * Pi * u;
  const Vector3d outwards(std::cos(angle), std::sin(angle), 0.0);
  switch (grid)
  {
    case Grid::Patch:
      return { u, v, 0.0 };
    case Grid::Cylinder:
      return outwards + v * Vector3d::UnitZ();
    case Grid::Moebius:
      return outwards +
        (v - 0.5) * (std::cos(angle / 2.0) * outwards + std::sin(angle / 2.0) * Vector3d::UnitZ());
    case Grid::Torus:
      break;
  }
  return torusPoint(2.0 * Pi * Vector2d(u, v));
}

/// The surface of cubes of side 1, each at integer coordinates.
class CubeSurface
{
public:
  explicit CubeSurface(std::vector<Corner> cubes)
    : cubes_(std::move(cubes))
  {
  }

  TriangleMesh build()
  {
    for (const Corner& cube : this->cubes_)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        this->addFace(cube, axis, -1);
        this->addFace(cube, axis, 1);
      }
    }
    this->mesh_.points.resize(3, static_cast<Eigen::Index>(this->vertices_.size()));
    for (const auto& [corner, vertex] : this->vertices_)
    {
      this->mesh_.points.col(vertex) = Vector3d(corner[0], corner[1], corner[2]);
    }
    return std::move(this->mesh_);
  }

private:
  void addFace(const Corner& cube, std::size_t axis, int side)
  {
    Corner other = cube;
    other[axis] += side;
    if (std::find(this->cubes_.begin(), this->cubes_.end(), other) != this->cubes_.end())
    {
      return;
    }
    Corner corner = cube;
    corner[axis] += side > 0 ? 1 : 0;
    std::size_t first = (axis + 1) % 3;
    std::size_t second = (axis + 2) % 3;
    if (side < 0)
    {
      std::swap(first, second); // normals outwards
    }
    std::array<int, 4> around{};
    around[0] = this->vertex(corner);
    ++corner[first];
    around[1] = this->vertex(corner);
    ++corner[second];
    around[2] = this->vertex(corner);
    --corner[first];
    around[3] = this->vertex(corner);
    addSquare(this->mesh_, around[0], around[1], around[2], around[3]);
  }

  int vertex(const Corner& corner)
  {
    return this->vertices_.emplace(corner, static_cast<int>(this->vertices_.size())).first->second;
  }

  std::vector<Corner> cubes_;
  std::map<Corner, int> vertices_;
  TriangleMesh mesh_;
};

} // namespace

TriangleMesh gridMesh(Grid grid, int columns, int rows)
{
  const bool around = grid != Grid::Patch;
  const int height = grid == Grid::Torus ? rows : rows + 1;
  const auto vertex = [=](int i, int j)
  {
    const bool wraps = around && i == columns;
    return (wraps ? 0 : i) * height +
      (grid == Grid::Torus                 ? j % rows
          : wraps && grid == Grid::Moebius ? rows - j
                                           : j);
  };
  TriangleMesh mesh;
  mesh.points.resize(3, Eigen::Index{ around ? columns : columns + 1 } * height);
  for (Eigen::Index i = 0; i < mesh.points.cols(); ++i)
  {
    mesh.points.col(i) = gridPoint(
      grid, static_cast<double>(i / height) / columns, static_cast<double>(i % height) / rows);
  }
  for (int i = 0; i < columns; ++i)
  {
    for (int j = 0; j < rows; ++j)
    {
      addSquare(mesh, vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1));
    }
  }
  return mesh;
}

TriangleMesh subdividedSphere(int levels)
{
  TriangleMesh mesh;
  mesh.points.resize(3, 6);
  mesh.points << 1, -1, 0, 0, 0, 0, //
    0, 0, 1, -1, 0, 0,              //
    0, 0, 0, 0, 1, -1;
  mesh.triangles = { { 0, 2, 4 }, { 2, 1, 4 }, { 1, 3, 4 }, { 3, 0, 4 }, //
    { 2, 0, 5 }, { 1, 2, 5 }, { 3, 1, 5 }, { 0, 3, 5 } };
  for (int level = 0; level < levels; ++level)
  {
    mesh = subdivided(mesh);
    mesh.points.colwise().normalize();
  }
  return mesh;
}

TriangleMesh octahedralSphere(int segments)
{
  // On the octahedron, places are whole numbers with |x| + |y| + |z| = segments.
  std::map<Corner, int> names;
  std::vector<Corner> corners;
  const auto nameOf = [&](const Corner& corner)
  {
    const auto [found, isNew] = names.try_emplace(corner, static_cast<int>(corners.size()));
    if (isNew)
    {
      corners.push_back(corner);
    }
    return found->second;
  };
  TriangleMesh mesh;
  for (int face = 0; face < 8; ++face)
  {
    const std::array<int, 3> signs{ face & 1 ? -1 : 1, face & 2 ? -1 : 1, face & 4 ? -1 : 1 };
    const bool isMirrored = signs[0] * signs[1] * signs[2] < 0;
    const auto add = [&](Corner a, Corner b, Corner c)
    {
      for (Corner* corner : { &a, &b, &c })
      {
        std::transform(
          corner->begin(), corner->end(), signs.begin(), corner->begin(), std::multiplies<>());
      }
      mesh.triangles.push_back(isMirrored ? std::array{ nameOf(b), nameOf(a), nameOf(c) }
                                          : std::array{ nameOf(a), nameOf(b), nameOf(c) });
    };
    for (int x = 0; x < segments; ++x)
    {
      for (int y = 0; x + y < segments; ++y)
      {
        const int z = segments - x - y;
        add({ x, y, z }, { x + 1, y, z - 1 }, { x, y + 1, z - 1 });
        if (z > 1)
        {
          add({ x + 1, y, z - 1 }, { x + 1, y + 1, z - 2 }, { x, y + 1, z - 1 });
        }
      }
    }
  }
  mesh.points.resize(3, static_cast<Eigen::Index>(corners.size()));
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    mesh.points.col(static_cast<Eigen::Index>(i)) =
      Vector3d(corners[i][0], corners[i][1], corners[i][2]).normalized();
  }
  return mesh;
}

TriangleMesh plateWithHoles(int holes, int levels)
{
  std::vector<Corner> cubes;
  for (int i = 0; i < 2 * holes + 1; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      if (i % 2 == 0 || j != 1)
      {
        cubes.push_back({ i, j, 0 });
      }
    }
  }
  TriangleMesh mesh = CubeSurface(cubes).build();
  for (int level = 0; level < levels; ++level)
  {
    mesh = subdivided(mesh);
  }
  return mesh;
}

TriangleMesh besideEachOther(const TriangleMesh& one, const TriangleMesh& other)
{
  TriangleMesh both = one;
  const auto shift = static_cast<int>(one.points.cols());
  const double way = one.points.row(0).maxCoeff() - other.points.row(0).minCoeff() + 1.0;
  both.points.conservativeResize(3, one.points.cols() + other.points.cols());
  both.points.rightCols(other.points.cols()) = other.points.colwise() + way * Vector3d::UnitX();
  for (std::array<int, 3> triangle : other.triangles)
  {
    for (int& vertex : triangle)
    {
      vertex += shift;
    }
    both.triangles.push_back(triangle);
  }
  return both;
}

TriangleMesh subdivided(const TriangleMesh& mesh)
{
  std::map<std::pair<int, int>, int> middles;
  const auto middle = [&](int a, int b)
  {
    const auto next = static_cast<int>(mesh.points.cols()) + static_cast<int>(middles.size());
    return middles.emplace(std::minmax(a, b), next).first->second;
  };
  TriangleMesh fine;
  for (const auto& [a, b, c] : mesh.triangles)
  {
    const int ab = middle(a, b);
    const int bc = middle(b, c);
    const int ca = middle(c, a);
    fine.triangles.insert(
      fine.triangles.end(), { { a, ab, ca }, { b, bc, ab }, { c, ca, bc }, { ab, bc, ca } });
  }
  fine.points = mesh.points;
  fine.points.conservativeResize(3, mesh.points.cols() + static_cast<Eigen::Index>(middles.size()));
  for (const auto& [edge, vertex] : middles)
  {
    fine.points.col(vertex) = (mesh.points.col(edge.first) + mesh.points.col(edge.second)) / 2.0;
  }
  return fine;
}

ShuffledMesh shuffled(const TriangleMesh& mesh, unsigned seed)
{
  Random random(seed);
  const auto below = [&](std::size_t count)
  { return static_cast<std::size_t>(random.uniform(0.0, static_cast<double>(count))); };
  ShuffledMesh result{ mesh, std::vector<int>(static_cast<std::size_t>(mesh.points.cols())) };
  std::vector<int>& names = result.names;
  std::iota(names.begin(), names.end(), 0);
  for (std::size_t i = names.size(); i > 1; --i)
  {
    std::swap(names[i - 1], names[below(i)]);
  }
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    result.mesh.points.col(names[i]) = mesh.points.col(static_cast<Eigen::Index>(i));
  }
  std::vector<std::array<int, 3>>& triangles = result.mesh.triangles;
  for (std::size_t i = triangles.size(); i > 1; --i)
  {
    std::swap(triangles[i - 1], triangles[below(i)]);
  }
  for (std::array<int, 3>& triangle : triangles)
  {
    for (int& vertex : triangle)
    {
      vertex = names[static_cast<std::size_t>(vertex)];
    }
    if (random.uniform() < 0.5)
    {
      std::swap(triangle[0], triangle[2]);
    }
  }
  return result;
}

std::vector<NamedMesh> meshesOfAllKinds()
{
  std::vector<NamedMesh> result{ { "sphere", subdividedSphere(2), 2, true },
    { "torus", gridMesh(Grid::Torus, 12, 7), 0, true },
    { "patch", gridMesh(Grid::Patch, 5, 4), 1, false },
    { "one triangle", { Points::Identity(3, 3), { { 2, 0, 1 } } }, 1, false },
    { "cylinder", gridMesh(Grid::Cylinder, 8, 3), 0, false },
    { "Moebius strip", gridMesh(Grid::Moebius, 8, 3), 0, false } };
  for (int holes = 0; holes <= 3; ++holes)
  {
    result.push_back({ "plate with holes", plateWithHoles(holes, 1), 2 - 2 * holes, true });
  }
  return result;
}

Triangles trianglesOf(const TriangleMesh& mesh)
{
  Triangles result(3, static_cast<Eigen::Index>(mesh.triangles.size()));
  Eigen::Index column = 0;
  for (const std::array<int, 3>& triangle : mesh.triangles)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      result(corner, column) = static_cast<Index>(triangle[static_cast<std::size_t>(corner)]);
    }
    ++column;
  }
  return result;
}

MeshTopology topologyOf(const TriangleMesh& mesh, int threadCount)
{
  return { static_cast<Index>(mesh.points.cols()), trianglesOf(mesh), { threadCount, {} } };
}

} // namespace SurfaceScalars::Truth
