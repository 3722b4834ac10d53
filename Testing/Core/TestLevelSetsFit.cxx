#include "Functions.h"
#include "Sampling.h"
#include "Tracing.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace SurfaceScalars::Truth
{
namespace
{

double squaredRadius(const Vector3d& p)
{
  return p.squaredNorm();
}

const std::vector<double> IsoValues{ 0.09, 0.25, 0.49,
  1.21 }; // three circles and the arcs in four corners

struct Disc
{
  Points points = randomPlane(20000, 1);
  Values values = valuesOf(squaredRadius, this->points);
};

std::vector<double> segmentLengths(const LevelSetCurve& curve)
{
  std::vector<double> lengths;
  const std::size_t count = curve.points.size();
  for (std::size_t i = 0; i + (curve.closed ? 0 : 1) < count; ++i)
  {
    lengths.push_back((curve.points[(i + 1) % count].position - curve.points[i].position).norm());
  }
  return lengths;
}

/// Sum of the angles between successive segments: 2 pi for a convex closed curve, more for a wiggly
/// one.
double totalTurning(const LevelSetCurve& curve)
{
  const std::size_t count = curve.points.size();
  double turning = 0.0;
  for (std::size_t i = 0; i < count; ++i)
  {
    if (!curve.closed && (i == 0 || i + 1 == count))
    {
      continue;
    }
    const Vector3d& place = curve.points[i].position;
    const Vector3d before = place - curve.points[(i + count - 1) % count].position;
    const Vector3d after = curve.points[(i + 1) % count].position - place;
    turning += std::atan2(before.cross(after).norm(), before.dot(after));
  }
  return turning;
}

/// Largest distance of a curve's points from the circle it should be.
double largestError(const Traced& traced, const LevelSetCurve& curve)
{
  const double radius = std::sqrt(traced.levelSets.isoValues[curve.level]);
  double largest = 0.0;
  for (const LevelSetPoint& point : curve.points)
  {
    largest = std::max(largest, std::abs(point.position.norm() - radius));
  }
  return largest;
}

// Resampled, every curve has equal segments, as long as asked for as far as its length allows, and
// stays on the level set.
TEST(LevelSetsFit, sampleSpacingIsUniform)
{
  const Disc disc;
  const double step = trace(disc.points, disc.values, at({})).step();
  const Traced plain = trace(disc.points, disc.values, at(IsoValues));
  for (const double spacingInSteps : { 0.5, 1.7, 4.0 })
  {
    ContourParameters parameters = at(IsoValues);
    parameters.sampleSpacing = spacingInSteps * step;
    const Traced traced = trace(disc.points, disc.values, parameters);
    ASSERT_EQ(traced.levelSets.componentCounts, (std::vector<int>{ 1, 1, 1, 4 }));
    ASSERT_EQ(traced.levelSets.curves.size(), plain.levelSets.curves.size());
    for (std::size_t i = 0; i < traced.levelSets.curves.size(); ++i)
    {
      const LevelSetCurve& curve = traced.levelSets.curves[i];
      EXPECT_EQ(curve.closed, plain.levelSets.curves[i].closed);
      const auto lengths = segmentLengths(curve);
      const auto [shortest, longest] = std::minmax_element(lengths.begin(), lengths.end());
      EXPECT_GT(*shortest, 0.95 * *longest);
      EXPECT_NEAR(*longest, parameters.sampleSpacing, 0.1 * parameters.sampleSpacing);
      EXPECT_LT(largestError(traced, curve), 0.1 * step) << spacingInSteps;
    }
  }
}

// Open curves keep their ends when they are resampled.
TEST(LevelSetsFit, sampleSpacingKeepsTheEnds)
{
  const Disc disc;
  const Traced plain = trace(disc.points, disc.values, at({ 1.21 }));
  ContourParameters parameters = at({ 1.21 });
  parameters.sampleSpacing = 2.0 * plain.step();
  const Traced traced = trace(disc.points, disc.values, parameters);
  ASSERT_EQ(traced.levelSets.curves.size(), plain.levelSets.curves.size());
  for (std::size_t i = 0; i < plain.levelSets.curves.size(); ++i)
  {
    const auto& before = plain.levelSets.curves[i].points;
    const auto& after = traced.levelSets.curves[i].points;
    EXPECT_LT((before.front().position - after.front().position).norm(), 0.01 * plain.step());
    EXPECT_LT((before.back().position - after.back().position).norm(), 0.01 * plain.step());
  }
}

// Without noise a least-squares curve is the interpolating one to a fraction of a step.
TEST(LevelSetsFit, leastSquaresKeepsCleanCurves)
{
  const Disc disc;
  ContourParameters parameters = at(IsoValues);
  parameters.fit = CurveFit::LeastSquares;
  const Traced traced = trace(disc.points, disc.values, parameters);
  ASSERT_EQ(traced.levelSets.componentCounts, (std::vector<int>{ 1, 1, 1, 4 }));
  for (const LevelSetCurve& curve : traced.levelSets.curves)
  {
    EXPECT_LT(largestError(traced, curve), 0.1 * traced.step());
    EXPECT_EQ(curve.closed, curve.level != 3);
    if (curve.closed)
    {
      EXPECT_NEAR(totalTurning(curve), 2.0 * Pi, 0.01);
    }
  }
}

// With noise it is smoother: what the curves of a level turn beyond the 2 pi that each closed one
// must falls.
TEST(LevelSetsFit, leastSquaresSmoothsNoisyCurves)
{
  Disc disc;
  addNoise(disc.values, 0.02, 2);
  ContourParameters parameters = at({ 0.09, 0.25, 0.49 });
  parameters.neighborCount = 100; // too few to average the noise away
  const Traced interpolating = trace(disc.points, disc.values, parameters);
  parameters.fit = CurveFit::LeastSquares;
  const Traced smooth = trace(disc.points, disc.values, parameters);

  std::vector<double> turningBefore(3, 0.0);
  std::vector<double> turningAfter(3, 0.0);
  for (const LevelSetCurve& curve : interpolating.levelSets.curves)
  {
    turningBefore[curve.level] += totalTurning(curve) - (curve.closed ? 2.0 * Pi : 0.0);
  }
  for (const LevelSetCurve& curve : smooth.levelSets.curves)
  {
    turningAfter[curve.level] += totalTurning(curve) - (curve.closed ? 2.0 * Pi : 0.0);
    EXPECT_LT(largestError(smooth, curve), 5.0 * smooth.step());
  }
  EXPECT_EQ(smooth.levelSets.componentCounts, interpolating.levelSets.componentCounts);
  for (std::size_t level = 0; level < 3; ++level)
  {
    EXPECT_LT(turningAfter[level], 0.7 * turningBefore[level]);
  }
}

// The spacing is even along the curve, not along the spline's parameter: also on an ellipse, whose
// curvature changes by a factor of 40.
TEST(LevelSetsFit, spacingIsEvenOnCurvesOfChangingCurvature)
{
  const auto elliptic = [](const Vector3d& p) { return p.x() * p.x() + 12.0 * p.y() * p.y(); };
  const Points points = randomPlane(5000, 3);
  for (const CurveFit fit : { CurveFit::Interpolate, CurveFit::LeastSquares })
  {
    SCOPED_TRACE(fit == CurveFit::Interpolate ? "interpolating" : "least squares");
    ContourParameters parameters = at({ 0.3 });
    parameters.fit = fit;
    parameters.sampleSpacing = 0.014; // half a step
    const Traced traced = trace(points, valuesOf(elliptic, points), parameters);
    ASSERT_EQ(traced.levelSets.componentCounts, std::vector<int>{ 1 });
    const auto lengths = segmentLengths(traced.levelSets.curves.front());
    const auto [shortest, longest] = std::minmax_element(lengths.begin(), lengths.end());
    EXPECT_GT(*shortest, 0.9 * *longest);
    EXPECT_NEAR(*longest, parameters.sampleSpacing, 0.1 * parameters.sampleSpacing);
  }
}

// Both together: smooth and evenly spaced.
TEST(LevelSetsFit, leastSquaresCanBeResampled)
{
  const Disc disc;
  ContourParameters parameters = at(IsoValues);
  parameters.fit = CurveFit::LeastSquares;
  parameters.sampleSpacing = 0.04;
  const Traced traced = trace(disc.points, disc.values, parameters);
  ASSERT_EQ(traced.levelSets.componentCounts, (std::vector<int>{ 1, 1, 1, 4 }));
  for (const LevelSetCurve& curve : traced.levelSets.curves)
  {
    const auto lengths = segmentLengths(curve);
    const auto [shortest, longest] = std::minmax_element(lengths.begin(), lengths.end());
    EXPECT_GT(*shortest, 0.95 * *longest);
    EXPECT_LT(largestError(traced, curve), 0.1 * traced.step());
  }
}

} // namespace
} // namespace SurfaceScalars::Truth
