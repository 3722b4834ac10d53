#include "ConstrainedSmoothing.h"
#include "Meshes.h"
#include "SmoothingRun.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace SurfaceScalars::Truth
{
namespace
{

/// A noisy function on a torus, and what smoothing makes of it.
class SmoothingWithConstraints : public testing::Test
{
protected:
  SmoothingWithConstraints()
  {
    this->parameters_.epsilonChoice = EpsilonChoice::Manual;
    this->parameters_.epsilon = 1e6;
    this->parameters_.method = SmoothingMethod::Tikhonov;
    this->smooth_ = this->smooth().values;
    this->parameters_.method = SmoothingMethod::InterpolatingConstraints;
  }

  SmoothedFunction smooth() const
  {
    return smoothFunction(this->mesh_, this->noisy_, this->parameters_);
  }

  Index vertexCount() const { return this->mesh_.topology().vertexCount(); }

  /// Where the result has exactly the values of a function: most likely constrained.
  std::vector<Index> verticesWith(const Values& function, const Values& result) const
  {
    std::vector<Index> vertices;
    for (Index vertex = 0; vertex < this->vertexCount(); ++vertex)
    {
      if (function[vertex] == result[vertex])
      {
        vertices.push_back(vertex);
      }
    }
    return vertices;
  }

  std::vector<Index> withStars(const std::vector<Index>& vertices) const
  {
    std::vector<Index> result = vertices;
    for (const Index vertex : vertices)
    {
      const VertexRange link = this->mesh_.topology().link(vertex);
      result.insert(result.end(), link.begin(), link.end());
    }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  const SmoothingCase torus_{ "torus", gridMesh(Grid::Torus, 60, 30), waves(), 0.06 };
  const SmoothingMesh mesh_{ torus_.mesh.points, trianglesOf(torus_.mesh) };
  const Values noisy_ = torus_.noisy(0.05, 1);
  SmoothingParameters parameters_;
  Values smooth_;
};

std::vector<Index> inputsOf(const std::vector<CriticalPoint>& points)
{
  std::vector<Index> result;
  for (const CriticalPoint& point : points)
  {
    result.push_back(static_cast<Index>(point.input));
  }
  return result;
}

// Critical points of f keep their values, their neighbors those of smoothed f; without
// smoothedStars all keep those of f.
TEST_F(SmoothingWithConstraints, keepCriticalPointsOfTheInput)
{
  const std::vector<Index> critical = inputsOf(meshCriticalPoints(torus_.mesh, noisy_));
  parameters_.constraints = ConstraintChoice::AllCriticalPoints;
  for (const double delta : { 0.0, 0.02 })
  {
    parameters_.constraints =
      delta > 0.0 ? ConstraintChoice::DeltaSimplified : ConstraintChoice::AllCriticalPoints;
    parameters_.delta = delta;
    parameters_.includeOneStars = false;
    const std::vector<Index> kept = verticesWith(noisy_, smooth().values);
    EXPECT_TRUE(std::includes(critical.begin(), critical.end(), kept.begin(), kept.end()));
    EXPECT_EQ(kept.size() == critical.size(), delta == 0.0);

    parameters_.includeOneStars = true;
    const Values result = smooth().values;
    for (const Index vertex : withStars(kept))
    {
      const bool isKept = std::binary_search(kept.begin(), kept.end(), vertex);
      EXPECT_EQ(result[vertex], isKept ? noisy_[vertex] : smooth_[vertex]);
    }
    parameters_.smoothedStars = false;
    EXPECT_EQ(verticesWith(noisy_, smooth().values), withStars(kept));
    parameters_.smoothedStars = true;
  }
}

// The persistent critical points of smoothed f and their stars have its values, and so are critical
// in the result.
TEST_F(SmoothingWithConstraints, keepPersistentPointsOfTheSmoothFunction)
{
  parameters_.persistenceThreshold = 0.05;
  const SmoothedFunction result = smooth();
  std::vector<Index> persistent;
  for (const CriticalPoint& point : meshCriticalPoints(torus_.mesh, smooth_))
  {
    const double range = noisy_.maxCoeff() - noisy_.minCoeff();
    if (point.type != CriticalType::Saddle && point.persistence >= 0.05 * range)
    {
      persistent.push_back(static_cast<Index>(point.input));
    }
  }
  EXPECT_GT(persistent.size(), 4u);
  const std::vector<Index> critical = inputsOf(result.critical.points);
  EXPECT_TRUE(
    std::includes(critical.begin(), critical.end(), persistent.begin(), persistent.end()));
  for (const Index vertex : withStars(persistent))
  {
    EXPECT_EQ(result.values[vertex], smooth_[vertex]);
  }
}

// Marked vertices keep f; the rest has no more energy than any other function with these values, as
// f itself and the smooth function moved there.
TEST_F(SmoothingWithConstraints, interpolateWithLeastEnergy)
{
  parameters_.constraints = ConstraintChoice::MaskArray;
  parameters_.includeOneStars = false;
  parameters_.mask.assign(vertexCount(), 0);
  for (Index vertex = 0; vertex < vertexCount(); vertex += 100)
  {
    parameters_.mask[vertex] = 1;
  }
  for (const SmoothingEnergy energy : { SmoothingEnergy::Harmonic, SmoothingEnergy::Biharmonic })
  {
    parameters_.norms.energy = energy;
    const SmoothedFunction result = smooth();
    Values other = smooth_;
    for (Index vertex = 0; vertex < vertexCount(); vertex += 100)
    {
      EXPECT_EQ(result.values[vertex], noisy_[vertex]);
      other[vertex] = noisy_[vertex];
    }
    EXPECT_EQ(result.epsilon, 0.0) << "not needed";
    const TikhonovSmoother& smoother = mesh_.smoother(parameters_.norms);
    const double energyOfResult = smoother.energy(result.values);
    EXPECT_NEAR(result.seminorm * result.seminorm, energyOfResult, 1e-9 * energyOfResult);
    EXPECT_LT(energyOfResult, smoother.energy(other));
    EXPECT_LT(energyOfResult, smoother.energy(noisy_));
    const Values better = result.values + 1e-3 * (other - result.values);
    EXPECT_LT(energyOfResult, smoother.energy(better));
  }
}

// Least squares tend to the values at constrained vertices as epsilon grows.
TEST_F(SmoothingWithConstraints, fitBetterForLargerEpsilon)
{
  parameters_.constraints = ConstraintChoice::AllCriticalPoints;
  parameters_.includeOneStars = false;
  const Values interpolated = smooth().values;
  parameters_.method = SmoothingMethod::LeastSquaresConstraints;
  double last = std::numeric_limits<double>::infinity();
  for (const double epsilon : { 1e4, 1e7, 1e10, 1e13 })
  {
    parameters_.epsilon = epsilon;
    const double distance = (smooth().values - interpolated).lpNorm<Eigen::Infinity>();
    EXPECT_LT(distance, last);
    last = distance;
  }
  EXPECT_LT(last, 1e-3 * torus_.range);
}

// FeaturePreserving keeps the extrema of the smooth function that are marked, and the lowest and
// the highest.
TEST_F(SmoothingWithConstraints, preserveMarkedExtrema)
{
  parameters_.method = SmoothingMethod::FeaturePreserving;
  parameters_.constraints = ConstraintChoice::MaskArray;
  parameters_.mask.assign(vertexCount(), 0);
  CriticalCounts expected{ 0, 0, 0 };
  int turn = 0;
  for (const CriticalPoint& point : meshCriticalPoints(torus_.mesh, smooth_))
  {
    const bool isGlobal = point.value == smooth_.minCoeff() || point.value == smooth_.maxCoeff();
    if (point.type != CriticalType::Saddle && (isGlobal || ++turn % 2 == 0))
    {
      parameters_.mask[point.input] = isGlobal ? 0 : 1;
      ++(point.type == CriticalType::Minimum ? expected.minima : expected.maxima);
    }
  }
  EXPECT_GT(turn, 6);
  const SmoothedFunction result = smooth();
  EXPECT_EQ(result.outputCounts.minima, expected.minima);
  EXPECT_EQ(result.outputCounts.maxima, expected.maxima);
}

// Marks on extrema of f, which noise has moved, keep those of the smooth function in the components
// that they own; a marked one of which noise is all there is, is named.
TEST_F(SmoothingWithConstraints, preserveWhatIsMarkedOfTheInput)
{
  parameters_.method = SmoothingMethod::FeaturePreserving;
  parameters_.constraints = ConstraintChoice::MaskArray;
  parameters_.mask.assign(vertexCount(), 0);
  const double range = noisy_.maxCoeff() - noisy_.minCoeff();
  CriticalCounts expected{ 0, 0, 0 };
  Index moved = 0;
  Index ofNoise = 0;
  for (const CriticalPoint& point : meshCriticalPoints(torus_.mesh, noisy_))
  {
    if (point.type == CriticalType::Saddle)
    {
      continue;
    }
    if (point.persistence > 0.36 * range)
    {
      const VertexRange link = mesh_.topology().link(static_cast<Index>(point.input));
      const double sign = point.type == CriticalType::Minimum ? 1.0 : -1.0;
      moved += std::any_of(link.begin(), link.end(),
        [&](Index neighbor) {
          return sign * smooth_[neighbor] < sign * smooth_[static_cast<Eigen::Index>(point.input)];
        });
      parameters_.mask[point.input] = 1;
      ++(point.type == CriticalType::Minimum ? expected.minima : expected.maxima);
    }
    else if (point.persistence < 0.01 * range)
    {
      ofNoise = static_cast<Index>(point.input);
    }
  }
  EXPECT_GT(moved, 2u);
  SmoothedFunction result = smooth();
  EXPECT_EQ(result.outputCounts.minima, expected.minima);
  EXPECT_EQ(result.outputCounts.maxima, expected.maxima);
  EXPECT_TRUE(result.lost.empty());

  parameters_.mask[ofNoise] = 1;
  EXPECT_EQ(smooth().lost, std::vector<Index>{ ofNoise });
}

// The larger delta, the fewer extrema of f choose one of the smooth function; for the whole range
// none does, and the lowest and the highest remain.
TEST_F(SmoothingWithConstraints, preserveDeltaSimplifiedExtremaOfTheInput)
{
  parameters_.method = SmoothingMethod::FeaturePreserving;
  parameters_.constraints = ConstraintChoice::DeltaSimplified;
  std::size_t last = std::numeric_limits<std::size_t>::max();
  for (const double delta : { 0.0, 0.05, 0.1, 1.0 })
  {
    parameters_.delta = delta;
    const SmoothedFunction result = smooth();
    const std::size_t count = result.outputCounts.minima + result.outputCounts.maxima;
    EXPECT_LE(count, last);
    last = count;
    EXPECT_TRUE(result.lost.empty());
  }
  EXPECT_EQ(last, 2u);
}

} // namespace
} // namespace SurfaceScalars::Truth
