#pragma once

#include "Execution.h"
#include "SurfaceScalarsCoreExport.h"

#include <Eigen/Cholesky>

namespace SurfaceScalars
{

/// Eigen's Cholesky factorization, made on several threads and with an ear for an abort where the
/// matrix is large.
class SURFACESCALARSCORE_EXPORT BlockCholesky : public Eigen::LLT<Eigen::MatrixXd>
{
public:
  /// Of the lower triangle. @throws Aborted
  void compute(const Eigen::Ref<const Eigen::MatrixXd>& matrix, const Execution& execution);

private:
  bool factorPanel(Eigen::Index begin, const Execution& execution);
};

} // namespace SurfaceScalars
