#include "CriticalCases.h"
#include "Functions.h"
#include "Sampling.h"
#include "Surfaces.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace SurfaceScalars;
using namespace SurfaceScalars::Truth;

// On 5,000 random samples every critical point is found once, with its type, within 0.15 sampling
// steps of the exact one, where the gradient of f~ is zero up to rounding.
TEST(CriticalPoints, areThoseOfTheFunction)
{
  for (const CriticalCase& truth : { tiltedTorus(), wavyTorus(), heightOfSphere() })
  {
    SCOPED_TRACE(truth.name);
    const FoundPoints found = findOn(truth, 5000, 1);
    ASSERT_EQ(found.critical.points.size(), truth.exact.size());
    EXPECT_EQ(found.critical.indexSum, truth.eulerCharacteristic);
    for (const ExactPoint& exact : truth.exact)
    {
      const CriticalPoint* point = nearestOfType(found.critical.points, exact);
      ASSERT_NE(point, nullptr);
      EXPECT_LT((point->position - exact.position).norm(), 0.15 * found.graph.medianSamplingStep());
      EXPECT_NEAR(point->value, exact.value, 5e-3);
      EXPECT_LT(point->residual, 1e-5);
    }
  }
}

// The indices of all critical points of a closed surface sum to its Euler characteristic (Poincare
// and Hopf), here of genus 0 to 3.
TEST(CriticalPoints, sumToTheEulerCharacteristic)
{
  for (const ClosedSurface& surface : { unitSphere(), closedTorus(), doubleTorus(), tripleTorus() })
  {
    const Points points = surface.sample(40000, 1);
    const NeighborGraph graph(points, NeighborQuery());
    for (const SpaceFunction& function : { tiltedHeight(), saddleWithLogarithm() })
    {
      SCOPED_TRACE(function.name + " on " + surface.name);
      const Values values = valuesOf(function, points);
      const FuzzyCriticalPoints found = findCriticalPoints(graph, graph.average(values), {});
      EXPECT_EQ(found.indexSum, surface.eulerCharacteristic);
    }
  }
}

// So they do where saddles and extrema are hardly apart: among these heights, some have them within
// one neighborhood on the thin tubes of genus 3, where a pair is found as a whole or not at all.
TEST(CriticalPoints, sumToTheEulerCharacteristicInAllDirections)
{
  const ClosedSurface surface = tripleTorus();
  const Points points = surface.sample(20000, 1);
  const NeighborGraph graph(points, NeighborQuery());
  constexpr int Directions = 12;
  for (int i = 0; i < Directions; ++i)
  {
    SCOPED_TRACE(i);
    const double z = (i + 0.5) / Directions;
    const double radius = std::sqrt(1.0 - z * z);
    const Vector3d direction(radius * std::cos(2.4 * i), radius * std::sin(2.4 * i), z);
    const Values heights = points.transpose() * direction;
    const FuzzyCriticalPoints found = findCriticalPoints(graph, graph.average(heights), {});
    EXPECT_EQ(found.indexSum, surface.eulerCharacteristic);
  }
}

// And where they follow each other on a ridge along which f hardly changes: there the gradient
// turns only within a small part of a ring. Between 0.22 and 0.37 of the second harmonic, the one
// or three critical points opposite to the maximum are about to merge.
TEST(CriticalPoints, sumToTheEulerCharacteristicOnARidge)
{
  const Points points = randomSphere(10000, 1);
  const NeighborGraph graph(points, NeighborQuery());
  for (int i = 0; i < 16; ++i)
  {
    SCOPED_TRACE(i);
    const double share = 0.22 + 0.01 * i;
    const Eigen::Rotation2Dd rotation(-0.4 * i);
    const Values values = valuesOf(
      [&](const Vector3d& p)
      {
        const Vector2d q = rotation * Vector2d(p.x(), p.y());
        const double along = q.x() + share * (q.x() * q.x() - q.y() * q.y()) + 0.02 * q.y();
        return 0.03 * along - p.z() * p.z();
      },
      points);
    EXPECT_EQ(findCriticalPoints(graph, graph.average(values), {}).indexSum, 2);
  }
}

// Noise of 1% on f and on the points hides few critical points and adds few.
TEST(CriticalPoints, areFoundInNoise)
{
  const CriticalCase truth = wavyTorus();
  const FoundPoints found = findOn(truth, 20000, 3, 0.01);
  int right = 0;
  for (const ExactPoint& exact : truth.exact)
  {
    const CriticalPoint* point = nearestOfType(found.critical.points, exact);
    right += point && (point->position - exact.position).norm() < 0.1 ? 1 : 0;
  }
  EXPECT_GE(right, 44);
  EXPECT_LE(found.critical.points.size(), 50u);
}

// The gradient at samples is the exact one projected onto the tangent plane, the normal the exact
// one outwards.
TEST(CriticalPoints, knowGradientsAndNormals)
{
  const CriticalCase truth = tiltedTorus();
  const FoundPoints found = findOn(truth, 20000, 2);
  for (Index i = 0; i < found.graph.pointCount(); i += 97)
  {
    const Vector3d place = found.graph.points().col(i) + found.graph.origin();
    const Vector3d normal = torusNormal(torusAngles(place));
    const Vector3d exact = TiltedDirection - normal * normal.dot(TiltedDirection);
    EXPECT_LT((found.critical.samples.gradient.col(i) - exact).norm(), 0.02);
    EXPECT_GT(std::abs(found.critical.samples.normal.col(i).dot(normal)), 0.999);
  }
}

