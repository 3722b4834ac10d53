#pragma once

#include "RadialKernel.h"
#include "Sampling.h"

#include <Eigen/LU>
#include <Eigen/SVD>

#include <cmath>
#include <functional>
#include <vector>

/// Radial functions once more, in the plainest way: what the fast ones are held against.
namespace SurfaceScalars::Truth
{

inline std::vector<KernelType> allKernels()
{
  std::vector<KernelType> result;
  for (int type = 0; type <= static_cast<int>(KernelType::Harmonic); ++type)
  {
    result.push_back(static_cast<KernelType>(type));
  }
  return result;
}

/// Those that are finite at their centers.
inline std::vector<KernelType> interpolatingKernels()
{
  std::vector<KernelType> result = allKernels();
  result.pop_back();
  return result;
}

/// In the cube [-1, 1]^3.
inline Points randomBox(int count, unsigned seed)
{
  Random random(seed);
  return Points::NullaryExpr(
    3, count, [&](Eigen::Index, Eigen::Index) { return random.uniform(-1.0, 1.0); });
}

inline Values valuesOf(const std::function<double(const Vector3d&)>& function, const Points& points)
{
  return Values::NullaryExpr(
    points.cols(), [&](Eigen::Index i) { return function(points.col(i)); });
}

inline double wave(const Vector3d& p)
{
  return std::sin(2.0 * p.x() + p.y()) + p.z() * p.x() + 0.5 * p.y();
}

inline Eigen::MatrixXd kernelMatrix(const Points& centers, const RadialKernel& kernel)
{
  return Eigen::MatrixXd::NullaryExpr(centers.cols(), centers.cols(),
    [&](Eigen::Index i, Eigen::Index j)
    { return kernel.value((centers.col(i) - centers.col(j)).norm()); });
}

/// 1, x, y, z at each point.
inline Eigen::MatrixXd linearTerms(const Points& points)
{
  Eigen::MatrixXd terms(points.cols(), 4);
  terms << Values::Ones(points.cols()), points.transpose();
  return terms;
}

/// An orthonormal basis of the vectors orthogonal to the columns.
inline Eigen::MatrixXd orthogonalTo(const Eigen::MatrixXd& columns)
{
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(columns, Eigen::ComputeFullU);
  return svd.matrixU().rightCols(columns.rows() - svd.rank());
}

/// (9) by solving (10) as it stands; centers must not lie in a plane.
inline std::function<double(const Vector3d&)> solveBordered(
  const Points& centers, const RadialKernel& kernel, double regularization, const Values& values)
{
  const Eigen::Index count = centers.cols();
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(count + 4, count + 4);
  matrix.topLeftCorner(count, count) = kernelMatrix(centers, kernel);
  matrix.topLeftCorner(count, count).diagonal().array() += kernel.sign() * regularization;
  matrix.topRightCorner(count, 4) = linearTerms(centers);
  matrix.bottomLeftCorner(4, count) = linearTerms(centers).transpose();
  Values right = Values::Zero(count + 4);
  right.head(count) = values;
  const Values solution = matrix.fullPivLu().solve(right);
  return [=](const Vector3d& place)
  {
    double sum = solution[count] + solution.tail<3>().dot(place);
    for (Eigen::Index i = 0; i < count; ++i)
    {
      sum += solution[i] * kernel.value((place - centers.col(i)).norm());
    }
    return sum;
  };
}

} // namespace SurfaceScalars::Truth
