#include "Error.h"
#include "LinkWalk.h"
#include "Meshes.h"
#include "Sampling.h"
#include "TopologicalSimplification.h"
#include "Torus.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

namespace SurfaceScalars::Truth
{
namespace
{

/// A mesh twice: for the core, and as walked along by the test.
struct Surface
{
  explicit Surface(TriangleMesh triangleMesh)
    : mesh(std::move(triangleMesh))
    , topology(static_cast<Index>(mesh.points.cols()), trianglesOf(mesh))
    , links(orderedLinks(mesh))
  {
  }

  TriangleMesh mesh;
  MeshTopology topology;
  std::vector<OrderedLink> links;
};

struct Extrema
{
  std::vector<Index> minima;
  std::vector<Index> maxima;

  bool operator==(const Extrema& other) const
  {
    return this->minima == other.minima && this->maxima == other.maxima;
  }
};

std::ostream& operator<<(std::ostream& stream, const Extrema& extrema)
{
  return stream << extrema.minima.size() << " minima, " << extrema.maxima.size() << " maxima";
}

Extrema extremaOf(const Surface& surface, const Values& values)
{
  Extrema extrema;
  const std::vector<VertexType> types = typesByWalking(surface.links, values);
  for (std::size_t vertex = 0; vertex < types.size(); ++vertex)
  {
    if (types[vertex].type == CriticalType::Minimum)
    {
      extrema.minima.push_back(static_cast<Index>(vertex));
    }
    if (types[vertex].type == CriticalType::Maximum)
    {
      extrema.maxima.push_back(static_cast<Index>(vertex));
    }
  }
  return extrema;
}

Values keep(const Surface& surface, const Values& values, const Extrema& extrema)
{
  return keepExtrema(surface.topology, values, extrema.minima, extrema.maxima);
}

/// Random numbers, rounded to that many levels, or not for 0.
Values noise(const Surface& surface, int levels, unsigned seed)
{
  Random random(seed);
  Values values(surface.mesh.points.cols());
  for (double& value : values)
  {
    value = levels > 0 ? std::floor(random.uniform(0.0, levels)) : random.uniform(-1.0, 1.0);
  }
  return values;
}

/// Some of the vertices, each with the same probability, and for each component the first.
std::vector<Index> someOf(
  const Surface& surface, const std::vector<Index>& vertices, double probability, Random& random)
{
  std::vector<char> hasSome(surface.topology.componentCount(), 0);
  std::vector<Index> result;
  for (const Index vertex : vertices)
  {
    char& has = hasSome[surface.topology.component(vertex)];
    if (has == 0 || random.uniform() < probability)
    {
      result.push_back(vertex);
      has = 1;
    }
  }
  return result;
}

Extrema someOf(const Surface& surface, const Extrema& extrema, double probability, unsigned seed)
{
  Random random(seed);
  Extrema result;
  result.minima = someOf(surface, extrema.minima, probability, random);
  result.maxima = someOf(surface, extrema.maxima, probability, random);
  return result;
}

std::vector<Surface> surfaces()
{
  std::vector<Surface> result;
  result.emplace_back(TriangleMesh{ Points::Random(3, 3), { { 2, 0, 1 } } });
  result.emplace_back(subdividedSphere(0));
  result.emplace_back(subdividedSphere(3));
  result.emplace_back(gridMesh(Grid::Torus, 3, 3));
  result.emplace_back(gridMesh(Grid::Torus, 20, 13));
  result.emplace_back(gridMesh(Grid::Patch, 12, 9));
  result.emplace_back(gridMesh(Grid::Patch, 100, 1)); // on which sweeps alone are slow to end
  result.emplace_back(gridMesh(Grid::Moebius, 16, 5));
  result.emplace_back(plateWithHoles(3, 1));
  result.emplace_back(besideEachOther(gridMesh(Grid::Cylinder, 6, 4), plateWithHoles(1, 0)));
  return result;
}

int eulerSum(const std::vector<VertexType>& types)
{
  return std::accumulate(types.begin(), types.end(), 0,
    [](int sum, const VertexType& type) { return sum + indexOf(type.type, type.multiplicity); });
}

// The minima and maxima of the result are those that were asked for, no other, for white noise and
// for plateaus; the number of saddles is then Euler's.
TEST(TopologicalSimplification, extremaAreExactlyThose)
{
  for (const Surface& surface : surfaces())
  {
    for (unsigned seed = 0; seed < 60; ++seed)
    {
      const Values values = noise(surface, seed % 3 == 0 ? 3 : 0, seed);
      const Extrema asked = someOf(surface, extremaOf(surface, values), 0.1 * (seed % 10), seed);
      const Values kept = keep(surface, values, asked);

      EXPECT_EQ(extremaOf(surface, kept), asked) << seed;
      if (surface.topology.isClosed())
      {
        EXPECT_EQ(
          eulerSum(typesByWalking(surface.links, kept)), surface.topology.eulerCharacteristic());
      }
    }
  }
}

// Vertices that were no extrema become some.
TEST(TopologicalSimplification, anyVerticesCanBecomeExtrema)
{
  for (const Surface& surface : surfaces())
  {
    for (unsigned seed = 0; seed < 40; ++seed)
    {
      const Values values = noise(surface, seed % 2 == 0 ? 2 : 0, seed);
      const Extrema ofOther = extremaOf(surface, noise(surface, 0, seed + 1000));
      const Extrema asked = someOf(surface, ofOther, 0.3, seed);
      EXPECT_EQ(extremaOf(surface, keep(surface, values, asked)), asked) << seed;
    }
  }
}

// Nothing changes if all extrema are kept, ties and all; what was simplified is not changed again.
TEST(TopologicalSimplification, changesNothingWithoutNeed)
{
  for (const Surface& surface : surfaces())
  {
    for (unsigned seed = 0; seed < 10; ++seed)
    {
      const Values values = noise(surface, seed % 2 == 0 ? 4 : 0, seed);
      const Extrema all = extremaOf(surface, values);
      EXPECT_EQ(keep(surface, values, all), values);

      const Extrema some = someOf(surface, all, 0.2, seed);
      const Values kept = keep(surface, values, some);
      EXPECT_EQ(keep(surface, kept, some), kept);
    }
  }
}

/// The extrema of at least some persistence; `cancelled` is the largest of the others.
Extrema persistentExtrema(
  const Surface& surface, const Values& values, double threshold, double& cancelled)
{
  Extrema extrema;
  cancelled = 0.0;
  for (const CriticalPoint& point : meshCriticalPoints(surface.mesh, values))
  {
    if (point.type == CriticalType::Saddle)
    {
      continue;
    }
    if (point.persistence < threshold)
    {
      cancelled = std::max(cancelled, point.persistence);
      continue;
    }
    (point.type == CriticalType::Minimum ? extrema.minima : extrema.maxima)
      .push_back(static_cast<Index>(point.input));
  }
  return extrema;
}

/// A tilted height and noise, fractions of its range.
Values noisyHeight(const Surface& surface, double amount, unsigned seed)
{
  Values values = surface.mesh.points.transpose() * Vector3d(0.5, 0.2, 0.84);
  addNoise(values, amount * (values.maxCoeff() - values.minCoeff()), seed);
  return values;
}

// If what is cancelled is what has little persistence, no value changes by more than the largest
// persistence cancelled (nor by less than half of it, which nobody can avoid), and extrema that
// are kept keep their values.
TEST(TopologicalSimplification, movesValuesByThePersistenceCancelled)
{
  std::vector<Surface> closed;
  closed.emplace_back(subdividedSphere(4));
  closed.emplace_back(gridMesh(Grid::Torus, 40, 25));
  closed.emplace_back(plateWithHoles(3, 2));
  for (const Surface& surface : closed)
  {
    for (const double amount : { 0.01, 0.05, 0.3 })
    {
      for (unsigned seed = 1; seed <= 5; ++seed)
      {
        const Values values = noisyHeight(surface, amount, seed);
        const double range = values.maxCoeff() - values.minCoeff();
        double cancelled = 0.0;
        const Extrema asked = persistentExtrema(surface, values, 0.1 * seed * range, cancelled);
        const Values kept = keep(surface, values, asked);

        ASSERT_EQ(extremaOf(surface, kept), asked);
        const double change = (kept - values).lpNorm<Eigen::Infinity>();
        EXPECT_LE(change, cancelled * (1.0 + 1e-9));
        EXPECT_GE(change, 0.5 * cancelled * (1.0 - 1e-9));
        for (const std::vector<Index>& vertices : { asked.minima, asked.maxima })
        {
          for (const Index vertex : vertices)
          {
            EXPECT_NEAR(kept[vertex], values[vertex], 1e-12 * range);
          }
        }
      }
    }
  }
}

// A pit and the pass to it meet half way; the pit does not become flat.
TEST(TopologicalSimplification, pitsAreSqueezedNotFlattened)
{
  const Surface surface(gridMesh(Grid::Patch, 40, 40));
  Values values(surface.mesh.points.cols());
  for (Eigen::Index i = 0; i < values.size(); ++i)
  {
    const Vector3d p = surface.mesh.points.col(i);
    values[i] =
      p.x() + 0.01 * p.y() - 0.4 * std::exp(-50.0 * (p - Vector3d(0.5, 0.5, 0.0)).squaredNorm());
  }
  double cancelled = 0.0;
  const Extrema asked = persistentExtrema(surface, values, 0.5, cancelled);
  ASSERT_EQ(asked.minima.size(), 1u);
  ASSERT_GT(cancelled, 0.05);
  const Values kept = keep(surface, values, asked);
  EXPECT_NEAR((kept - values).lpNorm<Eigen::Infinity>(), 0.5 * cancelled, 1e-12);
  EXPECT_TRUE(std::none_of(surface.mesh.triangles.begin(), surface.mesh.triangles.end(),
    [&](const std::array<int, 3>& triangle)
    {
      const auto [least, largest] =
        std::minmax({ kept[triangle[0]], kept[triangle[1]], kept[triangle[2]] });
      return largest - least < 1e-9;
    }));
}

// Constant functions of any magnitude get one minimum and one maximum; their values hardly change.
TEST(TopologicalSimplification, plateausGetAnOrder)
{
  for (const TriangleMesh& mesh : { subdividedSphere(5), gridMesh(Grid::Torus, 60, 50) })
  {
    const Surface surface(mesh);
    for (const double level : { 0.0, 1.0, -3.0, 1e300, -1e-300, 4e-320 })
    {
      const Values values = Values::Constant(surface.mesh.points.cols(), level);
      const Extrema asked{ { 17 }, { 4 } };
      const Values kept = keep(surface, values, asked);
      EXPECT_EQ(extremaOf(surface, kept), asked) << level;
      EXPECT_LE((kept - values).lpNorm<Eigen::Infinity>(), 1e-12 * std::abs(level) + 1e-300);
    }
  }
}

// f times a power of two gives the result times that; the order of the vertices says nothing but
// in ties, nor does the number of threads.
TEST(TopologicalSimplification, dependsOnTheFunctionAlone)
{
  const TriangleMesh mesh = gridMesh(Grid::Torus, 30, 20);
  const Surface surface(mesh);
  const Values values = noise(surface, 0, 1);
  const Extrema asked = someOf(surface, extremaOf(surface, values), 0.1, 1);
  const Values kept = keep(surface, values, asked);
  EXPECT_EQ(keep(surface, 8.0 * values, asked), 8.0 * kept);
  EXPECT_EQ(keepExtrema(surface.topology, values, asked.minima, asked.maxima, { 1, {} }), kept);

  TriangleMesh reversed = mesh;
  const Index last = surface.topology.vertexCount() - 1;
  for (std::array<int, 3>& triangle : reversed.triangles)
  {
    for (int& vertex : triangle)
    {
      vertex = static_cast<int>(last) - vertex;
    }
  }
  Extrema other = asked;
  for (std::vector<Index>* vertices : { &other.minima, &other.maxima })
  {
    for (Index& vertex : *vertices)
    {
      vertex = last - vertex;
    }
  }
  const Values keptThere = keep(Surface(reversed), values.reverse(), other);
  EXPECT_LT((keptThere.reverse() - kept).lpNorm<Eigen::Infinity>(), 1e-13);
}

std::string refusal(const Surface& surface, const Values& values, const Extrema& extrema)
{
  try
  {
    keepExtrema(surface.topology, values, extrema.minima, extrema.maxima, {},
      [](Index vertex) { return vertex + 1000; });
    return "taken";
  }
  catch (const InvalidInput& error)
  {
    return error.what();
  }
}

// What cannot be done is refused, by the names of the vertices.
TEST(TopologicalSimplification, refusesWhatCannotBe)
{
  const Surface surface(besideEachOther(subdividedSphere(1), gridMesh(Grid::Patch, 3, 3)));
  const Index inSecond = surface.topology.vertexCount() - 1;
  Values values = noise(surface, 0, 1);
  const Extrema good = extremaOf(surface, values);
  const auto expectIn = [](const char* part, const std::string& sentence)
  { EXPECT_NE(sentence.find(part), std::string::npos) << sentence; };

  expectIn("taken", refusal(surface, values, good));
  expectIn("in that of vertex 1000", refusal(surface, values, { { inSecond }, good.maxima }));
  expectIn("at least one maximum", refusal(surface, values, { good.minima, {} }));
  expectIn("for both", refusal(surface, values, { good.minima, good.minima }));
  const auto neighbor = static_cast<Index>(surface.links[0].vertices[0]);
  expectIn("Leave one out", refusal(surface, values, { { 0, neighbor }, good.maxima }));
  expectIn("vertex 99", refusal(surface, values, { { 99 }, good.maxima }));
  expectIn("values for", refusal(surface, values.head(5), good));
  for (const double bad : { std::numeric_limits<double>::quiet_NaN(),
         std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::max() })
  {
    values[7] = bad;
    EXPECT_NE(refusal(surface, values, good), "taken") << bad;
  }
}

// Progress never falls and ends at 1; whenever it says no, the work stops.
TEST(TopologicalSimplification, canBeAborted)
{
  const Surface surface(gridMesh(Grid::Torus, 300, 250));
  const Values values = noise(surface, 0, 1);
  const Extrema asked = someOf(surface, extremaOf(surface, values), 0.0, 1);
  std::vector<double> fractions;
  keepExtrema(surface.topology, values, asked.minima, asked.maxima,
    { 2, [&](double fraction) { return fractions.push_back(fraction), true; } });
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_NEAR(fractions.back(), 1.0, 1e-12);
  for (std::size_t stop = 0; stop < fractions.size() / 2; stop += 5)
  {
    std::size_t calls = 0;
    EXPECT_THROW(keepExtrema(surface.topology, values, asked.minima, asked.maxima,
                   { 2, [&](double) { return calls++ < stop; } }),
      Aborted);
  }
}

} // namespace
} // namespace SurfaceScalars::Truth
