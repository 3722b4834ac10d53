#pragma once

#include "Field.h"
#include "RadialBasisFit.h"

namespace SurfaceScalars
{

/// Where a sum of radial functions has its centers, and the values there.
struct CenterSet
{
  Points places; ///< distinct
  Values values;
  Eigen::Index starCount = 0; ///< the first so many are of stars
};

/// A function at some places.
struct PlacedValues
{
  Points places;
  Values values;
};

struct ChosenCenters
{
  CenterSet centers;
  PlacedValues further; ///< for least squares: three for each center that is not of a star
};

/**
 * A sum of radial functions and a linear polynomial through values at centers that become more and
 * more, or near values at more places than it has centers.
 *
 * An automatic width is chosen for the first centers (chooseKernelWidth()), shrinks as their
 * spacing does, and by a fifth as often as the system is singular at machine precision.
 */
class CenterSum
{
public:
  /// @param parameters of the GlobalRBF scheme, checked
  /// @param dimension of the domain: 2 or 3 @param lowest, highest of f
  CenterSum(const FieldParameters& parameters, int dimension, double lowest, double highest);

  /// @throws InvalidInput with the condition of a system that is singular at machine precision, or
  /// without regularization misses its values; Aborted
  void interpolate(const CenterSet& centers, const Execution& execution);

  /// The values at stars are interpolated; those at the other centers are such that the squared
  /// misses there and at these places have the least sum.
  /// @throws as interpolate(); InvalidInput if conjugate gradients do not get there
  void approximate(
    const CenterSet& centers, const PlacedValues& further, const Execution& execution);

  /// Other values at the same centers. After interpolate(). @throws Aborted
  void takeValues(const Values& values, const Execution& execution);

  /// How much the sum at each of these places, one column each, changes with the value at each of
  /// the last so many centers, one row each. After interpolate(). @throws Aborted
  Eigen::MatrixXd dependences(
    const Points& places, Eigen::Index free, const Execution& execution) const;

  /// By how much the sum through all other centers misses the value at each. After interpolate().
  Values leaveOneOutErrors(const CenterSet& centers, const Execution& execution);

  Values at(const PointsRef& places, const Execution& execution) const;
  double condition() const { return 1.0 / this->fit_.reciprocalCondition(); }
  FieldModel model() const;

private:
  RadialKernel kernel() const { return { this->parameters_.kernel, this->width_ }; }
  double middle() const { return 0.5 * this->lowest_ + 0.5 * this->highest_; }
  [[noreturn]] void refuseLeastSquares() const;
  bool isReducible() const;   ///< the width
  double largestMiss() const; ///< that counts as interpolation
  double firstWidth(const CenterSet& centers, const Execution& execution) const;
  bool tryWidth(const CenterSet& centers, const Execution& execution);
  void solve(const Values& values, const Execution& execution);
  Values sumsAt(const PointsRef& places, const Execution& execution) const;

  FieldParameters parameters_;
  int dimension_;
  double lowest_;
  double highest_;
  double width_ = 0.0; ///< for as many centers beside the stars as
  double count_ = 0.0;
  RadialBasisFit fit_;
  Values coefficients_; ///< of a sum through values less the middle of the range
  Eigen::Vector4d tail_ = Eigen::Vector4d::Zero();
};

} // namespace SurfaceScalars
