#include "FunctionDesign.h"
#include "LinkWalk.h"
#include "Meshes.h"
#include "Sampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <deque>
#include <string>

namespace SurfaceScalars::Truth
{
namespace
{

/// A mesh for the core, and as walked along by the test.
struct Surface
{
  explicit Surface(const std::string& meshName, const TriangleMesh& mesh)
    : name(meshName)
    , design(mesh.points, trianglesOf(mesh))
    , links(orderedLinks(mesh))
    , eulerCharacteristic(mesh.eulerCharacteristic())
  {
  }

  std::string name;
  DesignMesh design;
  std::vector<OrderedLink> links;
  int eulerCharacteristic;
};

const std::deque<Surface>& surfaces()
{
  static const std::deque<Surface> all = []
  {
    std::deque<Surface> result;
    result.emplace_back("sphere", subdividedSphere(5));
    result.emplace_back("torus", plateWithHoles(1, 3));
    result.emplace_back("genus 2", plateWithHoles(2, 3));
    result.emplace_back("genus 3", plateWithHoles(3, 3));
    return result;
  }();
  return all;
}

/// Puts points where no two are neighbors, nor have a neighbor in common.
class Placement
{
public:
  Placement(const MeshTopology& mesh, unsigned seed)
    : mesh_(mesh)
    , random_(seed)
    , isTaken_(mesh.vertexCount(), 0)
  {
  }

  void add(CriticalType type, int multiplicity = 1)
  {
    for (;;)
    {
      const auto vertex = static_cast<Index>(this->random_.uniform() * this->mesh_.vertexCount());
      const VertexRange link = this->mesh_.link(vertex);
      const bool isFree = this->isTaken_[vertex] == 0 &&
        std::none_of(link.begin(), link.end(), [&](Index v) { return this->isTaken_[v] != 0; });
      if (isFree && static_cast<int>(link.size()) >= 2 * multiplicity + 2)
      {
        this->isTaken_[vertex] = 1;
        std::for_each(link.begin(), link.end(), [&](Index v) { this->isTaken_[v] = 1; });
        this->requests_.push_back({ vertex, type, multiplicity, std::nullopt, {} });
        return;
      }
    }
  }

  const std::vector<CriticalRequest>& requests() const { return this->requests_; }

private:
  const MeshTopology& mesh_;
  Random random_;
  std::vector<char> isTaken_;
  std::vector<CriticalRequest> requests_;
};

DesignedFunction cleanDesign(const Surface& surface, const std::vector<CriticalRequest>& requests,
  SmoothingEnergy energy = SmoothingEnergy::Biharmonic)
{
  DesignParameters parameters;
  parameters.energy = energy;
  parameters.cleanUp = true;
  return designFunction(surface.design, requests, parameters);
}

int criticalCount(const std::vector<VertexType>& types)
{
  return static_cast<int>(std::count_if(types.begin(), types.end(),
    [](const VertexType& type) { return type.type != CriticalType::Regular; }));
}

/// Euler's formula can be met by the requests alone: then they are all that is critical, by an
/// independent walk around each vertex, whatever their places and multiplicities.
TEST(DesignCleanUp, addsNothingToWhatEulersFormulaAllows)
{
  for (const Surface& surface : surfaces())
  {
    for (const unsigned seed : { 1u, 2u, 3u })
    {
      Placement placement(surface.design.topology(), seed);
      placement.add(CriticalType::Minimum);
      placement.add(CriticalType::Maximum);
      placement.add(CriticalType::Maximum);
      int left = 3 - surface.eulerCharacteristic; // of the sum of the indices
      for (; left >= 2 && seed > 1; left -= 2)
      {
        placement.add(CriticalType::Saddle, 2);
      }
      for (; left > 0; --left)
      {
        placement.add(CriticalType::Saddle);
      }
      for (const auto energy : { SmoothingEnergy::Biharmonic, SmoothingEnergy::Harmonic })
      {
        const DesignedFunction design = cleanDesign(surface, placement.requests(), energy);
        const std::vector<VertexType> types = typesByWalking(surface.links, design.values);
        const std::string what = surface.name + ", seed " + std::to_string(seed);
        for (const CriticalRequest& request : placement.requests())
        {
          const VertexType asked{ request.type, request.multiplicity };
          EXPECT_TRUE(types[request.vertex] == asked) << what << ", vertex " << request.vertex;
        }
        EXPECT_EQ(static_cast<int>(placement.requests().size()), criticalCount(types)) << what;
      }
    }
  }
}

/// A component needs a minimum and a maximum, and every other index that misses to the Euler
/// characteristic is that of one more simple point at least: no more are added.
TEST(DesignCleanUp, addsNoMoreThanEulersFormulaAsksFor)
{
  for (const Surface& surface : surfaces())
  {
    for (const unsigned seed : { 4u, 5u })
    {
      Placement placement(surface.design.topology(), seed);
      const int maxima = seed == 4 ? 3 : 0;
      const int saddles = seed == 4 ? 0 : 2;
      for (int i = 0; i < maxima; ++i)
      {
        placement.add(CriticalType::Maximum);
      }
      for (int i = 0; i < saddles; ++i)
      {
        placement.add(CriticalType::Saddle);
      }
      const int sum = (maxima > 0 ? maxima : 1) - saddles + 1; // with a minimum and a maximum
      const int needed = (maxima > 0 ? 1 : 2) + std::abs(sum - surface.eulerCharacteristic);
      const DesignedFunction design = cleanDesign(surface, placement.requests());
      EXPECT_TRUE(design.missing.empty()) << surface.name;
      int multiplicities = 0;
      for (const VertexType& type : typesByWalking(surface.links, design.values))
      {
        multiplicities += type.multiplicity;
      }
      EXPECT_EQ(maxima + saddles + needed, multiplicities) << surface.name << ", seed " << seed;
    }
  }
}

/// Values in the order that paths from one point to the next need are kept.
TEST(DesignCleanUp, keepsValues)
{
  for (const Surface& surface : surfaces())
  {
    Placement placement(surface.design.topology(), 6);
    placement.add(CriticalType::Minimum);
    for (int i = 0; i < 2 - surface.eulerCharacteristic + 1; ++i)
    {
      placement.add(CriticalType::Saddle);
    }
    placement.add(CriticalType::Maximum);
    placement.add(CriticalType::Maximum);
    std::vector<CriticalRequest> requests = placement.requests();
    for (std::size_t i = 0; i < requests.size(); ++i)
    {
      requests[i].value = static_cast<double>(i);
    }
    const DesignedFunction design = cleanDesign(surface, requests);
    EXPECT_TRUE(design.missing.empty()) << surface.name;
    EXPECT_EQ(requests.size(), design.critical.points.size()) << surface.name;
    for (const CriticalRequest& request : requests)
    {
      EXPECT_NEAR(*request.value, design.values[request.vertex], 1e-9) << surface.name;
    }
  }
}

} // namespace
} // namespace SurfaceScalars::Truth
