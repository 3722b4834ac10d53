#include "CriticalScore.h"
#include "Sampling.h"
#include "Torus.h"
#include "TriangleMesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <queue>
#include <set>

namespace SurfaceScalars::Truth
{
namespace
{

constexpr int GridSize = 24;
constexpr Eigen::Index VertexCount = Eigen::Index{ GridSize } * GridSize;

/// The torus as squares of its angles, each cut in two.
TriangleMesh torusMesh()
{
  TriangleMesh mesh;
  mesh.points.resize(3, VertexCount);
  const auto vertex = [](int i, int j) { return i % GridSize * GridSize + j % GridSize; };
  for (int i = 0; i < GridSize; ++i)
  {
    for (int j = 0; j < GridSize; ++j)
    {
      mesh.points.col(vertex(i, j)) = torusPoint(2.0 * Pi / GridSize * Vector2d(i, j));
      mesh.triangles.push_back({ vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1) });
      mesh.triangles.push_back({ vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1) });
    }
  }
  return mesh;
}

Values randomValues(unsigned seed)
{
  Values values = Values::Zero(VertexCount);
  addNoise(values, 1.0, seed);
  return values;
}

/// The neighbors of a vertex in cyclic order, by walking around it.
std::vector<int> linkOf(const TriangleMesh& mesh, int vertex)
{
  std::map<int, int> next;
  for (const std::array<int, 3>& triangle : mesh.triangles)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      if (triangle[i] == vertex)
      {
        next[triangle[(i + 1) % 3]] = triangle[(i + 2) % 3];
      }
    }
  }
  std::vector<int> link{ next.begin()->first };
  while (next.at(link.back()) != link.front())
  {
    link.push_back(next.at(link.back()));
  }
  return link;
}

/// How much f has to rise on a way from the vertex to a lower one: the vertex' persistence as a
/// minimum, by flooding.
double riseToALowerVertex(const TriangleMesh& mesh, const Values& values, int vertex)
{
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> shore;
  std::set<int> reached{ vertex };
  shore.emplace(values[vertex], vertex);
  double level = values[vertex];
  while (!shore.empty())
  {
    const auto [value, lowest] = shore.top();
    shore.pop();
    if (value < values[vertex])
    {
      return level - values[vertex];
    }
    level = std::max(level, value);
    for (const int neighbor : linkOf(mesh, lowest))
    {
      if (reached.insert(neighbor).second)
      {
        shore.emplace(values[neighbor], neighbor);
      }
    }
  }
  return values.maxCoeff() - values.minCoeff();
}

// Around a saddle of multiplicity m, f crosses the saddle's value 2 + 2m times, around an extremum
// never, around others twice. Their indices sum to the Euler characteristic.
TEST(TruthMesh, criticalVerticesAreThoseOfTheLinks)
{
  const TriangleMesh mesh = torusMesh();
  ASSERT_EQ(mesh.eulerCharacteristic(), 0);
  const Values values = randomValues(3);
  std::map<int, CriticalPoint> critical;
  int indexSum = 0;
  for (const CriticalPoint& point : meshCriticalPoints(mesh, values))
  {
    critical[static_cast<int>(point.input)] = point;
    indexSum += indexOf(point);
  }
  EXPECT_EQ(indexSum, 0);
  for (int vertex = 0; vertex < values.size(); ++vertex)
  {
    const std::vector<int> link = linkOf(mesh, vertex);
    int changes = 0;
    for (std::size_t i = 0; i < link.size(); ++i)
    {
      const int next = link[(i + 1) % link.size()];
      changes += (values[link[i]] > values[vertex]) != (values[next] > values[vertex]) ? 1 : 0;
    }
    const auto found = critical.find(vertex);
    ASSERT_EQ(found == critical.end(), changes == 2);
    if (changes > 2)
    {
      EXPECT_EQ(found->second.type, CriticalType::Saddle);
      EXPECT_EQ(2 + 2 * found->second.multiplicity, changes);
    }
    else if (changes == 0)
    {
      EXPECT_EQ(found->second.type,
        values[link.front()] > values[vertex] ? CriticalType::Minimum : CriticalType::Maximum);
    }
  }
}

// The persistence of a minimum is the least rise on a way to a lower vertex; that of a maximum is
// the same of -f.
TEST(TruthMesh, persistenceIsTheLeastRise)
{
  const TriangleMesh mesh = torusMesh();
  const Values values = randomValues(4);
  int count = 0;
  for (const CriticalPoint& point : meshCriticalPoints(mesh, values))
  {
    if (point.type == CriticalType::Saddle)
    {
      EXPECT_GT(point.persistence, 0.0);
      continue;
    }
    const double sign = point.type == CriticalType::Minimum ? 1.0 : -1.0;
    EXPECT_NEAR(point.persistence,
      riseToALowerVertex(mesh, sign * values, static_cast<int>(point.input)), 1e-14);
    ++count;
  }
  EXPECT_GT(count, 100);
}

CriticalPoint pointAt(double x, CriticalType type, int multiplicity = 1)
{
  CriticalPoint point;
  point.position = Vector3d(x, 0.0, 0.0);
  point.type = type;
  point.multiplicity = multiplicity;
  return point;
}

// Only pairs of one type and multiplicity count, each point once, the nearer pair first.
TEST(TruthScore, countsPairsOnce)
{
  const std::vector<CriticalPoint> exact{ pointAt(0.0, CriticalType::Minimum),
    pointAt(1.0, CriticalType::Saddle, 2), pointAt(2.0, CriticalType::Maximum) };
  const std::vector<CriticalPoint> found{ pointAt(0.1, CriticalType::Minimum),
    pointAt(-0.05, CriticalType::Minimum), pointAt(1.0, CriticalType::Saddle, 1),
    pointAt(2.3, CriticalType::Maximum), pointAt(5.0, CriticalType::Uncertain) };
  const CriticalScore score = scoreCriticalPoints(found, exact, unambiguousRadius(exact));
  EXPECT_EQ(score.exactCount, 3);
  EXPECT_EQ(score.foundCount, 4);
  EXPECT_EQ(score.uncertainCount, 1);
  EXPECT_EQ(score.rightCount, 1);
  EXPECT_DOUBLE_EQ(score.errorMaximum, 0.05);

  const CriticalScore inside =
    scoreCriticalPoints(found, exact, 0.25, [](const Vector3d& place) { return place.x() < 1.5; });
  EXPECT_EQ(inside.exactCount, 2);
  EXPECT_EQ(inside.foundCount, 3);
}

} // namespace
} // namespace SurfaceScalars::Truth
