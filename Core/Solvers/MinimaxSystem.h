#pragma once

#include "Basics.h"
#include "BlockCholesky.h"
#include "Execution.h"
#include "SurfaceScalarsCoreExport.h"

#include <vector>

namespace SurfaceScalars
{

/**
 * An overdetermined system B x = b that gets more and more equations, and its Chebyshev solution:
 * the x with which the largest |(B x - b)_i| is least, but for a few percent.
 *
 * By the alternating direction method of multipliers (Boyd et al. 2011): least squares again and
 * again, each time towards errors the largest of which are cut off. It goes on where it was when
 * equations are added.
 *
 * Time O(m n^2), memory O(m n) for m equations and n unknowns.
 */
class SURFACESCALARSCORE_EXPORT MinimaxSystem
{
public:
  /// More equations. What they do not determine remains small.
  /// @param transposed their rows of B, one per column @param right of them @throws Aborted
  void add(Eigen::MatrixXd transposed, const Values& right, const Execution& execution = {});

  /// The best unknowns that some more steps came by; least squares is the first. @throws Aborted
  Values solve(const Execution& execution = {});

private:
  void addToNormalMatrix(const Eigen::MatrixXd& transposed, const Execution& execution);
  Values errorsOf(const Values& unknowns, const Execution& execution) const;
  Values closestTo(const Values& wanted, const Execution& execution) const;

  std::vector<Eigen::MatrixXd> transposed_; ///< B^T, as it came
  Values right_;
  Eigen::MatrixXd normal_; ///< B^T B, its lower triangle
  BlockCholesky factors_;
  Values best_;   ///< unknowns
  Values errors_; ///< of the last step
  Values cut_;    ///< these without their peaks
  Values multipliers_;
};

} // namespace SurfaceScalars
