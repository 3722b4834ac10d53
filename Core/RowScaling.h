#pragma once

#include "Basics.h"

#include <Eigen/SparseCore>

namespace SurfaceScalars
{

/// diag(divisors)^-1 matrix. Eigen's product of a diagonal and a sparse matrix takes minutes for a
/// million rows.
inline Eigen::SparseMatrix<double> divideRows(
  Eigen::SparseMatrix<double> matrix, const Values& divisors)
{
  const Eigen::Map<const Eigen::VectorXi> rows(matrix.innerIndexPtr(), matrix.nonZeros());
  Eigen::Map<Values>(matrix.valuePtr(), matrix.nonZeros()).array() /= divisors(rows).array();
  return matrix;
}

} // namespace SurfaceScalars
