#pragma once

#include "Basics.h"

#include <Eigen/SparseCore>

namespace SurfaceScalars
{

/// diag(factors) matrix, which is compressed. Eigen's product of a diagonal and a sparse matrix
/// takes minutes for a million rows.
inline Eigen::SparseMatrix<double> scaleRows(
  Eigen::SparseMatrix<double> matrix, const Values& factors)
{
  const Eigen::Map<const Eigen::VectorXi> rows(matrix.innerIndexPtr(), matrix.nonZeros());
  Eigen::Map<Values>(matrix.valuePtr(), matrix.nonZeros()).array() *= factors(rows).array();
  return matrix;
}

} // namespace SurfaceScalars
