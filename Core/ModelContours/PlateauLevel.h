#pragma once

#include "Ball.h"
#include "Field.h"
#include "PointTree.h"

#include <memory>

namespace SurfaceScalars
{

/**
 * u - level where u has a plateau at the level: its terms end, and its polynomial is the level.
 *
 * A plateau belongs to the upper side, so that its border with smaller values is part of the level
 * set: the rims of the supports of negative terms. There u - level vanishes with three derivatives,
 * which no Taylor polynomial and no Newton method gets hold of. Where no positive term reaches, the
 * distance from the nearest of these rims, times a constant, is taken in its place, which has the
 * same sign and simple zeros.
 */
class PlateauLevel
{
public:
  /// @param vertices relative to the origin of the field's cloud @returns null if terms do not end,
  /// or the polynomial is not the level, to rounding, at each of them
  static std::unique_ptr<PlateauLevel> find(
    const Field& field, const Points& vertices, double level);

  /// Whether some term is negative; if not, only isClear() may be called: it always is.
  bool hasRims() const { return this->negative_.cols() > 0; }

  /// The sum of the terms alone, about the same origin: u - level without its rounding errors.
  const Field& terms() const { return this->terms_; }
  /// What has the sign of u - level. Not for several threads at once.
  std::unique_ptr<FieldApproximation> approximation() const;

  /// Whether u - level has one sign in a ball, whatever the terms cancel: by the least and the
  /// largest value of each.
  bool isClear(const Ball& ball) const;
  /// Whether approximation() is the sum of the terms everywhere in a ball.
  bool isSum(const Ball& ball) const;
  /// Whether it is the distance from one rim at most.
  bool isRim(const Ball& ball) const;

private:
  friend class RimApproximation;
  explicit PlateauLevel(Field terms);
  bool isFree(const PointTree& centers, const Ball& ball, std::size_t most) const;

  Field terms_;
  RadialKernel kernel_;
  double scale_;    ///< of the distances
  Points positive_; ///< centers
  Points negative_;
  PointTree positiveTree_;
  PointTree negativeTree_;
};

} // namespace SurfaceScalars
