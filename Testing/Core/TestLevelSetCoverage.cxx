#include "Error.h"
#include "LevelSetCoverage.h"
#include "MeshFunctions.h"
#include "TetrahedralGrid.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include <cmath>
#include <limits>
#include <string>

namespace SurfaceScalars::Truth
{
namespace
{

constexpr double Tolerance = 1e-4;

SimplicialMesh simplicesOf(const TriangleMesh& mesh)
{
  return { mesh.points, trianglesOf(mesh) };
}

double measure(const SimplicialMesh& mesh, Eigen::Index simplex)
{
  const auto place = [&](int corner) -> Vector3d
  { return mesh.vertices.col(mesh.simplices(corner, simplex)); };
  if (mesh.simplices.rows() == 3)
  {
    const double a = (place(1) - place(0)).norm();
    const double b = (place(2) - place(1)).norm();
    const double c = (place(0) - place(2)).norm();
    const double s = 0.5 * (a + b + c); // Heron
    return std::sqrt(std::max(0.0, s * (s - a) * (s - b) * (s - c)));
  }
  Eigen::Matrix4d corners = Eigen::Matrix4d::Ones();
  for (int i = 0; i < 4; ++i)
  {
    corners.col(i).head<3>() = place(i);
  }
  return std::abs(corners.determinant()) / 6.0;
}

/// Whether an edge has one end that is not above the value and another that is not below.
bool meets(const SimplicialMesh& mesh, Eigen::Index simplex, const Values& values, double isoValue)
{
  bool isMet = false;
  for (const Index i : mesh.simplices.col(simplex))
  {
    for (const Index j : mesh.simplices.col(simplex))
    {
      isMet = isMet || (i != j && values[i] <= isoValue && values[j] >= isoValue);
    }
  }
  return isMet;
}

/// The definition: the areas of the simplices that a value meets, each once.
double bruteForce(const SimplicialMesh& mesh, const Values& values, const Values& isoValues)
{
  double covered = 0.0;
  double whole = 0.0;
  for (Eigen::Index simplex = 0; simplex < mesh.simplices.cols(); ++simplex)
  {
    bool isMet = false;
    for (const double isoValue : isoValues)
    {
      isMet = isMet || meets(mesh, simplex, values, isoValue);
    }
    covered += isMet ? measure(mesh, simplex) : 0.0;
    whole += measure(mesh, simplex);
  }
  return covered / whole;
}

LevelSetCoverage coverageOf(
  const SimplicialMesh& mesh, const Values& values, double tolerance = Tolerance)
{
  return levelSetCoverage(mesh.vertices, mesh.simplices, values, tolerance);
}

/// c_k and the covered simplices are those of the definition.
void expectDefinition(const SimplicialMesh& mesh, const Values& values, const std::string& name)
{
  constexpr int fewEnough = 9; // halvings for the brute force
  const LevelSetCoverage coverage = coverageOf(mesh, values, 0.01);
  const int count = static_cast<int>(coverage.coverages.size());
  for (int k = 1; k <= std::min(count, fewEnough); ++k)
  {
    EXPECT_NEAR(coverage.coverages[static_cast<std::size_t>(k - 1)],
      bruteForce(mesh, values, dyadicIsoValues(values, k)), 1e-9)
      << name << ", k = " << k;
  }
  if (count <= fewEnough)
  {
    for (Eigen::Index simplex = 0; simplex < mesh.simplices.cols(); ++simplex)
    {
      bool isMet = false;
      for (const double isoValue : coverage.isoValues)
      {
        isMet = isMet || meets(mesh, simplex, values, isoValue);
      }
      EXPECT_EQ(coverage.covered[static_cast<std::size_t>(simplex)] != 0, isMet) << name;
    }
  }
}

// The coverage is the sum of areas of its definition, for smooth, noisy, random and stepped
// functions on surfaces of all kinds.
TEST(LevelSetCoverage, isTheSumOfAreas)
{
  for (const NamedMesh& named : meshesOfAllKinds())
  {
    for (const auto& [name, values] : meshFunctions(named.mesh, 1))
    {
      expectDefinition(simplicesOf(named.mesh), values, named.name + (", " + name));
    }
  }
}

// So it is the sum of volumes on tetrahedra.
TEST(LevelSetCoverage, isTheSumOfVolumes)
{
  const SimplicialMesh grid = tetrahedralGrid(5);
  const Values smooth = (grid.vertices.colwise() - Vector3d(0.3, 0.4, 0.6)).colwise().norm();
  expectDefinition(grid, smooth, "smooth");
  Values noise = smooth;
  addNoise(noise, 1.0, 2);
  expectDefinition(grid, noise, "noise");
}

// A value that is that of a vertex, to the bit, meets the simplices around it; others do not.
TEST(LevelSetCoverage, comparesToTheBit)
{
  const SimplicialMesh mesh = simplicesOf(gridMesh(Grid::Patch, 8, 4));
  Values values(mesh.vertices.cols());
  for (const double scale : { 1.0, 0.1, 1.0 / 3.0, 1e-7 })
  {
    for (Eigen::Index i = 0; i < values.size(); ++i)
    {
      values[i] = 0.7 + scale * static_cast<double>(i % 9) / 8.0;
    }
    for (const double shift : { 0.0, 1.0, -1.0 })
    {
      Values shifted = values;
      shifted[12] = shift == 0.0 ? values[12] : std::nextafter(values[12], shift * 10.0);
      expectDefinition(mesh, shifted, "scale " + std::to_string(scale));
    }
  }
}

// The division is stationary where it ends and not before: one more halving changes the coverage
// by less than the tolerance, the last one did not.
TEST(LevelSetCoverage, endsWhereItIsStationary)
{
  const SimplicialMesh mesh = simplicesOf(subdividedSphere(5));
  const Values values = mesh.vertices.row(2).transpose();
  const std::vector<double> all = coverageOf(mesh, values, 1e-12).coverages;
  for (const double tolerance : { 0.1, 0.01, 1e-3 })
  {
    const std::vector<double> coverages = coverageOf(mesh, values, tolerance).coverages;
    std::size_t count = coverages.size();
    ASSERT_GT(count, 2u);
    ASSERT_GT(all.size(), count);
    EXPECT_TRUE(std::equal(coverages.begin(), coverages.end(), all.begin()));
    EXPECT_GE(all[count - 1] - all[count - 2], tolerance);
    for (; count < all.size() && all[count] - all[count - 1] < tolerance; ++count)
    {
    }
    EXPECT_EQ(count, all.size());
  }
}

/// Columns of triangles side by side, each from one of the values to the next, as wide as said.
struct Columns
{
  SimplicialMesh mesh;
  Values values;
};

Columns columnsOf(const Values& values, const Values& widths)
{
  const Eigen::Index count = widths.size();
  Columns result{ { Points(3, 2 * values.size()), Simplices(3, 2 * count) },
    Values(2 * values.size()) };
  double x = 0.0;
  for (Eigen::Index i = 0; i <= count; ++i)
  {
    const auto below = static_cast<Index>(2 * i); // and above is the next
    result.mesh.vertices.col(below) = Vector3d(x, 0.0, 0.0);
    result.mesh.vertices.col(below + 1) = Vector3d(x, 1.0, 0.0);
    result.values.segment<2>(below).setConstant(values[i]);
    if (i < count)
    {
      result.mesh.simplices.col(below) << below, below + 2, below + 3;
      result.mesh.simplices.col(below + 1) << below, below + 3, below + 1;
      x += widths[i];
    }
  }
  return result;
}

// What no value can meet has no say: a slope of 64 columns has the same iso-values alone and beside
// a plateau, however large, and they cover as much of it. Values meet the columns to either side of
// a vertex: c_k = 2 (2^k - 1) / 64 for k < 6, of which the fifth step adds a half, and the sixth
// the columns at the ends.
TEST(LevelSetCoverage, doesNotDependOnPlateaus)
{
  constexpr int count = 64;
  for (const double slope : { 1.0, 0.5, 0.2, 0.01, 1e-6 })
  {
    Values values = Values::LinSpaced(count + 2, 0.0, (count + 1.0) / count);
    values[count + 1] = values[count];
    Values widths = Values::Constant(count + 1, slope / count);
    widths[count] = 1.0 - slope;
    const Columns columns = columnsOf(values, widths);
    const LevelSetCoverage coverage = coverageOf(columns.mesh, columns.values, 0.2);
    ASSERT_EQ(coverage.coverages.size(), 5u) << slope;
    for (int k = 1; k <= 5; ++k)
    {
      EXPECT_NEAR(coverage.coverages[static_cast<std::size_t>(k - 1)],
        slope * 2.0 * (std::ldexp(1.0, k) - 1.0) / count, 1e-12)
        << slope;
    }
    EXPECT_EQ(coverageOf(columns.mesh, columns.values, 0.01).coverages.size(), 6u) << slope;
  }
}

// Where no step adds as much as the tolerance, it ends with the one that adds most. Of values that
// halve from column to column step k is the first to meet column k, the first step two columns.
TEST(LevelSetCoverage, endsWithTheLargestStepAtTheEarliest)
{
  const Values values =
    (Values(8) << 1.0, 0.5, 0.25, 0.125, 0.0625, 0.03125, 0.015625, 0.0).finished();
  const Values widths = (Values(7) << 1.0, 1.0, 3.0, 2.0, 4.0, 3.0, 2.0).finished() / 16.0;
  const Columns columns = columnsOf(values, widths);
  const auto stepsWith = [&](double tolerance)
  { return coverageOf(columns.mesh, columns.values, tolerance).coverages; };
  EXPECT_EQ(stepsWith(0.9).size(), 4u);
  EXPECT_NEAR(stepsWith(0.9).back(), 11.0 / 16.0, 1e-12);
  EXPECT_EQ(stepsWith(0.2).size(), 4u);  // which adds 4 / 16
  EXPECT_EQ(stepsWith(0.15).size(), 5u); // 3 / 16
  EXPECT_EQ(stepsWith(0.1).size(), 6u);  // 2 / 16
}

// Values crowded in a thousandth of the range, for one vertex is far off: the first halvings change
// nothing, which is no reason to stop.
TEST(LevelSetCoverage, looksIntoCrowdedValues)
{
  const SimplicialMesh mesh = simplicesOf(subdividedSphere(4));
  Values values = mesh.vertices.row(2).transpose();
  values[17] = 2000.0;
  const LevelSetCoverage coverage = coverageOf(mesh, values);
  EXPECT_LT(coverage.coverages[8] - coverage.coverages[0], Tolerance);
  EXPECT_GT(coverage.global(), 0.99);
  EXPECT_TRUE(coverage.isStationary);
}

// Values crowded in so small a part that a million iso-values hardly see it: it is said.
TEST(LevelSetCoverage, saysIfItIsNotStationary)
{
  const SimplicialMesh mesh = simplicesOf(subdividedSphere(4));
  Values values = mesh.vertices.row(2).transpose();
  values[17] = 1e7;
  const LevelSetCoverage coverage = coverageOf(mesh, values);
  EXPECT_FALSE(coverage.isStationary);
  EXPECT_EQ(coverage.isoValues.size(), (1 << 20) - 1);
  EXPECT_LT(coverage.global(), 0.9);
}

// The coverage tends to 1 for every function without plateaus, and to the share of the rest for one
// with them: here the caps below and above a half of the unit sphere's radius, half of its area.
TEST(LevelSetCoverage, leavesPlateausOut)
{
  const SimplicialMesh mesh = simplicesOf(subdividedSphere(6));
  const Values height = mesh.vertices.row(2).transpose();
  EXPECT_GT(coverageOf(mesh, height).global(), 0.999);
  const Values clamped = height.cwiseMax(-0.5).cwiseMin(0.5);
  EXPECT_NEAR(coverageOf(mesh, clamped).global(), 0.5, 0.03);
}

// A constant is met by nothing.
TEST(LevelSetCoverage, ofAConstantIsZero)
{
  const SimplicialMesh mesh = simplicesOf(subdividedSphere(2));
  const LevelSetCoverage coverage = coverageOf(mesh, Values::Constant(mesh.vertices.cols(), 5.0));
  EXPECT_EQ(coverage.global(), 0.0);
  EXPECT_EQ(coverage.isoValues.size(), 0);
  EXPECT_EQ(std::count(coverage.covered.begin(), coverage.covered.end(), 0), mesh.simplices.cols());
}

// Iso-values are ascending, even, inside the range, and the coarser among the finer.
TEST(LevelSetCoverage, isoValuesAreNested)
{
  const Values values = Eigen::Vector3d(-0.1, 0.7, 0.2);
  const Values fine = dyadicIsoValues(values, 10);
  ASSERT_EQ(fine.size(), 1023);
  for (Eigen::Index i = 0; i < fine.size(); ++i)
  {
    EXPECT_NEAR(fine[i], -0.1 + 0.8 * static_cast<double>(i + 1) / 1024.0, 1e-15);
  }
  const Values coarse = dyadicIsoValues(values, 4);
  for (Eigen::Index i = 0; i < coarse.size(); ++i)
  {
    EXPECT_EQ(coarse[i], fine[64 * (i + 1) - 1]);
  }
}

// Values so far from 0 that few numbers lie between them have as many iso-values as are different,
// and their coverage is that of brute force.
TEST(LevelSetCoverage, isExactWhereNumbersAreScarce)
{
  const SimplicialMesh mesh = simplicesOf(subdividedSphere(3));
  for (const double height : { 1e-3, 1e-4, 1e-5, 1e-6, 1e-7 })
  {
    const Values values = 1.7e9 + height * mesh.vertices.row(2).transpose().array();
    const LevelSetCoverage found = coverageOf(mesh, values);
    for (Eigen::Index i = 1; i < found.isoValues.size(); ++i)
    {
      ASSERT_LT(found.isoValues[i - 1], found.isoValues[i]) << height;
    }
    for (int k = 1; k <= static_cast<int>(found.coverages.size()); ++k)
    {
      EXPECT_NEAR(found.coverages[static_cast<std::size_t>(k - 1)],
        bruteForce(mesh, values, dyadicIsoValues(values, k)), 1e-9)
        << height;
    }
  }
}

// Neither the number of threads, nor the unit of f, nor that of length changes a coverage.
TEST(LevelSetCoverage, isThatOfTheFunction)
{
  const SimplicialMesh mesh = simplicesOf(gridMesh(Grid::Torus, 120, 80));
  const Values values = randomValues(gridMesh(Grid::Torus, 120, 80), 4);
  const auto coverages = coverageOf(mesh, values).coverages;
  EXPECT_EQ(levelSetCoverage(mesh.vertices, mesh.simplices, values, Tolerance, { 1, {} }).coverages,
    coverages);
  EXPECT_EQ(levelSetCoverage(mesh.vertices, mesh.simplices, values, Tolerance, { 4, {} }).coverages,
    coverages);
  EXPECT_EQ(coverageOf(mesh, 0.125 * values).coverages, coverages);
  EXPECT_EQ(coverageOf({ 1024.0 * mesh.vertices, mesh.simplices }, values).coverages, coverages);
}

// What cannot be worked on is refused; whoever wants to stop is heard.
TEST(LevelSetCoverage, refusesBadInput)
{
  const SimplicialMesh mesh = simplicesOf(subdividedSphere(1));
  const Values values = mesh.vertices.row(0).transpose();
  for (const double tolerance : { 0.0, -1.0, 1.0, std::nan("") })
  {
    EXPECT_THROW(coverageOf(mesh, values, tolerance), InvalidInput);
  }
  EXPECT_THROW(coverageOf(mesh, values.head(3)), InvalidInput);
  EXPECT_THROW(coverageOf({ mesh.vertices, Simplices(3, 0) }, values), InvalidInput);
  EXPECT_THROW(coverageOf({ mesh.vertices, Simplices::Zero(2, 1) }, values), InvalidInput);
  EXPECT_THROW(coverageOf({ mesh.vertices, Simplices::Constant(3, 1, 99) }, values), InvalidInput);
  EXPECT_THROW(
    coverageOf({ Points::Zero(3, values.size()), mesh.simplices }, values), InvalidInput);
  Values bad = values;
  bad[3] = std::numeric_limits<double>::infinity();
  EXPECT_THROW(coverageOf(mesh, bad), InvalidInput);
  bad[3] = 1.7e308;
  bad[4] = -1.7e308;
  EXPECT_THROW(coverageOf(mesh, bad), InvalidInput);
  EXPECT_THROW(levelSetCoverage(mesh.vertices, mesh.simplices, values, Tolerance,
                 { 1, [](double) { return false; } }),
    Aborted);
}

} // namespace
} // namespace SurfaceScalars::Truth
