#include "Error.h"
#include "VolumeExamples.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace SurfaceScalars::Truth
{
namespace
{

/// The sentence with which tetrahedra are refused.
std::string refusal(Index vertexCount, const Tetrahedra& tetrahedra, const VertexName& nameOf = {})
{
  try
  {
    const VolumeTopology volume(vertexCount, tetrahedra, {}, nameOf);
    return "taken";
  }
  catch (const InvalidInput& error)
  {
    return error.what();
  }
}

void expectIn(const std::string& part, const std::string& sentence)
{
  EXPECT_NE(sentence.find(part), std::string::npos) << sentence;
}

Tetrahedra cells(std::initializer_list<std::array<Index, 4>> list)
{
  Tetrahedra result(4, static_cast<Eigen::Index>(list.size()));
  Eigen::Index cell = 0;
  for (const auto& [a, b, c, d] : list)
  {
    result.col(cell++) << a, b, c, d;
  }
  return result;
}

// V - E + F - T, components and boundary are what the volume has.
TEST(VolumeTopology, countsWhatIsThere)
{
  for (const NamedVolume& named : volumesOfAllKinds())
  {
    SCOPED_TRACE(named.name);
    const VolumeTopology topology = topologyOf(named.volume);
    EXPECT_EQ(topology.eulerCharacteristic(), named.eulerCharacteristic);
    EXPECT_EQ(topology.componentCount(), static_cast<Index>(named.components));
    EXPECT_EQ(topology.isClosed(), named.isClosed);
    const std::vector<bool> isBoundary = boundaryOf(named.volume);
    for (Index vertex = 0; vertex < topology.vertexCount(); ++vertex)
    {
      EXPECT_EQ(topology.isBoundary(vertex), isBoundary[vertex]) << vertex;
    }
  }
}

// Stars and links are those that a walk over all tetrahedra finds.
TEST(VolumeTopology, knowsNeighbors)
{
  for (const NamedVolume& named : volumesOfAllKinds())
  {
    SCOPED_TRACE(named.name);
    const VolumeTopology topology = topologyOf(named.volume);
    std::vector<std::set<Index>> stars(topology.vertexCount());
    std::vector<std::set<Index>> links(topology.vertexCount());
    for (Eigen::Index cell = 0; cell < named.volume.tetrahedra.cols(); ++cell)
    {
      for (const Index vertex : named.volume.tetrahedra.col(cell))
      {
        stars[vertex].insert(static_cast<Index>(cell));
        for (const Index other : named.volume.tetrahedra.col(cell))
        {
          if (other != vertex)
          {
            links[vertex].insert(other);
          }
        }
      }
    }
    for (Index vertex = 0; vertex < topology.vertexCount(); ++vertex)
    {
      const auto star = topology.star(vertex);
      const auto link = topology.link(vertex);
      EXPECT_TRUE(std::equal(star.begin(), star.end(), stars[vertex].begin(), stars[vertex].end()));
      EXPECT_TRUE(std::equal(link.begin(), link.end(), links[vertex].begin(), links[vertex].end()));
    }
  }
}

// Parts may meet in a vertex or an edge: three tetrahedra around an edge of another two's vertex.
TEST(VolumeTopology, needNotBeAManifold)
{
  const VolumeTopology topology(9, cells({ { 0, 1, 2, 3 }, { 0, 1, 4, 5 }, { 5, 6, 7, 8 } }));
  EXPECT_EQ(topology.componentCount(), 1U);
  EXPECT_EQ(topology.eulerCharacteristic(), 1);
  EXPECT_EQ(topology.link(0).size(), 5U);
}

TEST(VolumeTopology, refusesWhatIsNoVolume)
{
  expectIn("tetrahedra, found none", refusal(0, Tetrahedra(4, 0)));
  expectIn("corners below 4, the number of vertices, found 7 in tetrahedron 0",
    refusal(4, cells({ { 0, 1, 2, 7 } })));
  const VertexName byTens = [](Index vertex) { return std::size_t{ 10 } * vertex; };
  expectIn("vertex 20 twice in tetrahedron 1",
    refusal(5, cells({ { 0, 1, 2, 3 }, { 2, 1, 4, 2 } }), byTens));
  expectIn("none at vertex 40", refusal(6, cells({ { 0, 1, 2, 3 }, { 0, 1, 2, 5 } }), byTens));
  expectIn("at most 2 tetrahedra at each face, found more at that of the vertices 0, 10 and 20",
    refusal(6, cells({ { 0, 1, 2, 3 }, { 0, 1, 2, 4 }, { 0, 1, 2, 5 } }), byTens));
}

} // namespace
} // namespace SurfaceScalars::Truth
