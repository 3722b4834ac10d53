#include "MeshTopology.h"

#include "LinkPath.h"
#include "Require.h"
#include "SimplexComponents.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <string>
#include <utility>

namespace SurfaceScalars
{
namespace
{

constexpr std::size_t Grain = 16384;

/// Calls body for each index below count, and says how far it is between two parts of the whole.
template <class Body>
void forEachIndex(Index count, const Execution& execution, const Body& body)
{
  for (Index index = 0; index < count; ++index)
  {
    if (index % 65536 == 0)
    {
      execution.report(static_cast<double>(index) / count);
    }
    body(index);
  }
}

/// The edges opposite to the vertex in these triangles.
void findEdges(
  const Triangles& triangles, Index vertex, VertexRange around, std::vector<LinkEdge>& edges)
{
  edges.clear();
  for (const Index triangle : around)
  {
    const auto corners = triangles.col(triangle);
    const int corner = corners[0] == vertex ? 0 : corners[1] == vertex ? 1 : 2;
    edges.push_back({ corners[(corner + 1) % 3], corners[(corner + 2) % 3] });
  }
}

[[noreturn]] void refuseLink(LinkShape shape, Index vertex, Index neighbor,
  std::size_t triangleCount, const VertexName& nameOf)
{
  const std::string name = std::to_string(nameOfVertex(vertex, nameOf));
  if (shape == LinkShape::Branching)
  {
    throw InvalidInput("a manifold, at most 2 triangles at each edge",
      "more at the edge between vertices " + name + " and " +
        std::to_string(nameOfVertex(neighbor, nameOf)),
      "Remove triangles there or give each sheet vertices of its own.");
  }
  throw InvalidInput("a manifold, at each vertex triangles that form one fan",
    "several fans of the " + std::to_string(triangleCount) + " triangles at vertex " + name,
    "Give each fan a vertex of its own.");
}

[[noreturn]] void refuseTriangle(
  const Index* corners, const std::string& triangle, Index vertexCount, const VertexName& nameOf)
{
  const Index last = std::max({ corners[0], corners[1], corners[2] });
  require(last < vertexCount,
    "corners below " + std::to_string(vertexCount) + ", the number of vertices",
    std::to_string(last) + " in triangle " + triangle, "Correct the triangle.");
  const Index twice = corners[0] == corners[1] ? corners[0] : corners[2];
  throw InvalidInput("three different corners of each triangle",
    "vertex " + std::to_string(nameOfVertex(twice, nameOf)) + " twice in triangle " + triangle,
    "Remove degenerate triangles.");
}

} // namespace

MeshTopology::MeshTopology(
  Index vertexCount, Triangles triangles, const Execution& execution, const VertexName& nameOf)
  : triangles_(std::move(triangles))
  , starts_(std::size_t(vertexCount) + 1, 0)
{
  this->checkTriangles(nameOf);
  this->findTrianglesOfVertices(execution.part(0.0, 0.3), nameOf);
  this->orderLinks(execution.part(0.3, 0.8), nameOf);
  this->numberComponents(execution.part(0.8, 1.0));
}

void MeshTopology::checkTriangles(const VertexName& nameOf) const
{
  const Eigen::Index count = this->triangles_.cols();
  require(count > 0, "triangles", "none", "Choose a mesh, or a filter for point sets.");
  const Eigen::Index most = (std::numeric_limits<Index>::max() - this->vertexCount()) / 3;
  require(count <= most,
    "at most " + std::to_string(most) + " triangles, for indices are numbers of 32 bits",
    std::to_string(count), "Choose a smaller mesh.");
  for (Eigen::Index t = 0; t < count; ++t)
  {
    const Index* corners = this->triangles_.col(t).data();
    const bool exist = std::max({ corners[0], corners[1], corners[2] }) < this->vertexCount();
    if (!exist || corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0])
    {
      refuseTriangle(corners, std::to_string(t), this->vertexCount(), nameOf);
    }
  }
}

/// Into links_: of each vertex the indices of its triangles, and room for one more.
void MeshTopology::findTrianglesOfVertices(const Execution& execution, const VertexName& nameOf)
{
  const Index triangleCount = static_cast<Index>(this->triangles_.cols());
  const Index* corners = this->triangles_.data();
  for (Index corner = 0; corner < 3 * triangleCount; ++corner)
  {
    ++this->starts_[corners[corner]];
  }
  Index end = 0;
  for (Index vertex = 0; vertex < this->vertexCount(); ++vertex)
  {
    const Index count = std::exchange(this->starts_[vertex], end);
    if (count == 0)
    {
      throw InvalidInput("a triangle at each vertex",
        "none at vertex " + std::to_string(nameOfVertex(vertex, nameOf)),
        "Remove unused vertices.");
    }
    end += count + 1;
  }
  this->links_.resize(end);
  forEachIndex(triangleCount, execution,
    [&](Index triangle)
    {
      for (Index corner = 3 * triangle; corner < 3 * triangle + 3; ++corner)
      {
        this->links_[this->starts_[corners[corner]]++] = triangle;
      }
    });
  for (Index vertex = this->vertexCount(); vertex > 0; --vertex)
  {
    this->starts_[vertex] = this->starts_[vertex - 1] + 1;
  }
  this->starts_[0] = 0;
}

/// In links_: the paths in place of the triangles, which have one edge each.
void MeshTopology::orderLinks(const Execution& execution, const VertexName& nameOf)
{
  std::atomic<Index> boundaryCount{ 0 };
  std::atomic<Index> firstRefused{ this->vertexCount() };
  const auto follow = [&](Index vertex, std::vector<LinkEdge>& edges, LinkPath& path)
  {
    const VertexRange slots = this->linkPath(vertex);
    findEdges(this->triangles_, vertex, { slots.first, slots.last - 1 }, edges);
    return path.follow(edges);
  };
  parallelFor(this->vertexCount(), Grain, execution,
    [&](std::size_t begin, std::size_t end)
    {
      std::vector<LinkEdge> edges;
      LinkPath path;
      for (auto vertex = static_cast<Index>(begin); vertex < end; ++vertex)
      {
        const LinkShape shape = follow(vertex, edges, path);
        if (shape != LinkShape::Path && shape != LinkShape::Cycle)
        {
          Index first = firstRefused;
          while (vertex < first && !firstRefused.compare_exchange_weak(first, vertex))
          {
          }
          return;
        }
        std::copy(path.vertices().begin(), path.vertices().end(),
          this->links_.begin() + this->starts_[vertex]);
        boundaryCount += shape == LinkShape::Path ? 1 : 0;
      }
    });
  this->boundaryCount_ = boundaryCount;
  if (firstRefused < this->vertexCount())
  {
    std::vector<LinkEdge> edges;
    LinkPath path;
    const LinkShape shape = follow(firstRefused, edges, path);
    refuseLink(shape, firstRefused, path.branching(), edges.size(), nameOf);
  }
}

void MeshTopology::numberComponents(const Execution& execution)
{
  VertexComponents components = componentsOf(this->vertexCount(), this->triangles_, execution);
  this->components_ = std::move(components.ofVertices);
  this->componentCount_ = components.count;
}

std::int64_t MeshTopology::eulerCharacteristic() const
{
  const std::int64_t triangleCount = this->triangles_.cols();
  const std::int64_t edgeCount = (3 * triangleCount + this->boundaryCount_) / 2;
  return this->vertexCount() - edgeCount + triangleCount;
}

} // namespace SurfaceScalars
