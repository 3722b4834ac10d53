#include "VolumeTopology.h"

#include "Require.h"
#include "SimplexComponents.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <string>
#include <utility>

namespace SurfaceScalars
{
namespace
{

constexpr std::size_t Grain = 4096; // vertices per block of a parallel loop

void reportNowAndThen(const Execution& execution, Eigen::Index done, Eigen::Index count)
{
  constexpr Eigen::Index step = 1 << 20;
  if (done % step == 0)
  {
    execution.report(static_cast<double>(done) / static_cast<double>(count));
  }
}

using Face = std::array<Index, 3>; ///< ascending

/// What the tetrahedra around some vertices say, one vertex after the other.
struct LinkBlock
{
  std::vector<Index> links;
  std::vector<Index> sizes;   ///< of the links
  std::vector<Face> boundary; ///< faces of one tetrahedron whose first corner is among them
  std::vector<Face> crowded;  ///< the first face of more than two, if there is one
};

/// Adds what is around one vertex. Each face is counted at its first corner.
class LinkCollector
{
public:
  LinkCollector(const VolumeTopology& volume, LinkBlock& block)
    : volume_(volume)
    , block_(block)
  {
  }

  void add(Index vertex)
  {
    this->corners_.clear();
    this->faces_.clear();
    for (const Index tetrahedron : this->volume_.star(vertex))
    {
      this->addTetrahedron(tetrahedron, vertex);
    }
    std::sort(this->corners_.begin(), this->corners_.end());
    const auto last = std::unique(this->corners_.begin(), this->corners_.end());
    this->block_.links.insert(this->block_.links.end(), this->corners_.begin(), last);
    this->block_.sizes.push_back(static_cast<Index>(std::distance(this->corners_.begin(), last)));
    this->countFaces();
  }

private:
  void addTetrahedron(Index tetrahedron, Index vertex)
  {
    std::array<Index, 3> others{};
    std::copy_if(this->volume_.tetrahedra().col(tetrahedron).begin(),
      this->volume_.tetrahedra().col(tetrahedron).end(), others.begin(),
      [=](Index corner) { return corner != vertex; });
    std::sort(others.begin(), others.end());
    const auto [a, b, c] = others;
    this->corners_.insert(this->corners_.end(), { a, b, c });
    if (vertex < a)
    {
      this->faces_.push_back({ vertex, a, b });
      this->faces_.push_back({ vertex, a, c });
    }
    if (vertex < b)
    {
      this->faces_.push_back({ vertex, b, c });
    }
  }

  void countFaces()
  {
    std::sort(this->faces_.begin(), this->faces_.end());
    for (auto face = this->faces_.begin(); face != this->faces_.end();)
    {
      const auto next =
        std::find_if(face, this->faces_.end(), [&](const Face& other) { return other != *face; });
      if (next - face == 1)
      {
        this->block_.boundary.push_back(*face);
      }
      else if (next - face > 2 && this->block_.crowded.empty())
      {
        this->block_.crowded.push_back(*face);
      }
      face = next;
    }
  }

