#pragma once

#include "Field.h"
#include "PlateauLevel.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace SurfaceScalars
{

/// What is taken off u close to a saddle, so that its value is the level: height at the center, 0
/// from the radius on, twice continuously differentiable.
struct Dent
{
  Vector3d center;
  double radius;
  double height;
};

/// u - level at places relative to the origin of the field's cloud. Not for several threads at
/// once.
class LevelProbe
{
public:
  LevelProbe(
    std::unique_ptr<FieldApproximation> field, double level, const std::vector<Dent>& dents)
    : field_(std::move(field))
    , level_(level)
    , dents_(dents)
  {
  }

  /// The value is NaN where u is not defined.
  FieldJet operator()(const Vector3d& place, Derivatives derivatives);
  std::size_t evaluationCount() const { return this->count_; }

private:
  std::unique_ptr<FieldApproximation> field_;
  double level_;
  const std::vector<Dent>& dents_;
  std::size_t count_ = 0;
};

/// u - level for one level of a field, or what has its sign (see PlateauLevel); the field, or the
/// plateau, must outlive it. Counts how often it is evaluated.
class LevelFunction
{
public:
  LevelFunction(const Field& field, double level)
    : field_(field)
    , level_(level)
  {
  }
  explicit LevelFunction(const PlateauLevel& plateau)
    : field_(plateau.terms())
    , level_(0.0)
    , plateau_(&plateau)
  {
  }

  const Field& field() const { return this->field_; }
  const PlateauLevel* plateau() const { return this->plateau_; } ///< null if there is none
  double level() const { return this->level_; }
  std::size_t evaluationCount() const { return this->count_; }
  /// From now on.
  void add(const Dent& dent) { this->dents_.push_back(dent); }

  /// Calls body once for each index below count, from several threads. @throws Aborted
  void forEach(std::size_t count, const Execution& execution,
    const std::function<void(std::size_t index, LevelProbe& probe)>& body);

private:
  const Field& field_;
  double level_;
  const PlateauLevel* plateau_ = nullptr;
  std::vector<Dent> dents_;
  std::size_t count_ = 0;
};

} // namespace SurfaceScalars
