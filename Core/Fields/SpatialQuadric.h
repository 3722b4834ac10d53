#pragma once

#include "Basics.h"
#include "SurfaceScalarsCoreExport.h"

namespace SurfaceScalars
{

constexpr int QuadricTerms = 10;
using QuadricVector = Eigen::Matrix<double, QuadricTerms, 1>;
using QuadricMatrix = Eigen::Matrix<double, QuadricTerms, QuadricTerms>;

/// 1, the coordinates and their products.
SURFACESCALARSCORE_EXPORT QuadricVector quadricTerms(const Vector3d& place);

/// The least-squares polynomial of degree 2 in space through values on a surface.
struct SpatialQuadric
{
  QuadricVector coefficients;
  QuadricMatrix inverse; ///< of the normal matrix; where that has none, of what it determines
  double variance = 0.0; ///< of the residuals, at least that of rounding

  /// The variance of the difference between two places, given that of their terms.
  double ofDifference(const QuadricVector& terms) const
  {
    return this->variance * terms.dot(this->inverse * terms);
  }
};

/// What a least-squares quadric needs to know of the values at some places.
class SURFACESCALARSCORE_EXPORT QuadricMoments
{
public:
  void add(const Vector3d& place, double value);

  Index count() const { return this->count_; }

  /// On planes, cylinders and spheres several quadrics are the same function; one of these.
  /// @returns variance 0 where there are not more values than terms
  SpatialQuadric solve() const;

  /// The sum over the places of the products of terms, each less its mean.
  QuadricMatrix spread() const;

private:
  Index count_ = 0;
  QuadricMatrix normal_ = QuadricMatrix::Zero(); ///< its lower half
  QuadricVector right_ = QuadricVector::Zero();
  double squares_ = 0.0;
};

/**
 * Whether two quadrics differ, but for a constant, by no more than noise explains. One is fitted to
 * some of the values of the other: if both are right, the covariance of the difference of their
 * coefficients is the difference of their covariances (Hausman, 1978). Compared is the sum of the
 * squares over some places with what is expected and six standard deviations: noise alone exceeds
 * that once in a thousand times, or less often.
 *
 * @param spread of these places
 */
SURFACESCALARSCORE_EXPORT bool areAlike(
  const SpatialQuadric& ofSome, const SpatialQuadric& ofAll, const QuadricMatrix& spread);

} // namespace SurfaceScalars
