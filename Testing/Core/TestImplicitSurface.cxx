#include "Error.h"
#include "ImplicitSurface.h"
#include "NormalOrientation.h"
#include "Queries.h"
#include "Sampling.h"
#include "Torus.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <optional>

namespace SurfaceScalars
{
namespace
{

/// Samples of a closed surface with their oriented normals, and the exact distance from it.
struct Sampled
{
  NeighborGraph graph;
  Points normals;
  std::function<double(const Vector3d&)> exactDistance;
  FitSize size{ 28, 0.0 };

  Sampled(const Points& points, std::function<double(const Vector3d&)> distance, int count = 28)
    : graph(points, NeighborQuery())
    , exactDistance(std::move(distance))
    , size{ count, 0.0 }
  {
    this->normals = estimateNormals(this->graph, this->size);
    orientNormals(this->graph, this->normals);
  }
  OrientedSamples samples() const { return { this->graph, this->normals }; }
  double step() const { return this->graph.medianSamplingStep(); }
  /// Of a place relative to the center of the samples.
  double distance(const Vector3d& place) const
  {
    return this->exactDistance(place + this->graph.origin());
  }
};

Sampled sphere(int count = 5000)
{
  return { Truth::randomSphere(count, 1), [](const Vector3d& p) { return p.norm() - 1.0; } };
}

Sampled torus(int pointCount = 5000, double noise = 0.0, int count = 28)
{
  Points points = Truth::randomTorus(pointCount, Truth::Torus::Closed, 1);
  Truth::addNoise(points, noise * Truth::torusDiagonal(), 2);
  return { points, Truth::torusDistance, count };
}

/// Every n-th sample, moved a little off the surface.
std::vector<Vector3d> placesNear(const Sampled& sampled, Index stride = 50)
{
  Truth::Random random(7);
  std::vector<Vector3d> places;
  for (Index i = 0; i < sampled.graph.pointCount(); i += stride)
  {
    const Vector3d offset(random.normal(), random.normal(), random.normal());
    places.emplace_back(sampled.graph.points().col(i) + 0.3 * sampled.step() * offset);
  }
  return places;
}

/// The zero of g reached from a place along its gradient, without taking new samples.
std::optional<Vector3d> project(const FieldApproximation& surface, Vector3d place, double tolerance)
{
  for (int i = 0; i < 10; ++i)
  {
    const FieldJet g = surface.jet(place, Derivatives::Gradient);
    const Vector3d step = -g.value / g.gradient.squaredNorm() * g.gradient;
    place += step;
    if (step.norm() <= tolerance)
    {
      return place;
    }
  }
  return {};
}

/// Largest distance, in steps, of the zero of g from the surface; it is reached from everywhere.
double largestError(const Sampled& sampled, FieldApproximation& surface)
{
  double largest = 0.0;
  for (const Vector3d& place : placesNear(sampled))
  {
    EXPECT_TRUE(surface.center(place));
    const auto zero = project(surface, place, 1e-9 * sampled.step());
    EXPECT_TRUE(zero.has_value());
    largest = std::max(largest, std::abs(sampled.distance(zero.value_or(place))));
  }
  return largest / sampled.step();
}

/// All of them, as a function of the samples.
struct Kind
{
  const char* name;
  std::function<std::unique_ptr<FieldApproximation>(const Sampled&)> make;
  bool isRadial;
};

std::vector<Kind> kinds()
{
  std::vector<Kind> result{
    { "(1)", [](const Sampled& s) { return makeExtremalSurface(s.samples(), 1.7 * s.step()); },
      false },
    { "(2)", [](const Sampled& s) { return makeAverageSurface(s.samples(), 1.7 * s.step()); },
      false },
  };
  for (const auto fit : { RadialSurfaceFit::Interpolate, RadialSurfaceFit::LeastSquares })
  {
    for (const auto kernel :
      { KernelType::Gaussian, KernelType::Cubic, KernelType::ThinPlate, KernelType::Multiquadric,
        KernelType::InverseMultiquadric, KernelType::Wendland, KernelType::Wu })
    {
      const RadialSurfaceParameters parameters{ fit, kernel, 0.0 };
      result.push_back({ fit == RadialSurfaceFit::Interpolate ? "interpolating" : "least squares",
        [=](const Sampled& s) { return makeRadialSurface(s.samples(), s.size, parameters); },
        true });
    }
  }
  return result;
}

// The gradient of each g is that of central differences, the samples being kept; so is the Hessian
// of the radial ones.
TEST(ImplicitSurface, hasItsExactGradient)
{
  const Sampled sampled = torus(2000);
  const double h = 1e-4 * sampled.step();
  for (const Kind& kind : kinds())
  {
    SCOPED_TRACE(kind.name);
    const auto surface = kind.make(sampled);
    for (const Vector3d& place : placesNear(sampled, 200))
    {
      ASSERT_TRUE(surface->center(place));
      const FieldJet g = surface->jet(place, Derivatives::Hessian);
      Vector3d gradient;
      Eigen::Matrix3d hessian;
      for (int axis = 0; axis < 3; ++axis)
      {
        const Vector3d aside = h * Vector3d::Unit(axis);
        const FieldJet after = surface->jet(place + aside, Derivatives::Gradient);
        const FieldJet before = surface->jet(place - aside, Derivatives::Gradient);
        gradient[axis] = (after.value - before.value) / (2.0 * h);
        hessian.col(axis) = (after.gradient - before.gradient) / (2.0 * h);
      }
      EXPECT_LT((g.gradient - gradient).norm(), 1e-6);
      EXPECT_TRUE(!kind.isRadial || (g.hessian - hessian).norm() < 1e-5 * (1.0 + hessian.norm()));
    }
  }
}

// Each g is positive outside and negative inside, once the normals are oriented.
TEST(ImplicitSurface, isPositiveOutside)
{
  const Sampled sampled = torus();
  for (const Kind& kind : kinds())
  {
    SCOPED_TRACE(kind.name);
    const auto surface = kind.make(sampled);
    for (Index i = 0; i < sampled.graph.pointCount(); i += 100)
    {
      const Vector3d normal = Truth::torusNormal(
        Truth::torusAngles(sampled.graph.points().col(i) + sampled.graph.origin()));
      for (const double side : { 1.0, -1.0 })
      {
        const Vector3d place = sampled.graph.points().col(i) + 0.7 * side * sampled.step() * normal;
        ASSERT_TRUE(surface->center(place));
        EXPECT_GT(side * surface->jet(place, Derivatives::None).value, 0.0);
      }
    }
  }
}

// The zeros of the radial surfaces lie within a small fraction of the sampling step of the surface
// sampled, closer as the samples become denser; those of the averages do not.
TEST(ImplicitSurface, hasItsZerosOnTheSurface)
{
  const auto error = [](const Sampled& sampled, RadialSurfaceFit fit)
  {
    const auto surface = makeRadialSurface(sampled.samples(), sampled.size, { fit });
    return largestError(sampled, *surface);
  };
  const Sampled round = sphere();
  EXPECT_LT(error(round, RadialSurfaceFit::Interpolate), 0.005);
  EXPECT_LT(error(round, RadialSurfaceFit::LeastSquares), 0.05);
  const Sampled coarse = torus(5000);
  const Sampled fine = torus(20000);
  EXPECT_LT(error(coarse, RadialSurfaceFit::Interpolate), 0.02);
  EXPECT_LT(error(coarse, RadialSurfaceFit::LeastSquares), 0.1);
  EXPECT_LT(
    error(fine, RadialSurfaceFit::Interpolate), 0.5 * error(coarse, RadialSurfaceFit::Interpolate));
  EXPECT_GT(largestError(fine, *makeAverageSurface(fine.samples(), 1.7 * fine.step())), 0.02);
}

// The interpolating surface passes through the samples, and is delta at delta along their normals.
TEST(ImplicitSurface, interpolatesSamplesAndOffsets)
{
  const Sampled sampled = sphere(2000);
  const auto surface = makeRadialSurface(sampled.samples(), sampled.size, {});
  for (Index i = 0; i < sampled.graph.pointCount(); i += 100)
  {
    const Vector3d place = sampled.graph.points().col(i);
    ASSERT_TRUE(surface->center(place));
    EXPECT_NEAR(surface->jet(place, Derivatives::None).value, 0.0, 1e-10);
    Neighborhood near;
    sampled.graph.nearest(place, sampled.size.count, near);
    const double delta = std::sqrt(near.squaredDistances.back()) / 3.0;
    const Vector3d outside = place + delta * sampled.normals.col(i);
    EXPECT_NEAR(surface->jet(outside, Derivatives::None).value, delta, 1e-10);
  }
}

// With noise of 1% of the diagonal the least-squares surface is closer to the true one than the
// interpolating one, at the same number of samples.
TEST(ImplicitSurface, smoothsNoiseByLeastSquares)
{
  const Sampled sampled = torus(20000, 0.01, 150);
  const auto meanError = [&](RadialSurfaceFit fit)
  {
    const auto surface = makeRadialSurface(sampled.samples(), sampled.size, { fit });
    double sum = 0.0;
    const std::vector<Vector3d> places = placesNear(sampled, 400);
    for (const Vector3d& place : places)
    {
      EXPECT_TRUE(surface->center(place));
      const auto zero = project(*surface, place, 1e-6 * sampled.step());
      // Ripples of an interpolated g have no zero to arrive at: as wrong as the start.
      sum += std::abs(sampled.distance(zero.value_or(place)));
    }
    return sum / static_cast<double>(places.size());
  };
  EXPECT_LT(
    meanError(RadialSurfaceFit::LeastSquares), 0.8 * meanError(RadialSurfaceFit::Interpolate));
}

// Two sheets closer together than two offsets elsewhere: those between them are shortened, and each
// sheet keeps its zeros and its sign.
TEST(ImplicitSurface, keepsCloseSheetsApart)
{
  constexpr double Gap = 0.08; // the offsets elsewhere are 0.05 long, more than half of it
  const Points bottom = Truth::randomPlane(1000, 1);
  Points points(3, 2000);
  points << bottom, Truth::randomPlane(1000, 2).colwise() + Vector3d(0.0, 0.0, Gap);
  const PointCloud cloud(points);
  Points normals = Points::Zero(3, cloud.pointCount());
  for (Index i = 0; i < cloud.pointCount(); ++i)
  {
    normals(2, i) = cloud.points()(2, i) > 0.0 ? 1.0 : -1.0; // a plate
  }
  const auto surface = makeRadialSurface({ cloud, normals }, { 40, 0.0 }, {});
  for (const Vector2d& place : { Vector2d(0.0, 0.0), Vector2d(0.3, -0.4), Vector2d(-0.5, 0.2) })
  {
    const Vector3d middle(place.x(), place.y(), 0.0);
    ASSERT_TRUE(surface->center(middle));
    const auto at = [&](double z)
    { return surface->jet(middle + Vector3d(0.0, 0.0, z), Derivatives::None).value; };
    EXPECT_LT(at(0.0), 0.0);
    for (const double side : { 1.0, -1.0 })
    {
      EXPECT_LT(at(0.35 * side * Gap), 0.0);
      EXPECT_GT(at(0.65 * side * Gap), 0.0);
    }
  }
}

// A plane, on which the samples spread in two directions only, is reproduced exactly.
TEST(ImplicitSurface, reproducesPlanes)
{
  const Sampled sampled(Truth::randomPlane(500, 1), [](const Vector3d& p) { return p.z(); });
  for (const auto fit : { RadialSurfaceFit::Interpolate, RadialSurfaceFit::LeastSquares })
  {
    const auto surface = makeRadialSurface(sampled.samples(), sampled.size, { fit });
    ASSERT_TRUE(surface->center(Vector3d(0.1, 0.2, 0.02)));
    const FieldJet g = surface->jet(Vector3d(0.1, 0.2, 0.02), Derivatives::Gradient);
    EXPECT_NEAR(g.value, 0.02, 1e-9);
    EXPECT_LT((g.gradient - Vector3d::UnitZ()).norm(), 1e-7);
  }
}

// Where nothing determines g there is none: samples on a line have no normals, and far from all
// samples the averages have no weights.
TEST(ImplicitSurface, isRefusedWithoutASurface)
{
  Points line = Points::Zero(3, 50);
  line.row(0).setLinSpaced(0.0, 1.0);
  const Sampled sampled(line, [](const Vector3d&) { return 0.0; });
  for (const Kind& kind : kinds())
  {
    EXPECT_FALSE(kind.make(sampled)->center(Vector3d::Zero())) << kind.name;
  }
  EXPECT_FALSE(makeAverageSurface(torus(500).samples(), 0.1)->center(Vector3d(9.0, 0.0, 0.0)));
}

// A kernel as wide as a hundred neighborhoods makes the system singular: an error, not noise.
TEST(ImplicitSurface, refusesSingularSystems)
{
  const Sampled sampled = sphere(500);
  const auto surface = makeRadialSurface(
    sampled.samples(), sampled.size, { RadialSurfaceFit::Interpolate, KernelType::Gaussian, 50.0 });
  EXPECT_THROW(surface->center(sampled.graph.points().col(0)), InvalidInput);
}

// Samples that almost coincide do not make the system singular.
TEST(ImplicitSurface, withstandsNearDuplicates)
{
  const Points points = Truth::randomSphere(500, 1);
  Points doubled(3, 1000);
  doubled << points, points.array() + 1e-13;
  const Sampled sampled(doubled, [](const Vector3d& p) { return p.norm() - 1.0; });
  const auto surface = makeRadialSurface(sampled.samples(), { 56, 0.0 }, {});
  EXPECT_LT(largestError(sampled, *surface), 0.05);
}

} // namespace
} // namespace SurfaceScalars
