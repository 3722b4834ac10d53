#include "MeshTopology.h"
#include "TriangleSelection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

using namespace SurfaceScalars;

namespace
{

/// The square of size x size vertices.
Triangles square(Index size)
{
  std::vector<Index> corners;
  for (Index j = 0; j + 1 < size; ++j)
  {
    for (Index i = 0; i + 1 < size; ++i)
    {
      const Index at = j * size + i;
      corners.insert(corners.end(), { at, at + 1, at + size + 1, at, at + size + 1, at + size });
    }
  }
  return Eigen::Map<const Triangles>(
    corners.data(), 3, static_cast<Eigen::Index>(corners.size() / 3));
}

/// The same triangles between the vertices that they have.
Triangles renumbered(Triangles triangles, Index& count)
{
  std::vector<Index> used(triangles.reshaped().begin(), triangles.reshaped().end());
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  count = static_cast<Index>(used.size());
  for (Index& corner : triangles.reshaped())
  {
    corner = static_cast<Index>(std::lower_bound(used.begin(), used.end(), corner) - used.begin());
  }
  return triangles;
}

} // namespace

// Without anything to leave out all is left.
TEST(TriangleSelection, keepsAllWithoutHoles)
{
  const Triangles triangles = square(5);
  EXPECT_EQ(trianglesWithout(triangles, std::vector<char>(25, 0)), triangles);
}

// A hole is the star of its vertex, nothing more.
TEST(TriangleSelection, cutsOutStars)
{
  const Triangles triangles = square(7);
  std::vector<char> leftOut(49, 0);
  leftOut[24] = 1;
  const Triangles left = trianglesWithout(triangles, leftOut);
  EXPECT_EQ(left.cols(), triangles.cols() - 6);
  EXPECT_EQ((left.array() == 24).count(), 0);
}

// Two holes that meet at a vertex leave it two fans, of which it keeps the larger: of eight
// triangles around it, those of two neighbors are cut out, which leaves one and three.
TEST(TriangleSelection, keepsTheLargerFan)
{
  Triangles fan(3, 8);
  fan << 0, 0, 0, 0, 0, 0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 2, 3, 4, 5, 6, 7, 8, 1;
  std::vector<char> leftOut(9, 0);
  leftOut[3] = leftOut[6] = 1;
  Triangles expected(3, 3);
  expected << 0, 0, 0, 1, 7, 8, 2, 8, 1;
  EXPECT_EQ(trianglesWithout(fan, leftOut), expected);
}

// Whatever is left out of a manifold, a manifold is left.
TEST(TriangleSelection, leavesManifolds)
{
  const Triangles triangles = square(40);
  for (unsigned seed = 1; seed <= 20; ++seed)
  {
    std::mt19937 generator(seed);
    std::bernoulli_distribution isOut(0.02 * seed);
    std::vector<char> leftOut(1600);
    std::generate(leftOut.begin(), leftOut.end(), [&]() { return isOut(generator); });
    Index count = 0;
    const Triangles left = renumbered(trianglesWithout(triangles, leftOut), count);
    EXPECT_GT(left.cols(), 0);
    EXPECT_NO_THROW(MeshTopology(count, left));
  }
}
