// Level sets with radial functions, for F (LocalRBF, Hybrid) and for the surface (SurfaceModel
// RBF).

#include "Error.h"
#include "Functions.h"
#include "Sampling.h"
#include "Tracing.h"
#include "TruthRun.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace SurfaceScalars::Truth
{
namespace
{

struct Choice
{
  const char* name;
  Scheme scheme;
  SurfaceModel surface;
};

/// The combinations that have radial functions in them.
const std::vector<Choice>& choices()
{
  static const std::vector<Choice> all{
    { "LocalRBF on MLS", Scheme::LocalRBF, SurfaceModel::MLS },
    { "LocalRBF on RBF", Scheme::LocalRBF, SurfaceModel::RBF },
    { "LocalRBF unprojected", Scheme::LocalRBF, SurfaceModel::Unprojected },
    { "Hybrid on MLS", Scheme::Hybrid, SurfaceModel::MLS },
    { "ParameterizedMLS on RBF", Scheme::ParameterizedMLS, SurfaceModel::RBF },
    { "ExplicitMLS on RBF", Scheme::ExplicitMLS, SurfaceModel::RBF },
    { "Linear on RBF", Scheme::Linear, SurfaceModel::RBF },
  };
  return all;
}

ContourParameters with(const Choice& choice, std::vector<double> isoValues)
{
  ContourParameters parameters = at(std::move(isoValues));
  parameters.scheme = choice.scheme;
  parameters.surface = choice.surface;
  return parameters;
}

// On a torus sampled at random, closed or cut, every iso-value has the right number of closed and
// open curves, and those of the models that interpolate are as close as those of the default.
TEST(LevelSetsRadial, areRightOnTheTorus)
{
  for (const Choice& choice : choices())
  {
    SCOPED_TRACE(choice.name);
    if (choice.scheme == Scheme::ExplicitMLS)
    {
      continue; // its averages lose curves with any surface
    }
    TruthResult all;
    for (const Torus torus : { Torus::Closed, Torus::Cut })
    {
      const TruthCase truthCase = makeTruthCase(tiltedHeight(), torus, 7);
      all.add(runTruth(truthCase, TruthSampling{ 5000 }, with(choice, {})));
    }
    EXPECT_EQ(all.rightCount, all.isoValueCount) << all.disagreements;
    const bool onLevelSet =
      choice.scheme != Scheme::Linear && choice.surface != SurfaceModel::Unprojected;
    EXPECT_LT(all.score.pointMean(), onLevelSet ? 0.005 : 0.02);
    EXPECT_LT(all.score.pointMaximum, 0.3);
  }
}

// The projection (14) arrives: samples of clean data converge, in all but a few places at the cut.
TEST(LevelSetsRadial, haveConvergedSamples)
{
  const Points points = randomTorus(5000, Torus::Closed, 1);
  const Values values = valuesOf(tiltedHeight(), points);
  for (const Choice& choice : choices())
  {
    if (choice.scheme == Scheme::ExplicitMLS)
    {
      continue;
    }
    const Traced traced = trace(points, values, with(choice, { -0.5, 0.1, 0.6 }));
    std::size_t converged = 0;
    for (const LevelSetSample& sample : traced.levelSets.samples)
    {
      converged += sample.point.converged ? 1 : 0;
    }
    EXPECT_GT(converged, 0.99 * static_cast<double>(traced.levelSets.samples.size()))
      << choice.name;
  }
}

// A given function can be traced on the radial surface: the section of the torus by a plane.
TEST(LevelSetsRadial, cutTheRadialSurface)
{
  const Points points = randomTorus(5000, Torus::Closed, 1);
  ContourParameters parameters = with({ "", Scheme::ParameterizedMLS, SurfaceModel::RBF }, { 0.1 });
  parameters.volumeFunction = [](const Vector3d& place, Vector3d* gradient)
  {
    if (gradient)
    {
      *gradient = Vector3d::UnitZ();
    }
    return place.z();
  };
  const Traced traced = trace(points, points.row(2).transpose(), parameters);
  ASSERT_EQ(traced.levelSets.componentCounts, std::vector<int>{ 2 });
  for (const LevelSetCurve& curve : traced.levelSets.curves)
  {
    EXPECT_TRUE(curve.closed);
    for (const LevelSetPoint& point : curve.points)
    {
      EXPECT_NEAR(point.position.z(), 0.1, 1e-8);
      EXPECT_LT(std::abs(torusDistance(point.position)), 0.02 * traced.step());
    }
  }
}

// With noise the radial surface is fitted by least squares, and the curves stay whole.
TEST(LevelSetsRadial, fitTheSurfaceThroughNoise)
{
  TruthSampling sampling{ 10000 };
  sampling.pointNoise = 0.005;
  const TruthCase truthCase = makeTruthCase(tiltedHeight(), Torus::Closed, 4);
  const TruthResult result =
    runTruth(truthCase, sampling, with({ "", Scheme::ParameterizedMLS, SurfaceModel::RBF }, {}));
  EXPECT_EQ(result.rightCount, result.isoValueCount) << result.disagreements;
  EXPECT_LT(result.score.pointMean(), 0.5 * result.pointNoiseInSteps);
}

// Neither the number of threads nor the order of the samples matters.
TEST(LevelSetsRadial, areTheSameForAnyThreadsAndOrder)
{
  const Points points = randomTorus(3000, Torus::Closed, 1);
  const Values values = valuesOf(tiltedHeight(), points);
  for (const Choice& choice : choices())
  {
    const ContourParameters parameters = with(choice, { -0.3, 0.4 });
    const Traced one = trace(points, values, parameters, { 1, {} });
    const Traced more = trace(points, values, parameters, { 3, {} });
    const Traced backwards = trace(points.rowwise().reverse(), values.reverse(), parameters);
    EXPECT_TRUE(identical(one.levelSets, more.levelSets)) << choice.name;
    EXPECT_TRUE(identical(one.levelSets, backwards.levelSets)) << choice.name;
  }
}

// Units do not matter, nor does a large offset.
TEST(LevelSetsRadial, doNotDependOnUnits)
{
  const Points points = randomTorus(3000, Torus::Closed, 1);
  const Values values = valuesOf(tiltedHeight(), points);
  for (const Choice& choice : choices())
  {
    const Traced traced = trace(points, values, with(choice, { 0.4 }));
    for (const double scale : { std::ldexp(1.0, -30), std::ldexp(1.0, 20) })
    {
      const Traced scaled = trace(scale * points, scale * values, with(choice, { 0.4 * scale }));
      EXPECT_EQ(scaled.levelSets.componentCounts, traced.levelSets.componentCounts) << choice.name;
    }
    const Points moved = points.colwise() + Vector3d(4e6, -4e6, 4e6);
    EXPECT_EQ(trace(moved, values, with(choice, { 0.4 })).levelSets.componentCounts,
      traced.levelSets.componentCounts)
      << choice.name;
  }
}

/// Samples that are no surface, or not one everywhere.
struct BadInput
{
  const char* name;
  Points points;
  Values values;
};

std::vector<BadInput> badInputs()
{
  const Points torus = randomTorus(800, Torus::Closed, 1);
  const Values heights = valuesOf(tiltedHeight(), torus);
  std::vector<BadInput> result;
  Points nearlyDouble(3, 1600);
  nearlyDouble << torus, torus.array() + 1e-13;
  result.push_back({ "near duplicates", nearlyDouble, heights.replicate(2, 1) });
  Values wild = heights;
  wild[7] = 1e300;
  result.push_back({ "a wild value", torus, wild });
  Points stray = torus;
  stray.col(3) = Vector3d(1e6, 0.0, 0.0);
  result.push_back({ "a stray point", stray, heights });
  Points lines(3, 600);
  for (int i = 0; i < 600; ++i)
  {
    lines.col(i) = Vector3d(0.001 * (i / 6), i % 6, 0.0);
  }
  result.push_back({ "scan lines", lines, lines.row(0) + 0.1 * lines.row(1) });
  result.push_back({ "steps", torus, (4.0 * heights.array()).round().matrix() });
  Random random(5);
  Points cube(3, 500);
  Values noise(500);
  for (int i = 0; i < 500; ++i)
  {
    const double x = random.uniform();
    const double y = random.uniform();
    cube.col(i) = Vector3d(x, y, random.uniform());
    noise[i] = random.normal();
  }
  result.push_back({ "a filled cube of noise", cube, noise });
  result.push_back({ "few points", torus.leftCols(8), heights.head(8) });
  result.push_back({ "a grid", squareGrid(20, 0.1), squareGrid(20, 0.1).row(0).transpose() });
  return result;
}

// Whatever the samples, tracing ends: with curves of finite points, or a sentence.
TEST(LevelSetsRadial, surviveBadInput)
{
  for (const BadInput& input : badInputs())
  {
    const double middle = 0.5 * (input.values.minCoeff() + input.values.maxCoeff());
    for (const Choice& choice : choices())
    {
      SCOPED_TRACE(std::string(input.name) + ", " + choice.name);
      try
      {
        const Traced traced =
          trace(input.points, input.values, with(choice, { middle, input.values[0], 0.25 }));
        for (const LevelSetCurve& curve : traced.levelSets.curves)
        {
          for (const LevelSetPoint& point : curve.points)
          {
            EXPECT_TRUE(point.position.allFinite() && point.normal.allFinite());
          }
        }
      }
      catch (const InvalidInput& error)
      {
        EXPECT_NE(std::string(error.what()).find("needs"), std::string::npos) << error.what();
      }
    }
  }
}

// What no contour can be made with is refused: a scheme without a local model, a kernel that is
// infinite at samples, a width that makes the systems singular.
TEST(LevelSetsRadial, refuseWhatCannotBeSolved)
{
  const Points points = randomTorus(1500, Torus::Closed, 1);
  const Values values = valuesOf(tiltedHeight(), points);
  ContourParameters global = at({ 0.1 });
  global.scheme = Scheme::GlobalRBF;
  EXPECT_THROW(trace(points, values, global), InvalidInput);
  for (const Choice& choice : { Choice{ "", Scheme::LocalRBF, SurfaceModel::MLS },
         Choice{ "", Scheme::ParameterizedMLS, SurfaceModel::RBF } })
  {
    ContourParameters parameters = with(choice, { 0.1 });
    parameters.kernel = KernelType::Harmonic;
    EXPECT_THROW(trace(points, values, parameters), InvalidInput);
    parameters.kernel = KernelType::Gaussian;
    parameters.kernelWidth = 100.0;
    EXPECT_THROW(trace(points, values, parameters), InvalidInput);
  }
}

// Refusing progress stops the tracing at any time.
TEST(LevelSetsRadial, abort)
{
  const Points points = randomTorus(3000, Torus::Closed, 1);
  const Values values = valuesOf(tiltedHeight(), points);
  const NeighborGraph graph(points, NeighborQuery());
  for (const Choice& choice : choices())
  {
    for (const double limit : { 0.0, 0.15, 0.4, 0.7 })
    {
      const Execution stopped{ 2, [=](double fraction) { return fraction <= limit; } };
      EXPECT_THROW(
        traceLevelSets(graph, graph.average(values), with(choice, { -0.3, 0.4 }), stopped), Aborted)
        << choice.name << ", " << limit;
    }
  }
}

} // namespace
} // namespace SurfaceScalars::Truth
