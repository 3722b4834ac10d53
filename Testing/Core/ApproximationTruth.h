#pragma once

#include "Field.h"

#include <vector>

/// Other ways to approximate a function by few centers, for comparison.
namespace SurfaceScalars::Truth
{

/// Points each of which is the farthest from those before, the first first.
inline std::vector<Index> farthestPoints(const Points& points, Eigen::Index count)
{
  const Eigen::Matrix<double, Eigen::Dynamic, 3> rows = points.transpose();
  Eigen::ArrayXd distances = Eigen::ArrayXd::Constant(points.cols(), INFINITY);
  std::vector<Index> chosen;
  Eigen::Index next = 0;
  for (Eigen::Index i = 0; i < count; ++i)
  {
    chosen.push_back(static_cast<Index>(next));
    distances =
      distances.min((rows.rowwise() - rows.row(next)).rowwise().squaredNorm().array()).eval();
    distances.maxCoeff(&next);
  }
  return chosen;
}

/// By how much the sum of cubes through farthest points misses values: as many centers, no choice.
inline double farthestPointError(const Points& points, const Values& values, Eigen::Index count)
{
  Points centers(3, count);
  Values centerValues(count);
  Eigen::Index column = 0;
  for (const Index vertex : farthestPoints(points, count))
  {
    centers.col(column) = points.col(vertex);
    centerValues[column++] = values[vertex];
  }
  FieldParameters parameters;
  parameters.scheme = Scheme::GlobalRBF;
  const Field field = Field::fit(centers, centerValues, parameters);
  return (field.evaluate(points, {}).values - values).lpNorm<Eigen::Infinity>();
}

} // namespace SurfaceScalars::Truth
