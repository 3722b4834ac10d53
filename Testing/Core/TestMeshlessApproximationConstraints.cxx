#include "MeshlessApproximationTest.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace SurfaceScalars
{
namespace
{

using namespace Truth;

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

} // namespace
} // namespace SurfaceScalars
