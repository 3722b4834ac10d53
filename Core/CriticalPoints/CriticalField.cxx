#include "CriticalField.h"

#include "FieldChoices.h"
#include "FieldSchemes.h"

#include <utility>
#include <vector>

namespace SurfaceScalars
{
namespace
{

constexpr double DifferenceStep = 1e-3; // in sampling steps

/// A given function, scaled as f is. Its Hessian is that of central differences of its gradient,
/// whose error slows Newton's method down but does not move where it leads.
class ScaledFunction : public FieldApproximation
{
public:
  ScaledFunction(
    VolumeFunction function, const Vector3d& origin, const ValueScaling& scaling, double step)
    : function_(std::move(function))
    , origin_(origin)
    , scaling_(scaling)
    , step_(step)
  {
  }

  bool center(const Vector3d&) override { return true; }
  FieldJet jet(const Vector3d& place, Derivatives derivatives) const override
  {
    FieldJet result;
    result.value = this->evaluate(place, result.gradient);
    for (int i = 0; i < 3 && derivatives == Derivatives::Hessian; ++i)
    {
      const Vector3d shift = this->step_ * Vector3d::Unit(i);
      Vector3d before, after;
      this->evaluate(place - shift, before);
      this->evaluate(place + shift, after);
      result.hessian.col(i) = (after - before) / (2.0 * this->step_);
    }
    return result;
  }

private:
  double evaluate(const Vector3d& place, Vector3d& gradient) const
  {
    const double value = this->function_(place + this->origin_, &gradient);
    gradient *= 0.5 / this->scaling_.halfRange;
    return this->scaling_(value);
  }

  VolumeFunction function_;
  Vector3d origin_;
  ValueScaling scaling_;
  double step_;
};

FieldParameters fieldParameters(const CriticalPointParameters& parameters)
{
  FieldParameters result;
  result.scheme = parameters.scheme;
  result.kernel = parameters.kernel;
  result.kernelWidth = parameters.kernelWidth;
  result.neighborCount = parameters.neighborCount;
  result.searchRadius = parameters.searchRadius;
  return result;
}

} // namespace

CriticalField makeCriticalField(const NeighborGraph& graph, const Values& values,
  const ValueScaling& scaling, const CriticalPointParameters& parameters,
  const Execution& execution)
{
  if (parameters.probabilityModel == ProbabilityModel::NormalAngle)
  {
    const double step = DifferenceStep * graph.medianSamplingStep();
    return { [=, origin = graph.origin(), function = parameters.volumeFunction]()
      { return std::make_unique<ScaledFunction>(function, origin, scaling, step); },
      true };
  }
  if (parameters.scheme == Scheme::ParameterizedMLS)
  {
    return {};
  }
  const FieldSamples samples{ graph, values };
  const FieldParameters field = completed(fieldParameters(parameters), samples, execution);
  if (field.scheme == Scheme::ExplicitMLS)
  {
    return { [=]() { return makeExplicitMLS(samples, field); }, false };
  }
  if (field.scheme == Scheme::LocalRBF)
  {
    return { [=]() { return makeLocalRBF(samples, field); }, true };
  }
  const auto missed =
    std::make_shared<std::vector<char>>(markMissedSamples(samples, field, execution));
  return { [=]() { return makeHybrid(samples, field, *missed); }, false };
}

} // namespace SurfaceScalars
