#pragma once

#include "FieldApproximation.h"

#include <cstddef>
#include <vector>

namespace SurfaceScalars
{

/// All that f~ consists of, in plain numbers: what is saved to disk. Nothing is automatic any more:
/// the parameters are those that were used. Only a width of 0 remains for local schemes: it follows
/// each neighborhood.
struct FieldModel
{
  FieldParameters parameters;
  Points centers;      ///< distinct, in the caller's coordinates
  Values coefficients; ///< GlobalRBF: alpha of (9); else f at the centers
  Eigen::Vector4d tail = Eigen::Vector4d::Zero(); ///< GlobalRBF: beta of (9), about tailOrigin
  Vector3d tailOrigin = Vector3d::Zero();         ///< in the caller's coordinates
  double lowest = 0.0;                            ///< f's range, for clamping
  double highest = 0.0;
};

struct EvaluationParameters
{
  Derivatives derivatives = Derivatives::None;
  double maximumDistance = 0.0; ///< length; 0 = unlimited: targets farther from every sample are
                                ///< not valid
  double nullValue = 0.0;       ///< in place of all numbers of targets that are not valid
  bool clampToRange = false;    ///< values stay within f's range; derivatives are f~'s own
};

/// f~ at targets, in their order. Not valid are also targets that are nowhere (NaN or infinite), or
/// where f~ is not defined or not finite.
struct FieldValues
{
  Values values;
  Points gradients; ///< empty unless asked for
  Eigen::Matrix<double, 6, Eigen::Dynamic>
    hessians;              ///< xx, yy, zz, xy, yz, xz; empty unless asked for
  std::vector<char> valid; ///< 1 or 0
};

/**
 * f~: a function known at samples, extended to all of space (point-set paper, sec. 3).
 *
 * Local schemes are smooth where the neighborhood does not change and jump a little where it does.
 * Interpolating: LocalRBF and GlobalRBF without regularization. Linear functions are reproduced by
 * these two, polynomials over a plane by ParameterizedMLS, constants by all.
 */
class SURFACESCALARSCORE_EXPORT Field
{
public:
  /**
   * @param points 3 x n, finite, length units; duplicates count once, with the mean of their values
   * @param values one per point, finite
   * @throws InvalidInput for unusable parameters, too few points, or a system that is singular at
   * machine precision; Aborted
   */
  static Field fit(const PointsRef& points, const ValuesRef& values,
    const FieldParameters& parameters, const Execution& execution = {});

  /// From a model: evaluates to the same bits as the field it was taken from. @throws InvalidInput
  /// if the model is not consistent
  explicit Field(FieldModel model, const Execution& execution = {});
  ~Field();
  Field(Field&&) noexcept;
  Field& operator=(Field&&) noexcept;

  /// The same points and parameters with other values, exactly as fit() makes it, but what depends
  /// on points only is kept (design paper, sec. 6.3).
  Field withValues(const ValuesRef& values, const Execution& execution = {}) const;

  const FieldModel& model() const;
  const PointCloud& cloud() const; ///< of the distinct samples
  /// Places whose samples have different values: f~ takes their mean.
  std::size_t contradictionCount() const;
  /// f at each center less what all other centers predict there, without solving again (Rippa
  /// 1999).
  /// @throws InvalidInput unless the scheme is GlobalRBF with a dense system, fitted here
  Values leaveOneOutErrors(const Execution& execution = {}) const;

  /// One for each thread; valid as long as the field.
  std::unique_ptr<FieldApproximation> approximation() const;

  FieldValues evaluate(const PointsRef& targets, const EvaluationParameters& parameters,
    const Execution& execution = {}) const;

private:
  struct Implementation;
  explicit Field(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
};

} // namespace SurfaceScalars
