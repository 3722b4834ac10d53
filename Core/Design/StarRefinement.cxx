#include "StarRefinement.h"

#include "Require.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <string>
#include <unordered_map>
#include <utility>

namespace SurfaceScalars
{
namespace
{

constexpr Index MostParts = 4; // of an edge: more would make needles

using EdgeKey = std::uint64_t;
using Corners = std::array<Index, 3>;

EdgeKey keyOf(Index a, Index b)
{
  return EdgeKey(std::min(a, b)) << 32 | std::max(a, b);
}

/// Of the link, if each of its edges has this many parts.
Index sizeWith(Index parts, const MeshTopology& mesh, Index vertex)
{
  const Index edges = mesh.linkPath(vertex).size() - 1;
  return mesh.link(vertex).size() + edges * (parts - 1);
}

/// @throws InvalidInput that says how many neighbors the vertex can have: a saddle of multiplicity
/// m needs 2 + 2m, on the boundary m + 2
[[noreturn]] void refuse(const NeededLink& need, const MeshTopology& mesh, const VertexName& nameOf)
{
  const Index most = sizeWith(MostParts, mesh, need.vertex);
  const bool isBoundary = mesh.isBoundary(need.vertex);
  throw InvalidInput("saddles of multiplicity at most " +
      std::to_string(isBoundary ? most - 2 : most / 2 - 1) + " at vertex " +
      std::to_string(nameOfVertex(need.vertex, nameOf)) + ", which has " +
      std::to_string(mesh.link(need.vertex).size()) + " neighbors and " + std::to_string(most) +
      " after its triangles are split in " + std::to_string(MostParts),
    "one that needs " + std::to_string(need.size),
    "Ask for a lower multiplicity, or at a vertex with more neighbors.");
}

/// The least number of parts of the edges of its link that gives a vertex what it needs.
Index partsFor(const NeededLink& need, const MeshTopology& mesh, const VertexName& nameOf)
{
  Index parts = 1;
  while (sizeWith(parts, mesh, need.vertex) < need.size)
  {
    if (++parts > MostParts)
    {
      refuse(need, mesh, nameOf);
    }
  }
  // Two triangles with the same corners: a divided edge would have the vertex at both sides.
  require(parts == 1 || mesh.isBoundary(need.vertex) || mesh.link(need.vertex).size() > 2,
    "vertices with at least 3 neighbors to split triangles at",
    "2 at vertex " + std::to_string(nameOfVertex(need.vertex, nameOf)),
    "Ask for this critical point elsewhere.");
  return parts;
}

/// Divides edges, and the triangles at both their sides.
class EdgeDivision
{
public:
  explicit EdgeDivision(RefinedMesh& mesh)
    : mesh_(mesh)
  {
  }

  void divide(Index a, Index b, Index parts)
  {
    Index& largest = this->parts_[keyOf(a, b)];
    largest = std::max(largest, parts);
  }