// The probability is 0 to 1, largest next to critical points and next to nothing far from them.
TEST(CriticalPoints, areWhereTheProbabilityIsHigh)
{
  const CriticalCase truth = wavyTorus();
  const FoundPoints found = findOn(truth, 20000, 4);
  const Values& probability = found.critical.samples.probability;
  EXPECT_GE(probability.minCoeff(), 0.0);
  EXPECT_LE(probability.maxCoeff(), 1.0);
  for (Index i = 0; i < found.graph.pointCount(); ++i)
  {
    const Vector3d place = found.graph.points().col(i) + found.graph.origin();
    double distance = INFINITY;
    for (const ExactPoint& exact : truth.exact)
    {
      distance = std::min(distance, (place - exact.position).norm());
    }
    const double steps = distance / found.graph.medianSamplingStep();
    EXPECT_TRUE(steps > 0.5 || probability[i] > 0.5) << steps << " " << probability[i];
    EXPECT_TRUE(steps < 5.0 || probability[i] < 0.1) << steps << " " << probability[i];
  }
}

// Of 48 critical points in noise, the sample next to one has a probability above 0.1 in 9 of 10
// cases, as a chi-squared variable of two degrees would.
TEST(CriticalPoints, haveACalibratedProbability)
{
  const CriticalCase truth = wavyTorus();
  int high = 0;
  int count = 0;
  for (unsigned seed = 1; seed <= 3; ++seed)
  {
    const FoundPoints found = findOn(truth, 10000, seed, 0.01);
    Neighborhood near;
    for (const ExactPoint& exact : truth.exact)
    {
      found.graph.nearest(exact.position - found.graph.origin(), 1, near);
      high += found.critical.samples.probability[near.indices.front()] > 0.1 ? 1 : 0;
      ++count;
    }
  }
  EXPECT_GE(high, 9 * count / 10);
}

// Half as many neighbors again lead to the same critical points.
TEST(CriticalPoints, doNotDependOnTheNumberOfNeighbors)
{
  const CriticalCase truth = wavyTorus();
  CriticalPointParameters few;
  few.neighborCount = 40;
  CriticalPointParameters many = few;
  many.neighborCount = 60;
  const FoundPoints first = findOn(truth, 20000, 5, 0.0, few);
  const FoundPoints second = findOn(truth, 20000, 5, 0.0, many);
  ASSERT_EQ(first.critical.points.size(), second.critical.points.size());
  for (const CriticalPoint& point : first.critical.points)
  {
    const CriticalPoint* same =
      nearestOfType(second.critical.points, { point.position, point.type, 0.0 });
    ASSERT_NE(same, nullptr);
    EXPECT_LT((same->position - point.position).norm(), 0.1 * first.graph.medianSamplingStep());
  }
}

// Without refinement a critical point is the likeliest of the samples around it; the residual is
// the gradient there.
TEST(CriticalPoints, canBeSamples)
{
  CriticalPointParameters parameters;
  parameters.refine = false;
  const FoundPoints found = findOn(tiltedTorus(), 5000, 1, 0.0, parameters);
  ASSERT_EQ(found.critical.points.size(), 4u);
  for (const CriticalPoint& point : found.critical.points)
  {
    const Index sample = found.graph.pointOfInput(point.input);
    EXPECT_LT(
      (found.graph.points().col(sample) + found.graph.origin() - point.position).norm(), 1e-14);
    EXPECT_EQ(found.critical.samples.type[sample], point.type);
    EXPECT_NEAR(point.residual, found.critical.samples.gradient.col(sample).norm(), 1e-12);
    EXPECT_EQ(point.probability, found.critical.samples.probability[sample]);
  }
}

// Every scheme finds the four points of a tilted torus; averages see them less exactly.
TEST(CriticalPoints, areFoundWithEveryScheme)
{
  const CriticalCase truth = tiltedTorus();
  for (const Scheme scheme :
    { Scheme::ExplicitMLS, Scheme::ParameterizedMLS, Scheme::LocalRBF, Scheme::Hybrid })
  {
    CriticalPointParameters parameters;
    parameters.scheme = scheme;
    const FoundPoints found = findOn(truth, 5000, 1, 0.0, parameters);
    const bool isAverage = scheme == Scheme::ExplicitMLS || scheme == Scheme::Hybrid;
    for (const ExactPoint& exact : truth.exact)
    {
      const CriticalPoint* point = nearestOfType(found.critical.points, exact);
      ASSERT_NE(point, nullptr) << static_cast<int>(scheme);
      EXPECT_LT((point->position - exact.position).norm(),
        (isAverage ? 1.5 : 0.15) * found.graph.medianSamplingStep())
        << static_cast<int>(scheme);
    }
  }
}

// With a given F the probability is the cosine between its gradient and the normal of the surface.
TEST(CriticalPoints, canHaveTheProbabilityOfAGivenFunction)
{
  const CriticalCase truth = tiltedTorus();
  CriticalPointParameters parameters;
  parameters.probabilityModel = ProbabilityModel::NormalAngle;
  parameters.volumeFunction = [](const Vector3d& place, Vector3d* gradient)
  {
    if (gradient)
    {
      *gradient = TiltedDirection;
    }
    return TiltedDirection.dot(place);
  };
  const FoundPoints found = findOn(truth, 5000, 1, 0.0, parameters);
  ASSERT_EQ(found.critical.points.size(), 4u);
  for (Index i = 0; i < found.graph.pointCount(); i += 17)
  {
    const Vector3d place = found.graph.points().col(i) + found.graph.origin();
    const double exact = std::abs(TiltedDirection.dot(torusNormal(torusAngles(place))));
    EXPECT_NEAR(found.critical.samples.probability[i], exact, 0.02);
  }
}
