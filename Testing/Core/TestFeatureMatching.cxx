#include "FeatureMatching.h"
#include "Functions.h"
#include "Meshes.h"
#include "Sampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>

namespace SurfaceScalars::Truth
{
namespace
{

ExtremalVertices extremaOf(const TriangleMesh& mesh, const ValuesRef& values)
{
  ExtremalVertices result;
  for (const CriticalPoint& point : meshCriticalPoints(mesh, values))
  {
    if (point.type == CriticalType::Minimum)
    {
      result.minima.push_back(static_cast<Index>(point.input));
    }
    else if (point.type == CriticalType::Maximum)
    {
      result.maxima.push_back(static_cast<Index>(point.input));
    }
  }
  return result;
}

Values randomValues(Index count, double magnitude, unsigned seed)
{
  Random random(seed);
  Values values(count);
  for (double& value : values)
  {
    value = random.uniform(-magnitude, magnitude);
  }
  return values;
}

class Matching : public testing::Test
{
protected:
  const TriangleMesh mesh_ = gridMesh(Grid::Torus, 24, 12);
  const MeshTopology topology_{ static_cast<Index>(mesh_.points.cols()), trianglesOf(mesh_) };
};

/// By definition: the vertices that a path above f(maximum) - persistence joins to the maximum.
std::vector<Index> ownedBy(
  const CriticalPoint& maximum, const MeshTopology& mesh, const Values& values, bool isGlobal)
{
  const double level = isGlobal ? -std::numeric_limits<double>::infinity()
                                : maximum.value - maximum.persistence * (1.0 - 1e-12);
  std::vector<char> isOwned(mesh.vertexCount(), 0);
  std::vector<Index> owned{ static_cast<Index>(maximum.input) };
  isOwned[maximum.input] = 1;
  for (std::size_t next = 0; next < owned.size(); ++next)
  {
    for (const Index neighbor : mesh.link(owned[next]))
    {
      if (isOwned[neighbor] == 0 && values[neighbor] > level)
      {
        isOwned[neighbor] = 1;
        owned.push_back(neighbor);
      }
    }
  }
  return owned;
}

/// The size of a largest matching, by augmenting paths.
class LargestMatching
{
public:
  explicit LargestMatching(std::vector<std::vector<Index>> choices)
    : choices_(std::move(choices))
  {
  }

  int size(Index vertexCount)
  {
    this->ownerOf_.assign(vertexCount, -1);
    int result = 0;
    for (std::size_t i = 0; i < this->choices_.size(); ++i)
    {
      std::vector<char> seen(vertexCount, 0);
      result += this->augment(static_cast<int>(i), seen) ? 1 : 0;
    }
    return result;
  }

private:
  bool augment(int owner, std::vector<char>& seen)
  {
    for (const Index choice : this->choices_[static_cast<std::size_t>(owner)])
    {
      if (seen[choice] == 0)
      {
        seen[choice] = 1;
        if (this->ownerOf_[choice] < 0 || this->augment(this->ownerOf_[choice], seen))
        {
          this->ownerOf_[choice] = owner;
          return true;
        }
      }
    }
    return false;
  }

  std::vector<std::vector<Index>> choices_;
  std::vector<int> ownerOf_;
};

// The extrema of f match themselves, whatever their persistence.
TEST_F(Matching, leavesNoneOfAFunctionToItself)
{
  const Values values = randomValues(topology_.vertexCount(), 1.0, 1);
  EXPECT_TRUE(unmatchedExtrema(topology_, values, extremaOf(mesh_, values), 0.0).empty());
}

// As few remain as a largest matching leaves, found by augmenting paths between maxima and the
// components they own, for random functions and random vertices to match.
TEST_F(Matching, leavesAsFewAsPossible)
{
  for (unsigned seed = 1; seed <= 20; ++seed)
  {
    const Values values = randomValues(topology_.vertexCount(), 1.0, seed);
    Random random(100 + seed);
    ExtremalVertices matches;
    std::vector<char> isMatch(topology_.vertexCount(), 0);
    for (Index vertex = 0; vertex < topology_.vertexCount(); ++vertex)
    {
      isMatch[vertex] = random.uniform() < 0.1 ? 1 : 0;
      if (isMatch[vertex] != 0)
      {
        matches.maxima.push_back(vertex);
      }
    }
    matches.minima = extremaOf(mesh_, values).minima;
    const double persistence = 0.3;
    std::vector<std::vector<Index>> choices;
    for (const CriticalPoint& point : meshCriticalPoints(mesh_, values))
    {
      if (point.type == CriticalType::Maximum && point.persistence > persistence)
      {
        std::vector<Index> owned =
          ownedBy(point, topology_, values, point.value == values.maxCoeff());
        owned.erase(std::remove_if(owned.begin(), owned.end(),
                      [&](Index vertex) { return isMatch[vertex] == 0; }),
          owned.end());
        choices.push_back(owned);
      }
    }
    const int maximumCount = static_cast<int>(choices.size());
    const int matched = LargestMatching(choices).size(topology_.vertexCount());
    EXPECT_GT(matched, 0);
    EXPECT_LT(matched, maximumCount);
    EXPECT_EQ(static_cast<int>(unmatchedExtrema(topology_, values, matches, persistence).size()),
      maximumCount - matched);
  }
}

// Stability: a function at most d away has a counterpart for every extremum of persistence above
// 2 d, and for some below it has none.
TEST_F(Matching, leavesNothingThatNoiseCannotExplain)
{
  const double noise = 0.1;
  std::size_t explained = 0;
  for (unsigned seed = 1; seed <= 20; ++seed)
  {
    const Values clean = valuesOf(tiltedHeight(), mesh_.points);
    const Values values = clean + randomValues(topology_.vertexCount(), noise, seed);
    const ExtremalVertices matches = extremaOf(mesh_, clean);
    EXPECT_TRUE(unmatchedExtrema(topology_, values, matches, 2.0 * noise).empty());
    explained += unmatchedExtrema(topology_, values, matches, 0.0).size();
  }
  EXPECT_GT(explained, 20u);
}

// An extremum whose counterpart is taken away is named, and no other.
TEST_F(Matching, namesWhatIsMissing)
{
  const Values values = valuesOf(cosinesOfAngles(), mesh_.points);
  const ExtremalVertices all = extremaOf(mesh_, values);
  ASSERT_EQ(all.maxima.size(), 12u);
  for (std::size_t i = 0; i < all.maxima.size(); ++i)
  {
    ExtremalVertices others = all;
    others.maxima.erase(others.maxima.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_EQ(
      unmatchedExtrema(topology_, values, others, 0.1), std::vector<Index>{ all.maxima[i] });
  }
}

} // namespace
} // namespace SurfaceScalars::Truth
