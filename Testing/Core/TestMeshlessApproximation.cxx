#include "ApproximationTruth.h"
#include "Functions.h"
#include "MeshExamples.h"
#include "MeshlessApproximation.h"
#include "TetrahedralGrid.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <Eigen/QR>

#include <cmath>
#include <string>
#include <vector>

namespace SurfaceScalars
{
namespace
{

using namespace Truth;

double rangeOf(const Values& values)
{
  return values.maxCoeff() - values.minCoeff();
}

Values waves(const Points& points, double frequency)
{
  return valuesOf([=](const Vector3d& p)
    { return std::sin(frequency * p.x()) * std::cos(0.8 * frequency * p.y()) + 0.3 * p.z(); },
    points);
}

MeshlessApproximation approximated(const TriangleMesh& mesh, const Values& values,
  const ApproximationParameters& parameters, int threadCount = 0)
{
  const MeshTopology topology = topologyOf(mesh);
  return approximateMeshless(
    surfaceDomain(mesh.points, topology), values, parameters, { threadCount, {} });
}

ApproximationParameters withFraction(double fraction, double persistence = 0.01)
{
  ApproximationParameters parameters;
  parameters.sampleFraction = fraction;
  parameters.persistenceThreshold = persistence;
  return parameters;
}

TriangleMesh torus(int around)
{
  const Mesh mesh = torusMesh(around, true);
  TriangleMesh result{ mesh.vertices, {} };
  for (const auto corners : mesh.triangles.colwise())
  {
    result.triangles.push_back(
      { static_cast<int>(corners[0]), static_cast<int>(corners[1]), static_cast<int>(corners[2]) });
  }
  return result;
}

/// The places of the model at which f is given by stars.
double largestMissAtStars(
  const TriangleMesh& mesh, const Values& values, const MeshlessApproximation& result)
{
  const MeshTopology topology = topologyOf(mesh);
  double largest = 0.0;
  for (const CriticalPoint& point : result.persistent)
  {
    const auto vertex = static_cast<Index>(point.input);
    largest = std::max(largest, std::abs(result.values[vertex] - values[vertex]));
    for (const Index neighbor : topology.link(vertex))
    {
      largest = std::max(largest, std::abs(result.values[neighbor] - values[neighbor]));
    }
  }
  return largest;
}

/// How many of the points a walk around each vertex finds in the values, too.
std::size_t keptByWalking(const TriangleMesh& mesh, const MeshlessApproximation& result)
{
  const std::vector<CriticalPoint> found = Truth::meshCriticalPoints(mesh, result.values);
  std::size_t kept = 0;
  for (const CriticalPoint& asked : result.persistent)
  {
    kept += static_cast<std::size_t>(std::count_if(found.begin(), found.end(),
      [&](const CriticalPoint& point)
      {
        return point.input == asked.input && point.type == asked.type &&
          point.multiplicity == asked.multiplicity;
      }));
  }
  return kept;
}

// Stars are interpolated, so that each persistent critical point is one of u, at the same vertex
// and of the same type and multiplicity: on genus 0, 1 and 3, for few and many points and both ways
// to choose centers.
TEST(MeshlessApproximation, keepsPersistentCriticalPoints)
{
  std::size_t most = 0;
  for (const TriangleMesh& mesh :
    { octahedralSphere(16), torus(50), plateWithHoles(3, 3), gridMesh(Grid::Torus, 30, 20) })
  {
    for (const double frequency : { 0.5, 3.0 })
    {
      for (const CenterSelection selection :
        { CenterSelection::Greedy, CenterSelection::LevelSets })
      {
        const Values values = waves(mesh.points, frequency);
        ApproximationParameters parameters = withFraction(0.1);
        parameters.centerSelection = selection;
        const MeshlessApproximation result = approximated(mesh, values, parameters);
        // More than rounding where values are level and drawn apart
        EXPECT_LE(largestMissAtStars(mesh, values, result), 2e-7 * rangeOf(values));
        EXPECT_TRUE(result.lost.empty());
        EXPECT_EQ(keptByWalking(mesh, result), result.persistent.size());
        most = std::max(most, result.persistent.size());
      }
    }
  }
  EXPECT_GT(most, 50U);
}

// What is said of the result is so: values are those of the model, errors those of the values,
// prescribed points are the persistent ones that are kept.
TEST(MeshlessApproximation, saysWhatItIs)
{
  const TriangleMesh mesh = octahedralSphere(16);
  const Values values = waves(mesh.points, 4.0);
  const MeshlessApproximation result = approximated(mesh, values, withFraction(0.1));

  const Values again = Field(result.model).evaluate(mesh.points, {}).values;
  EXPECT_LE((again - result.values).lpNorm<Eigen::Infinity>(), 1e-11 * rangeOf(values));
  const Values misses = (result.values - values).cwiseAbs();
  EXPECT_EQ(result.largestError, misses.maxCoeff());
  EXPECT_EQ(result.meanError, misses.mean());
  EXPECT_EQ(result.model.centers.cols(), result.askedCount);
  EXPECT_EQ(result.askedCount, result.starCount + std::lround(0.1 * 1026));
  EXPECT_EQ(std::count(result.prescribed.begin(), result.prescribed.end(), 1),
    static_cast<std::ptrdiff_t>(result.persistent.size()));
  EXPECT_EQ(result.prescribed.size(), result.critical.points.size());
  EXPECT_EQ(bytesOf(result.model), 8U * (4U * static_cast<unsigned>(result.askedCount) + 7U));
  EXPECT_GT(result.condition, 1.0);
}

// Linear functions are what the polynomial is: a cover is enough, whatever is asked for.
TEST(MeshlessApproximation, reproducesLinearFunctions)
{
  const TriangleMesh mesh = octahedralSphere(16);
  const Values values = Vector3d(0.3, -0.5, 0.8).transpose() * mesh.points;
  const MeshlessApproximation result = approximated(mesh, values, withFraction(0.5));
  EXPECT_LE(result.largestError, 1e-13);
  EXPECT_LT(result.model.centers.cols(), result.askedCount / 2);
}

// With every vertex a center, u is f, also where nearly all are in stars.
TEST(MeshlessApproximation, interpolatesEverything)
{
  for (const int size : { 3, 8 })
  {
    const TriangleMesh mesh = octahedralSphere(size);
    Values values = waves(mesh.points, 4.0);
    addNoise(values, 0.1, 1); // symmetric ones are met at some vertices before these are centers
    const MeshlessApproximation result = approximated(mesh, values, withFraction(1.0));
    EXPECT_EQ(result.model.centers.cols(), mesh.points.cols());
    EXPECT_LE(result.largestError, 1e-12 * rangeOf(values));
  }
}

// In other units of f the error is the same fraction of its range.
TEST(MeshlessApproximation, doesNotDependOnTheUnitOfValues)
{
  const TriangleMesh mesh = octahedralSphere(12);
  const Values values = waves(mesh.points, 4.0);
  for (const LevelSetConstraints constraints : { LevelSetConstraints::Interpolating,
         LevelSetConstraints::LeastSquares, LevelSetConstraints::Minimax })
  {
    ApproximationParameters parameters = withFraction(0.1, 0.1);
    parameters.levelSetConstraints = constraints;
    const double error = approximated(mesh, values, parameters).largestError;
    for (const double unit : { 1e-250, 1e-160, 1e160, 1e250 })
    {
      const double other = approximated(mesh, unit * values, parameters).largestError;
      EXPECT_NEAR(other / unit, error, 0.01 * error) << unit;
    }
  }
}

// The more centers the smaller the error, which is below half of that of as many farthest points
// and below a quarter of that of the paper's centers.
TEST(MeshlessApproximation, approximatesBetterThanEvenCenters)
{
  const TriangleMesh mesh = torus(70);
  const Values values = waves(mesh.points, 4.0);
  double error = rangeOf(values);
  for (const double fraction : { 0.05, 0.1, 0.15 })
  {
    ApproximationParameters parameters = withFraction(fraction, 0.1);
    const MeshlessApproximation result = approximated(mesh, values, parameters);
    EXPECT_LT(result.largestError, 0.6 * error);
    error = result.largestError;
    if (result.model.centers.cols() >= 4 * result.starCount)
    {
      EXPECT_LE(error, 0.5 * farthestPointError(mesh.points, values, result.model.centers.cols()));
      parameters.centerSelection = CenterSelection::LevelSets;
      EXPECT_LE(error, 0.25 * approximated(mesh, values, parameters).largestError);
    }
  }
}

/// Values of sums of cubes and their polynomial at places, by values at centers: one column each.
Eigen::MatrixXd cardinalFunctions(const Points& centers, const Points& places)
{
  const Eigen::Index count = centers.cols();
  const auto systemAt = [&](const Points& rows)
  {
    Eigen::MatrixXd matrix(rows.cols(), count + 4);
    for (Eigen::Index j = 0; j < count; ++j)
    {
      matrix.col(j) =
        (rows.colwise() - centers.col(j)).colwise().norm().array().cube().matrix().transpose();
    }
    matrix.col(count).setOnes();
    matrix.rightCols(3) = rows.transpose();
    return matrix;
  };
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(count + 4, count + 4);
  system.topRows(count) = systemAt(centers);
  system.bottomRows(4) = system.rightCols(4).transpose().eval();
  system.bottomRightCorner(4, 4).setZero();
  const Eigen::MatrixXd inverse = Eigen::FullPivLU<Eigen::MatrixXd>(system).inverse();
  return systemAt(places) * inverse.leftCols(count);
}

// Least squares is what a dense solution of the same problem is: stars interpolated, the other
// values free, misses at the vertices and once more at the centers squared and summed (with so
// large a fraction, the places are all vertices). That is, u is the closest of all sums on its
// centers.
TEST(MeshlessApproximation, leastSquaresIsClosest)
{
  const TriangleMesh mesh = octahedralSphere(7);
  Values values = waves(mesh.points, 3.0);
  addNoise(values, 0.02, 1);
  ApproximationParameters parameters = withFraction(0.35, 0.2);
  parameters.levelSetConstraints = LevelSetConstraints::LeastSquares;
  const MeshlessApproximation result = approximated(mesh, values, parameters);
  const Points& centers = result.model.centers;
  const Eigen::Index free = centers.cols() - result.starCount;

  Points places(3, free + mesh.points.cols());
  places << centers.rightCols(free), mesh.points;
  const auto valueAt = [&](const Vector3d& place)
  {
    Eigen::Index vertex = 0;
    (mesh.points.colwise() - place).colwise().squaredNorm().minCoeff(&vertex);
    return values[vertex];
  };
  const Values asked = valuesOf(valueAt, places);
  const Eigen::MatrixXd cardinal = cardinalFunctions(centers, places);
  const Eigen::MatrixXd ofFree = cardinal.rightCols(free);
  const Values ofStars =
    cardinal.leftCols(result.starCount) * valuesOf(valueAt, centers.leftCols(result.starCount));
  const Values solution =
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd>(ofFree).solve(asked - ofStars);
  const Values expected = (ofStars + ofFree * solution).tail(mesh.points.cols());

  EXPECT_LE((result.values - expected).lpNorm<Eigen::Infinity>(), 1e-8 * rangeOf(values));
  EXPECT_LE(largestMissAtStars(mesh, values, result), 1e-9 * rangeOf(values));
}

// Under noise, least squares is closer to what the noise hides than interpolation, with no more
// critical points, for both ways to choose centers.
TEST(MeshlessApproximation, leastSquaresSmooths)
{
  const TriangleMesh mesh = torus(70);
  const Values clean = waves(mesh.points, 2.0);
  Values values = clean;
  addNoise(values, 0.01 * rangeOf(clean), 1);
  for (const CenterSelection selection : { CenterSelection::Greedy, CenterSelection::LevelSets })
  {
    ApproximationParameters parameters = withFraction(0.1, 0.2);
    parameters.centerSelection = selection;
    const MeshlessApproximation through = approximated(mesh, values, parameters);
    parameters.levelSetConstraints = LevelSetConstraints::LeastSquares;
    const MeshlessApproximation near = approximated(mesh, values, parameters);
    EXPECT_LT((near.values - clean).norm(), 0.8 * (through.values - clean).norm());
    EXPECT_LE(near.critical.points.size(), through.critical.points.size());
    EXPECT_TRUE(near.lost.empty());
  }
}

/// The largest weighted mean square that least squares leave is no more than the square of the
/// least largest error, whatever the weights: those of Lawson's algorithm come near.
double boundOfLargest(const Eigen::MatrixXd& matrix, const Values& right)
{
  Values weights = Values::Constant(right.size(), 1.0 / static_cast<double>(right.size()));
  double bound = 0.0;
  for (int step = 0; step < 100; ++step)
  {
    const Values roots = weights.cwiseSqrt();
    const Values solution = Eigen::ColPivHouseholderQR<Eigen::MatrixXd>(roots.asDiagonal() * matrix)
                              .solve(roots.cwiseProduct(right));
    const Values errors = (matrix * solution - right).cwiseAbs();
    bound = std::max(bound, std::sqrt(weights.dot(errors.cwiseAbs2())));
    weights = weights.cwiseProduct(errors);
    weights /= weights.sum();
  }
  return bound;
}

// Minimax is nearly the least largest error that sums on these centers can have if they interpolate
// the stars, and below that of interpolation: with all vertices looked at, and with some.
TEST(MeshlessApproximation, minimaxIsNearlyLeast)
{
  for (const int size : { 7, 16 })
  {
    const TriangleMesh mesh = octahedralSphere(size);
    const Values values = waves(mesh.points, 3.0);
    ApproximationParameters parameters = withFraction(size == 7 ? 0.3 : 0.04, 0.2);
    const MeshlessApproximation through = approximated(mesh, values, parameters);
    parameters.levelSetConstraints = LevelSetConstraints::Minimax;
    const MeshlessApproximation result = approximated(mesh, values, parameters);

    const Eigen::MatrixXd cardinal = cardinalFunctions(result.model.centers, mesh.points);
    const Values ofStars = cardinal.leftCols(result.starCount) *
      Field(through.model).evaluate(result.model.centers.leftCols(result.starCount), {}).values;
    const Eigen::Index free = result.model.centers.cols() - result.starCount;
    const double bound = boundOfLargest(cardinal.rightCols(free), values - ofStars);
    EXPECT_GE(result.largestError, 0.999 * bound);
    EXPECT_LE(result.largestError, 1.15 * bound);
    EXPECT_LE(result.largestError, 0.9 * through.largestError);
    EXPECT_LE(largestMissAtStars(mesh, values, result), 1e-9 * rangeOf(values));
    EXPECT_TRUE(result.lost.empty());
  }
}

// The values of least squares are among those that minimax chooses from, so that it has no larger
// error but for its few percent: where regularization misses what is asked for, too.
TEST(MeshlessApproximation, minimaxIsNotFartherThanLeastSquares)
{
  const TriangleMesh mesh = octahedralSphere(20);
  const Values values = waves(mesh.points, 4.0);
  for (const double regularization : { 0.0, 1.0, 1000.0, 1e10 })
  {
    ApproximationParameters parameters = withFraction(0.05);
    parameters.regularization = regularization;
    parameters.levelSetConstraints = LevelSetConstraints::LeastSquares;
    const double near = approximated(mesh, values, parameters).largestError;
    parameters.levelSetConstraints = LevelSetConstraints::Minimax;
    EXPECT_LE(approximated(mesh, values, parameters).largestError, 1.1 * near) << regularization;
  }
}

// Every kernel, its width chosen, is well conditioned and interpolates the stars.
TEST(MeshlessApproximation, isWellConditionedWithEveryKernel)
{
  const TriangleMesh mesh = octahedralSphere(16);
  const Values values = waves(mesh.points, 4.0);
  for (const KernelType kernel : { KernelType::Gaussian, KernelType::Exponential,
         KernelType::Linear, KernelType::Cubic, KernelType::ThinPlate, KernelType::Multiquadric,
         KernelType::InverseMultiquadric, KernelType::Wendland, KernelType::Wu })
  {
    ApproximationParameters parameters = withFraction(0.1);
    parameters.kernel = kernel;
    const MeshlessApproximation result = approximated(mesh, values, parameters);
    EXPECT_LT(result.condition, 1e12) << nameOf(kernel);
    EXPECT_LE(largestMissAtStars(mesh, values, result), 1e-9 * rangeOf(values)) << nameOf(kernel);
    EXPECT_LT(result.largestError, 0.2 * rangeOf(values)) << nameOf(kernel);
    EXPECT_TRUE(result.lost.empty()) << nameOf(kernel);
  }
}

// The same to the bit with any number of threads.
TEST(MeshlessApproximation, doesNotDependOnThreads)
{
  const TriangleMesh mesh = torus(60);
  Values values = waves(mesh.points, 3.0);
  addNoise(values, 0.01, 1);
  for (const LevelSetConstraints constraints :
    { LevelSetConstraints::LeastSquares, LevelSetConstraints::Minimax })
  {
    ApproximationParameters parameters = withFraction(0.2, 0.2);
    parameters.centerSelection = constraints == LevelSetConstraints::Minimax
      ? CenterSelection::Greedy
      : CenterSelection::LevelSets;
    parameters.levelSetConstraints = constraints;
    const MeshlessApproximation one = approximated(mesh, values, parameters, 1);
    const MeshlessApproximation three = approximated(mesh, values, parameters, 3);
    EXPECT_EQ(one.values, three.values);
    EXPECT_EQ(one.model.centers, three.model.centers);
    EXPECT_EQ(one.model.coefficients, three.model.coefficients);
  }
}

// In a unit that is a million times larger or smaller, far from the origin, nothing changes but by
// rounding.
TEST(MeshlessApproximation, doesNotDependOnUnits)
{
  const TriangleMesh mesh = torus(40);
  const Values values = waves(mesh.points, 3.0);
  const MeshlessApproximation result = approximated(mesh, values, withFraction(0.1));
  for (const double unit : { 1e-6, 1e6 })
  {
    TriangleMesh scaled = mesh;
    scaled.points = (unit * mesh.points).colwise() + unit * Vector3d(3.0, 5.0, -4.0);
    const MeshlessApproximation other =
      approximated(scaled, unit * values.array() + unit, withFraction(0.1));
    EXPECT_NEAR(other.largestError, unit * result.largestError, 0.05 * other.largestError);
    EXPECT_TRUE(other.lost.empty());
  }
}

// Tetrahedra are approximated as triangles are, with what is critical there, here one vertex
// inside.
TEST(MeshlessApproximation, takesVolumes)
{
  const SimplicialMesh grid = tetrahedralGrid(10);
  const Values values = waves(grid.vertices, 4.0);
  const Index inside = 5 * 11 * 11 + 5 * 11 + 5;
  const auto onePoint = [&](const ValuesRef& of, const Execution&)
  {
    CriticalPoint point;
    point.position = grid.vertices.col(inside);
    point.input = inside;
    point.value = of[inside];
    point.persistence = rangeOf(of);
    return MeshCriticalPoints{ { point }, {} };
  };
  const ApproximationDomain domain{ grid.vertices, grid.simplices, onePoint, [](Index vertex) {
                                     return std::vector<Index>{ vertex - 1, vertex + 1 };
                                   } };
  for (const CenterSelection selection : { CenterSelection::Greedy, CenterSelection::LevelSets })
  {
    ApproximationParameters parameters = withFraction(0.2);
    parameters.centerSelection = selection;
    const MeshlessApproximation result = approximateMeshless(domain, values, parameters);
    EXPECT_EQ(result.starCount, 3);
    EXPECT_EQ(result.model.centers.cols(), 3 + 266);
    EXPECT_NEAR(result.values[inside], values[inside], 1e-11);
    EXPECT_LT(result.largestError, 0.05 * rangeOf(values));
  }
}

// Of whole numbers most stars have ties, which the order of the vertices breaks: the model itself
// has these critical points, evaluated by itself.
TEST(MeshlessApproximation, modelKeepsCriticalPointsWhereValuesAreLevel)
{
  const TriangleMesh mesh = octahedralSphere(20);
  const Values values = (6.0 * waves(mesh.points, 6.0)).array().round();
  ApproximationParameters parameters = withFraction(0.1);
  parameters.persistenceThreshold = 0.1;
  const MeshlessApproximation result = approximated(mesh, values, parameters);
  EXPECT_TRUE(result.lost.empty());
  const Values again = Field(result.model).evaluate(mesh.points, {}).values;
  const VertexTypes types = classifyVertices(topologyOf(mesh), again);
  ASSERT_GE(result.persistent.size(), 4U);
  for (const CriticalPoint& point : result.persistent)
  {
    EXPECT_EQ(types.types[point.input], point.type);
    EXPECT_EQ(static_cast<int>(types.multiplicities[point.input]), point.multiplicity);
  }
}

} // namespace
} // namespace SurfaceScalars
