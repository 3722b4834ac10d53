#pragma once

#include "DisjointSets.h"
#include "MeshExamples.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

/// Marching through every triangle of an even subdivision, to compare adaptive contours with.
namespace SurfaceScalars::Truth
{

/// Each triangle in four, so many times; places stay on the triangles.
inline Mesh subdivided(Mesh mesh, int times)
{
  for (; times > 0; --times)
  {
    std::map<std::pair<Index, Index>, Index> middles;
    Mesh finer{ Points(3, mesh.vertices.cols() + 3 * mesh.triangles.cols()),
      Triangles(3, 4 * mesh.triangles.cols()) };
    Eigen::Index count = mesh.vertices.cols();
    finer.vertices.leftCols(count) = mesh.vertices;
    const auto middle = [&](Index a, Index b)
    {
      const auto [found, isNew] = middles.emplace(std::minmax(a, b), static_cast<Index>(count));
      if (isNew)
      {
        finer.vertices.col(count++) = 0.5 * (mesh.vertices.col(a) + mesh.vertices.col(b));
      }
      return found->second;
    };
    for (Eigen::Index i = 0; i < mesh.triangles.cols(); ++i)
    {
      const Index a = mesh.triangles(0, i);
      const Index b = mesh.triangles(1, i);
      const Index c = mesh.triangles(2, i);
      const Index ab = middle(a, b);
      const Index bc = middle(b, c);
      const Index ca = middle(c, a);
      finer.triangles.col(4 * i) << a, ab, ca;
      finer.triangles.col(4 * i + 1) << ab, b, bc;
      finer.triangles.col(4 * i + 2) << ca, bc, c;
      finer.triangles.col(4 * i + 3) << ab, bc, ca;
    }
    finer.vertices.conservativeResize(3, count);
    mesh = std::move(finer);
  }
  return mesh;
}

inline double longestEdge(const Mesh& mesh)
{
  double longest = 0.0;
  for (Eigen::Index i = 0; i < mesh.triangles.size(); ++i)
  {
    const Eigen::Index next = i % 3 == 2 ? i - 2 : i + 1;
    longest = std::max(longest,
      (mesh.vertices.col(mesh.triangles.data()[i]) - mesh.vertices.col(mesh.triangles.data()[next]))
        .norm());
  }
  return longest;
}

/// A connected component of a level set: segments.
struct UniformComponent
{
  std::vector<std::pair<Vector3d, Vector3d>> segments;

  Vector3d extent() const
  {
    Vector3d low = this->segments.front().first;
    Vector3d high = low;
    for (const auto& [from, to] : this->segments)
    {
      low = low.cwiseMin(from).cwiseMin(to);
      high = high.cwiseMax(from).cwiseMax(to);
    }
    return high - low;
  }
};

/// By linear interpolation along the edges.
inline std::vector<UniformComponent> uniformContour(
  const Mesh& mesh, const Values& values, double level)
{
  std::map<std::pair<Index, Index>, Index> crossings;
  std::vector<Vector3d> places;
  std::vector<std::pair<Index, Index>> links;
  for (Eigen::Index i = 0; i < mesh.triangles.cols(); ++i)
  {
    std::vector<Index> ends;
    for (Eigen::Index side = 0; side < 3; ++side)
    {
      const std::pair<Index, Index> edge =
        std::minmax(mesh.triangles(side, i), mesh.triangles((side + 1) % 3, i));
      const double from = values[edge.first] - level;
      const double to = values[edge.second] - level;
      if ((from < 0.0) != (to < 0.0))
      {
        const auto [found, isNew] = crossings.emplace(edge, static_cast<Index>(places.size()));
        if (isNew)
        {
          const double t = from / (from - to);
          places.emplace_back(
            (1.0 - t) * mesh.vertices.col(edge.first) + t * mesh.vertices.col(edge.second));
        }
        ends.push_back(found->second);
      }
    }
    if (ends.size() == 2)
    {
      links.emplace_back(ends[0], ends[1]);
    }
  }
  DisjointSets sets(static_cast<Index>(places.size()));
  for (const auto& [a, b] : links)
  {
    if (sets.find(a) != sets.find(b))
    {
      sets.attach(sets.find(a), sets.find(b));
    }
  }
  std::map<Index, UniformComponent> components;
  for (const auto& [a, b] : links)
  {
    components[sets.find(a)].segments.emplace_back(places[a], places[b]);
  }
  std::vector<UniformComponent> result;
  for (auto& [root, component] : components)
  {
    result.push_back(std::move(component));
  }
  return result;
}

} // namespace SurfaceScalars::Truth
