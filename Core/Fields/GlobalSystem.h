#pragma once

#include "CompactSystem.h"
#include "FieldApproximation.h"
#include "RadialBasisFit.h"

#include <memory>
#include <mutex>
#include <string>

namespace SurfaceScalars
{

/// A dense system of this many takes seconds and half a gigabyte; time grows with the cube.
constexpr Index MostDenseCenters = 6000;

/// f~ of the GlobalRBF scheme: all of (9) but the centers.
struct GlobalSum
{
  RadialKernel kernel;
  Values coefficients;  ///< alpha, one per point of the cloud
  Eigen::Vector4d tail; ///< beta, about the origin of the cloud
};

/**
 * The system (10) of all points of a cloud, made once for any number of functions on them (design
 * paper, sec. 6.3): dense and factored, or sparse and solved iteratively where the kernel's support
 * leaves most of it empty.
 */
class SURFACESCALARSCORE_EXPORT GlobalSystem
{
public:
  /// @param samples the cloud must outlive the system; the values serve to choose the width if that
  /// is 0
  /// @throws InvalidInput if there are too many points for the kernel, or the system is singular at
  /// machine precision; Aborted
  GlobalSystem(
    const FieldSamples& samples, const FieldParameters& parameters, const Execution& execution);

  const RadialKernel& kernel() const { return this->kernel_; } ///< with the width that is used

  /// Without regularization the sum interpolates to 1e-10 of f's range, save where values jump
  /// between centers that nearly coincide. @throws InvalidInput where it misses them by more than
  /// 1e-5; Aborted
  GlobalSum solve(const Values& values, const Execution& execution) const;

  /// As Field::leaveOneOutErrors().
  Values leaveOneOutErrors(const Values& values, const Execution& execution = {}) const;

private:
  bool isSparse(const Execution& execution) const;
  void checkResidual(const GlobalSum& sum, const Values& values, const Execution& execution) const;
  [[noreturn]] void refuse(const std::string& found) const;

  const PointCloud& cloud_;
  RadialKernel kernel_;
  double regularization_;
  std::unique_ptr<RadialBasisFit> dense_; ///< either this
  std::unique_ptr<CompactSystem> sparse_; ///< or this
  mutable std::mutex mutex_;              ///< of dense_, which keeps its last solution
};

/// Evaluates such a sum. @param terms the centers, and alpha in place of values
SURFACESCALARSCORE_EXPORT std::unique_ptr<FieldApproximation> makeGlobalRBF(
  const FieldSamples& terms, const RadialKernel& kernel, const Eigen::Vector4d& tail);

} // namespace SurfaceScalars
