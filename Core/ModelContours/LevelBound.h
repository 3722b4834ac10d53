#pragma once

#include "Ball.h"
#include "LevelFunction.h"

namespace SurfaceScalars
{

/// What is known of u - level in a ball, or on the part of a plane in it.
struct BallVerdict
{
  bool isClear = false;       ///< no zero
  bool isSteep = false;       ///< no critical point
  bool isFlat = false;        ///< nothing but rounding: no zero can be told
  bool mayBeCritical = false; ///< not steep, and a critical point's value may be the level's
};

/// What a Taylor polynomial does not show of u in a ball, at most.
struct UnseenTerms
{
  double value = 0.0;
  double slope = 0.0; ///< of the gradient
};

/**
 * Tells from u's Taylor polynomial at the center of a ball of radius rho whether u - alpha has
 * zeros in it: none if |u(c) - alpha| > |grad u| rho + s |Hess u| rho^2 / 2, and no critical point
 * if |grad u| > s |Hess u| rho, with s = 2 for what the Hessian changes.
 *
 * That holds where u is smooth: in balls of a few centers at most; of larger ones nothing is known.
 * Where the kernel has a tip at its center, or is narrower than the ball, the centers nearby count
 * with all that their terms vary, and so do terms whose support ends in the ball.
 */
class LevelBound
{
public:
  static constexpr double Safety = 2.0; ///< s

  /// @param function must outlive this
  explicit LevelBound(const LevelFunction& function);

  /// How close to the level a saddle's value makes it critical, in u's unit.
  double criticalMargin() const { return this->margin_; }
  /// What u's values may be off by.
  double rounding() const { return this->rounding_; }

  /// Whether u jumps a little where its neighborhoods change, as of local schemes.
  bool isJumping() const { return this->isJumping_; }
  /// Whether the ball holds no more than a few centers and, at a plateau, one function (see
  /// PlateauLevel).
  bool isSmall(const Ball& ball) const;
  /// Whether a plateau at the level is known to have no border in the ball; false without one.
  bool isClear(const Ball& ball) const;
  UnseenTerms unseen(const Ball& ball) const;
  /// @param value of u - level at the center @param slope |grad u| there @param curvature |Hess u|
  BallVerdict judge(const Ball& ball, double value, double slope, double curvature) const;

private:
  const Field& field_;
  const PlateauLevel* plateau_; ///< null if there is none
  RadialKernel kernel_;
  bool isJumping_;
  double support_;      ///< of terms
  double smoothRadius_; ///< of balls that need no look at single terms
  double margin_;
  double rounding_;
};

} // namespace SurfaceScalars