  const VolumeTopology& volume_;
  LinkBlock& block_;
  std::vector<Index> corners_;
  std::vector<Face> faces_;
};

std::string textOf(const Face& face, const VertexName& nameOf)
{
  return std::to_string(nameOfVertex(face[0], nameOf)) + ", " +
    std::to_string(nameOfVertex(face[1], nameOf)) + " and " +
    std::to_string(nameOfVertex(face[2], nameOf));
}

} // namespace

VolumeTopology::VolumeTopology(
  Index vertexCount, Tetrahedra tetrahedra, const Execution& execution, const VertexName& nameOf)
  : tetrahedra_(std::move(tetrahedra))
  , starStarts_(std::size_t(vertexCount) + 1, 0)
  , linkStarts_(std::size_t(vertexCount) + 1, 0)
  , isBoundary_(vertexCount, 0)
{
  this->checkTetrahedra(execution.part(0.0, 0.1), nameOf);
  this->findStars(execution.part(0.1, 0.2), nameOf);
  this->findLinks(execution.part(0.2, 0.8), nameOf);
  VertexComponents components =
    componentsOf(vertexCount, this->tetrahedra_, execution.part(0.8, 1.0));
  this->components_ = std::move(components.ofVertices);
  this->componentCount_ = components.count;
}

void VolumeTopology::checkTetrahedra(const Execution& execution, const VertexName& nameOf) const
{
  const Eigen::Index count = this->tetrahedra_.cols();
  require(count > 0, "tetrahedra", "none", "Choose a volume, or a filter for point sets.");
  require(count <= MostTetrahedra,
    "at most " + std::to_string(MostTetrahedra) + " tetrahedra, for indices are numbers of 32 bits",
    std::to_string(count), "Choose a smaller volume.");
  for (Eigen::Index t = 0; t < count; ++t)
  {
    reportNowAndThen(execution, t, count);
    std::array<Index, 4> corners{};
    std::copy_n(this->tetrahedra_.col(t).data(), corners.size(), corners.begin());
    std::sort(corners.begin(), corners.end());
    require(corners[3] < this->vertexCount(),
      "corners below " + std::to_string(this->vertexCount()) + ", the number of vertices",
      std::to_string(corners[3]) + " in tetrahedron " + std::to_string(t),
      "Correct the tetrahedron.");
    const auto* twice = std::adjacent_find(corners.begin(), corners.end());
    if (twice != corners.end())
    {
      throw InvalidInput("four different corners of each tetrahedron",
        "vertex " + std::to_string(nameOfVertex(*twice, nameOf)) + " twice in tetrahedron " +
          std::to_string(t),
        "Remove degenerate tetrahedra.");
    }
  }
}

void VolumeTopology::findStars(const Execution& execution, const VertexName& nameOf)
{
  for (const Index corner : this->tetrahedra_.reshaped())
  {
    ++this->starStarts_[corner];
  }
  Index end = 0;
  for (Index vertex = 0; vertex < this->vertexCount(); ++vertex)
  {
    const Index count = std::exchange(this->starStarts_[vertex], end);
    if (count == 0)
    {
      throw InvalidInput("a tetrahedron at each vertex",
        "none at vertex " + std::to_string(nameOfVertex(vertex, nameOf)),
        "Remove unused vertices.");
    }
    end += count;
  }
  this->starStarts_.back() = end;
  this->stars_.resize(end);
  for (Index slot = 0; slot < end; ++slot)
  {
    reportNowAndThen(execution, slot, end);
    this->stars_[this->starStarts_[this->tetrahedra_.data()[slot]]++] = slot / 4;
  }
  for (Index vertex = this->vertexCount(); vertex > 0; --vertex) // each start is where one ended
  {
    this->starStarts_[vertex] = this->starStarts_[vertex - 1];
  }
  this->starStarts_[0] = 0;
}

void VolumeTopology::findLinks(const Execution& execution, const VertexName& nameOf)
{
  std::vector<LinkBlock> blocks((std::size_t(this->vertexCount()) + Grain - 1) / Grain);
  parallelFor(this->vertexCount(), Grain, execution,
    [&](std::size_t begin, std::size_t end)
    {
      LinkCollector collector(*this, blocks[begin / Grain]);
      for (std::size_t vertex = begin; vertex < end; ++vertex)
      {
        collector.add(static_cast<Index>(vertex));
      }
    });
  Index vertex = 0;
  for (LinkBlock& block : blocks)
  {
    if (!block.crowded.empty())
    {
      throw InvalidInput("at most 2 tetrahedra at each face",
        "more at that of the vertices " + textOf(block.crowded.front(), nameOf),
        "Remove tetrahedra there, which overlap.");
    }
    this->links_.insert(this->links_.end(), block.links.begin(), block.links.end());
    for (const Index size : block.sizes)
    {
      this->linkStarts_[vertex + 1] = this->linkStarts_[vertex] + size;
      ++vertex;
    }
    this->boundaryFaceCount_ += static_cast<Index>(block.boundary.size());
    for (const Face& face : block.boundary)
    {
      std::for_each(
        face.begin(), face.end(), [this](Index corner) { this->isBoundary_[corner] = 1; });
    }
    block = {};
  }
}

std::int64_t VolumeTopology::eulerCharacteristic() const
{
  const std::int64_t tetrahedronCount = this->tetrahedra_.cols();
  const std::int64_t faceCount = (4 * tetrahedronCount + this->boundaryFaceCount_) / 2;
  const auto edgeCount = static_cast<std::int64_t>(this->links_.size() / 2);
  return this->vertexCount() - edgeCount + faceCount - tetrahedronCount;
}

} // namespace SurfaceScalars