  void run()
  {
    this->addVertices();
    for (Eigen::Index i = 0; i < this->mesh_.triangles.cols(); ++i)
    {
      const auto corners = this->mesh_.triangles.col(i);
      const std::size_t first = this->triangles_.size();
      this->split({ corners[0], corners[1], corners[2] });
      const std::size_t count = this->triangles_.size() - first;
      const auto place = static_cast<std::size_t>(i);
      this->origins_.insert(this->origins_.end(), count, this->mesh_.origins[place]);
      this->isSplit_.insert(this->isSplit_.end(), count, count > 1 || this->mesh_.isSplit[place]);
    }
    const auto count = static_cast<Eigen::Index>(this->triangles_.size());
    this->mesh_.triangles = Eigen::Map<const Triangles>(this->triangles_.front().data(), 3, count);
    this->mesh_.origins.swap(this->origins_);
    this->mesh_.isSplit.swap(this->isSplit_);
  }

private:
  /// Along the edges in ascending order, so that nothing depends on the hash.
  void addVertices()
  {
    std::vector<std::pair<EdgeKey, Index>> edges(this->parts_.begin(), this->parts_.end());
    std::sort(edges.begin(), edges.end());
    auto next = static_cast<Index>(this->mesh_.vertices.cols());
    const auto firstAdded = this->mesh_.added.size();
    for (const auto& [key, parts] : edges)
    {
      this->firstInner_[key] = next;
      for (Index part = 1; part < parts; ++part, ++next)
      {
        this->mesh_.added.push_back({ static_cast<Index>(key >> 32), static_cast<Index>(key),
          static_cast<double>(part) / parts });
      }
    }
    Points& vertices = this->mesh_.vertices;
    auto column = vertices.cols();
    vertices.conservativeResize(3, next);
    for (auto i = firstAdded; i < this->mesh_.added.size(); ++i)
    {
      const EdgeVertex& place = this->mesh_.added[i];
      const double share = place.fraction;
      vertices.col(column++) =
        (1.0 - share) * vertices.col(place.from) + share * vertices.col(place.to);
    }
  }

  /// A fan from the corner opposite to a divided edge, and each part of it likewise.
  void split(const Corners& corners)
  {
    for (int side = 0; side < 3; ++side)
    {
      const Index from = corners[side];
      const Index to = corners[(side + 1) % 3];
      const Index apex = corners[(side + 2) % 3];
      const auto edge = this->parts_.find(keyOf(from, to));
      if (edge == this->parts_.end())
      {
        continue;
      }
      const Index inner = edge->second - 1;
      const Index first = this->firstInner_.at(edge->first);
      Index last = from;
      for (Index i = 0; i < inner; ++i)
      {
        const Index next = from < to ? first + i : first + inner - 1 - i;
        this->split({ last, next, apex });
        last = next;
      }
      this->split({ last, to, apex });
      return;
    }
    this->triangles_.push_back(corners);
  }

  RefinedMesh& mesh_;
  std::unordered_map<EdgeKey, Index> parts_;
  std::unordered_map<EdgeKey, Index> firstInner_; ///< the first added vertex from the lower end
  std::vector<Corners> triangles_;
  std::vector<Index> origins_;
  std::vector<char> isSplit_;
};

/// Divides edges for all vertices in need but those next to another one that comes first.
/// @returns whether there was any
bool refineOnce(RefinedMesh& refined, const MeshTopology& mesh,
  const std::vector<NeededLink>& needed, const VertexName& nameOf)
{
  EdgeDivision division(refined);
  std::vector<char> waits(mesh.vertexCount());
  bool isAny = false;
  for (const NeededLink& need : needed)
  {
    const Index parts = partsFor(need, mesh, nameOf);
    if (parts == 1 || waits[need.vertex])
    {
      continue;
    }
    isAny = true;
    const VertexRange path = mesh.linkPath(need.vertex);
    for (const Index* end = path.begin() + 1; end != path.end(); ++end)
    {
      division.divide(end[-1], *end, parts);
      waits[end[-1]] = waits[*end] = 1;
    }
  }
  if (isAny)
  {
    division.run();
  }
  return isAny;
}

} // namespace

RefinedMesh refineStars(const PointsRef& vertices, const MeshTopology& mesh,
  const std::vector<NeededLink>& needed, const VertexName& nameOf)
{
  RefinedMesh refined{ vertices, mesh.triangles(), {}, {}, {} };
  refined.origins.resize(static_cast<std::size_t>(mesh.triangles().cols()));
  std::iota(refined.origins.begin(), refined.origins.end(), Index(0));
  refined.isSplit.resize(refined.origins.size());
  bool isDivided = refineOnce(refined, mesh, needed, nameOf);
  while (isDivided)
  {
    const MeshTopology next(static_cast<Index>(refined.vertices.cols()), refined.triangles);
    isDivided = refineOnce(refined, next, needed, nameOf);
  }
  return refined;
}

} // namespace SurfaceScalars
