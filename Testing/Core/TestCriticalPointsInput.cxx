#include "CriticalCases.h"
#include "Error.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <limits>

using namespace SurfaceScalars;
using namespace SurfaceScalars::Truth;

namespace
{

/// Everything that is found, compared bit for bit.
bool identical(const FuzzyCriticalPoints& a, const FuzzyCriticalPoints& b)
{
  const auto same = [](const CriticalPoint& x, const CriticalPoint& y)
  {
    return x.position == y.position && x.type == y.type && x.multiplicity == y.multiplicity &&
      x.value == y.value && x.input == y.input && x.persistence == y.persistence &&
      x.probability == y.probability && x.residual == y.residual;
  };
  return std::equal(a.points.begin(), a.points.end(), b.points.begin(), b.points.end(), same) &&
    a.samples.probability == b.samples.probability && a.samples.gradient == b.samples.gradient &&
    a.samples.normal == b.samples.normal && a.samples.type == b.samples.type;
}

FoundPoints findWith(const CriticalPointParameters& parameters)
{
  return findOn(tiltedTorus(), 500, 1, 0.0, parameters);
}

std::string refusalOf(const CriticalPointParameters& parameters)
{
  try
  {
    findWith(parameters);
  }
  catch (const InvalidInput& error)
  {
    return error.what();
  }
  return "";
}

} // namespace

// f -> a f + b, motions and scalings of the points leave the points where they are and scale values
// and gradients.
TEST(CriticalPointsInvariance, holds)
{
  const Points points = randomTorus(5000, Torus::Closed, 1);
  const Values values = valuesAt(points, wavyTorus().value);
  const Eigen::Matrix3d rotation =
    Eigen::AngleAxisd(1.0, Vector3d(1.0, 2.0, -1.0).normalized()).toRotationMatrix();
  const Vector3d shift(100.0, -20.0, 3.0);
  const double length = 250.0;
  const double scale = -3e6;
  const Points moved = (length * (rotation * points)).colwise() + shift;
  const FoundPoints original = findAmong(points, values);
  const FoundPoints other = findAmong(moved, (scale * values).array() + 1e7);
  ASSERT_EQ(original.critical.points.size(), 48u);
  ASSERT_EQ(other.critical.points.size(), 48u);
  for (const CriticalPoint& point : original.critical.points)
  {
    CriticalType type = point.type;
    if (type != CriticalType::Saddle)
    {
      type = type == CriticalType::Minimum ? CriticalType::Maximum : CriticalType::Minimum;
    }
    const Vector3d place = length * (rotation * point.position) + shift;
    const CriticalPoint* same = nearestOfType(other.critical.points, { place, type, 0.0 });
    ASSERT_NE(same, nullptr);
    EXPECT_LT((same->position - place).norm(), 0.02 * other.graph.medianSamplingStep());
    EXPECT_NEAR(same->value, scale * point.value + 1e7, 1e-3 * std::abs(scale));
  }
}

// The number of threads changes nothing, not even bits.
TEST(CriticalPointsExecution, doesNotDependOnThreads)
{
  const Points points = randomTorus(20000, Torus::Closed, 2);
  Values values = valuesAt(points, wavyTorus().value);
  addNoise(values, 0.02, 3);
  EXPECT_TRUE(identical(findAmong(points, values, {}, { 1, {} }).critical,
    findAmong(points, values, {}, { 4, {} }).critical));
}

// Progress runs from 0 to 1 without falling back; an abort is heard wherever it comes.
TEST(CriticalPointsExecution, reportsAndAborts)
{
  const Points points = randomTorus(20000, Torus::Closed, 2);
  const Values values = valuesAt(points, wavyTorus().value);
  const NeighborGraph graph(points, NeighborQuery());
  double last = 0.0;
  bool falls = false;
  findCriticalPoints(graph, graph.average(values), {},
    { 2,
      [&](double fraction)
      {
        falls = falls || fraction < last;
        last = fraction;
        return true;
      } });
  EXPECT_FALSE(falls);
  EXPECT_DOUBLE_EQ(last, 1.0);
  for (const double limit : { 0.0, 0.05, 0.3, 0.7, 0.9 })
  {
    const Progress until = [=](double fraction) { return fraction < limit; };
    EXPECT_THROW(findCriticalPoints(graph, graph.average(values), {}, { 2, until }), Aborted);
  }
}

// Of pairs that persist too little both go, so that the sum of the indices stays.
TEST(CriticalPointsPersistence, keepsTheIndexSum)
{
  CriticalPointParameters parameters;
  parameters.persistenceThreshold = 0.9;
  const FoundPoints all = findOn(wavyTorus(), 10000, 1);
  const FoundPoints few = findOn(wavyTorus(), 10000, 1, 0.0, parameters);
  EXPECT_LT(few.critical.points.size(), all.critical.points.size());
  EXPECT_EQ(few.critical.indexSum, all.critical.indexSum);
}

// Whatever cannot be worked on is refused with a sentence that names it.
TEST(CriticalPointsInput, isRefused)
{
  CriticalPointParameters parameters;
  parameters.scheme = Scheme::Linear;
  EXPECT_NE(refusalOf(parameters).find("Linear"), std::string::npos);
  parameters.scheme = Scheme::GlobalRBF;
  EXPECT_NE(refusalOf(parameters).find("GlobalRBF"), std::string::npos);
  parameters = {};
  parameters.polynomialDegree = 5;
  EXPECT_NE(refusalOf(parameters).find("5"), std::string::npos);
  parameters = {};
  parameters.neighborCount = 3;
  EXPECT_NE(refusalOf(parameters).find("NeighborCount"), std::string::npos);
  parameters = {};
  parameters.searchRadius = -1.0;
  EXPECT_NE(refusalOf(parameters).find("-1"), std::string::npos);
  parameters = {};
  parameters.scheme = Scheme::LocalRBF;
  parameters.kernel = KernelType::Harmonic;
  EXPECT_NE(refusalOf(parameters).find("Harmonic"), std::string::npos);
  parameters = {};
  parameters.probabilityModel = ProbabilityModel::NormalAngle;
  EXPECT_NE(refusalOf(parameters).find("VolumeFunction"), std::string::npos);
  parameters = {};
  parameters.persistenceThreshold = 1.5;
  EXPECT_NE(refusalOf(parameters).find("1.5"), std::string::npos);
}

// Samples that are too few, on a line, or without a finite value each.
TEST(CriticalPointsInput, needsASurfaceOfValues)
{
  const Points five = randomPlane(5, 1);
  EXPECT_THROW(findAmong(five, Values::Zero(5)), InvalidInput);
  Points line = Points::Zero(3, 100);
  line.row(0).setLinSpaced(100, 0.0, 1.0);
  EXPECT_THROW(findAmong(line, line.row(0).transpose()), InvalidInput);
  const Points points = randomPlane(100, 1);
  const NeighborGraph graph(points, NeighborQuery());
  EXPECT_THROW(findCriticalPoints(graph, Values::Zero(99), {}), InvalidInput);
  Values values = Values::Zero(100);
  values[7] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(findCriticalPoints(graph, values, {}), InvalidInput);
}
