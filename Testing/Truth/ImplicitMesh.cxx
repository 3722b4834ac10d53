#include "ImplicitMesh.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

namespace SurfaceScalars::Truth
{
namespace
{

constexpr int Relaxations = 12;

/// Corners of the six tetrahedra around a diagonal of a cube; bits are the steps along x, y and z.
constexpr std::array<std::array<int, 4>, 6> Tetrahedra = { { { 0, 1, 3, 7 }, { 0, 1, 5, 7 },
  { 0, 2, 3, 7 }, { 0, 2, 6, 7 }, { 0, 4, 5, 7 }, { 0, 4, 6, 7 } } };

class Marching
{
public:
  Marching(const SpaceFunction& implicit, double radius, int cells)
    : implicit_(implicit)
    , side_(cells + 1)
    , step_(2.0 * radius / cells)
    , corner_(Vector3d(-1.0, -0.9991, -0.9973) * radius) // so that no corner is on the surface
    , values_(static_cast<std::size_t>(this->side_ * this->side_ * this->side_))
  {
    for (int i = 0; i < static_cast<int>(this->values_.size()); ++i)
    {
      this->values_[static_cast<std::size_t>(i)] = implicit.value(this->place(i));
    }
  }

  TriangleMesh mesh()
  {
    for (int x = 0; x + 1 < this->side_; ++x)
    {
      for (int y = 0; y + 1 < this->side_; ++y)
      {
        for (int z = 0; z + 1 < this->side_; ++z)
        {
          for (const auto& tetrahedron : Tetrahedra)
          {
            std::array<int, 4> corners;
            std::transform(tetrahedron.begin(), tetrahedron.end(), corners.begin(),
              [&](int bits)
              { return this->index(x + (bits & 1), y + ((bits >> 1) & 1), z + (bits >> 2)); });
            this->cut(corners);
          }
        }
      }
    }
    this->mesh_.points = Points(3, static_cast<Eigen::Index>(this->places_.size()));
    for (std::size_t i = 0; i < this->places_.size(); ++i)
    {
      this->mesh_.points.col(static_cast<Eigen::Index>(i)) = this->places_[i];
    }
    return std::move(this->mesh_);
  }

private:
  int index(int x, int y, int z) const { return (x * this->side_ + y) * this->side_ + z; }
  Vector3d place(int i) const
  {
    const Vector3d steps(
      i / (this->side_ * this->side_), i / this->side_ % this->side_, i % this->side_);
    return this->corner_ + this->step_ * steps;
  }
  bool isInside(int i) const { return this->values_[static_cast<std::size_t>(i)] < 0.0; }

  void cut(std::array<int, 4> corners)
  {
    const auto middle = std::partition(
      corners.begin(), corners.end(), [&](int corner) { return this->isInside(corner); });
    std::vector<int> vertices; // around the polygon
    const auto inside = static_cast<int>(middle - corners.begin());
    if (inside == 2)
    {
      vertices = { this->vertex(corners[0], corners[2]), this->vertex(corners[0], corners[3]),
        this->vertex(corners[1], corners[3]), this->vertex(corners[1], corners[2]) };
    }
    else if (inside == 1 || inside == 3)
    {
      const int alone = inside == 1 ? corners[0] : corners[3];
      for (const int other : corners)
      {
        if (other != alone)
        {
          vertices.push_back(this->vertex(alone, other));
        }
      }
    }
    for (std::size_t i = 2; i < vertices.size(); ++i)
    {
      this->mesh_.triangles.push_back({ vertices[0], vertices[i - 1], vertices[i] });
    }
  }

  int vertex(int one, int other)
  {
    const auto [known, isNew] =
      this->vertices_.emplace(std::minmax(one, other), static_cast<int>(this->places_.size()));
    if (isNew)
    {
      Vector3d inside = this->place(this->isInside(one) ? one : other);
      Vector3d outside = this->place(this->isInside(one) ? other : one);
      for (int halving = 0; halving < 60; ++halving)
      {
        const Vector3d middle = 0.5 * (inside + outside);
        (this->implicit_.value(middle) < 0.0 ? inside : outside) = middle;
      }
      this->places_.push_back(inside);
    }
    return known->second;
  }

  const SpaceFunction& implicit_;
  int side_;
  double step_;
  Vector3d corner_;
  std::vector<double> values_;
  std::map<std::pair<int, int>, int> vertices_; ///< on the edges of the grid
  std::vector<Vector3d> places_;
  TriangleMesh mesh_;
};

/// Moves each vertex to the middle of its neighbors and back to the surface.
void relax(TriangleMesh& mesh, const SpaceFunction& implicit)
{
  Points sums = Points::Zero(3, mesh.points.cols());
  Values counts = Values::Zero(mesh.points.cols());
  for (const auto& corners : mesh.triangles)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      sums.col(corners[i]) += mesh.points.col(corners[(i + 1) % 3]);
      sums.col(corners[i]) += mesh.points.col(corners[(i + 2) % 3]);
      counts[corners[i]] += 2.0;
    }
  }
  for (Eigen::Index i = 0; i < mesh.points.cols(); ++i)
  {
    Vector3d place = sums.col(i) / counts[i];
    for (int step = 0; step < 20; ++step)
    {
      const Vector3d gradient = implicit.gradient(place);
      place -= implicit.value(place) / gradient.squaredNorm() * gradient;
    }
    mesh.points.col(i) = place;
  }
}

} // namespace

TriangleMesh implicitMesh(const SpaceFunction& implicit, double radius, int cells)
{
  TriangleMesh mesh = Marching(implicit, radius, cells).mesh();
  for (int i = 0; i < Relaxations; ++i)
  {
    relax(mesh, implicit);
  }
  return mesh;
}

} // namespace SurfaceScalars::Truth
