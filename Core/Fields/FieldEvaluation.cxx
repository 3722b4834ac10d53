#include "Error.h"
#include "Field.h"
#include "FieldChecks.h"
#include "MortonOrder.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <string>

namespace SurfaceScalars
{
namespace
{

constexpr std::size_t Grain = 256; // targets per block of a parallel loop
constexpr auto PollInterval = std::chrono::milliseconds(20);

/// The targets that can be evaluated, relative to the origin of the cloud, in Morton order.
struct Places
{
  Points points;
  std::vector<Index> targets;
};

Places placesOf(const PointsRef& targets, const Vector3d& origin, const Execution& execution)
{
  Points usable(3, targets.cols());
  std::vector<Index> inputs;
  for (Eigen::Index i = 0; i < targets.cols(); ++i)
  {
    const Vector3d place = targets.col(i) - origin;
    if (std::isfinite(place.squaredNorm())) // NaN, infinite, or too far to have a distance
    {
      usable.col(static_cast<Eigen::Index>(inputs.size())) = place;
      inputs.push_back(static_cast<Index>(i));
    }
  }
  const auto count = static_cast<Eigen::Index>(inputs.size());
  Places result{ Points(3, count), std::vector<Index>(inputs.size()) };
  if (count == 0)
  {
    return result;
  }
  const std::vector<Index> order = mortonOrder(usable.leftCols(count), execution);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    const Index from = order[static_cast<std::size_t>(i)];
    result.points.col(i) = usable.col(from);
    result.targets[static_cast<std::size_t>(i)] = inputs[from];
  }
  return result;
}

FieldValues allNull(Eigen::Index count, const EvaluationParameters& parameters)
{
  FieldValues result;
  result.values.setConstant(count, parameters.nullValue);
  if (parameters.derivatives >= Derivatives::Gradient)
  {
    result.gradients.setConstant(3, count, parameters.nullValue);
  }
  if (parameters.derivatives == Derivatives::Hessian)
  {
    result.hessians.setConstant(6, count, parameters.nullValue);
  }
  result.valid.assign(static_cast<std::size_t>(count), 0);
  return result;
}

bool isFinite(const FieldJet& jet, Derivatives derivatives)
{
  return std::isfinite(jet.value) &&
    (derivatives < Derivatives::Gradient || jet.gradient.allFinite()) &&
    (derivatives < Derivatives::Hessian || jet.hessian.allFinite());
}

/// Evaluates one place after the other.
class Evaluator
{
public:
  Evaluator(const Field& field, const PointCloud& cloud, const EvaluationParameters& parameters)
    : parameters_(parameters)
    , approximation_(field.approximation())
    , cloud_(cloud)
    , lowest_(field.model().lowest)
    , highest_(field.model().highest)
  {
  }

  Eigen::Index expect(const PointsRef& places) { return this->approximation_->expect(places); }
  void evaluate(const Vector3d& place, Index target, FieldValues& result);

private:
  const EvaluationParameters& parameters_;
  std::unique_ptr<FieldApproximation> approximation_;
  const PointCloud& cloud_;
  Neighborhood nearest_;
  double lowest_;
  double highest_;
};

void Evaluator::evaluate(const Vector3d& place, Index target, FieldValues& result)
{
  if (this->parameters_.maximumDistance > 0.0)
  {
    this->cloud_.nearest(place, 1, this->nearest_);
    if (std::sqrt(this->nearest_.squaredDistances.front()) > this->parameters_.maximumDistance)
    {
      return;
    }
  }
  if (!this->approximation_->center(place))
  {
    return;
  }
  const Derivatives derivatives = this->parameters_.derivatives;
  const FieldJet jet = this->approximation_->jet(place, derivatives);
  if (!isFinite(jet, derivatives))
  {
    return;
  }
  result.valid[target] = 1;
  result.values[target] = this->parameters_.clampToRange
    ? std::clamp(jet.value, this->lowest_, this->highest_)
    : jet.value;
  if (derivatives >= Derivatives::Gradient)
  {
    result.gradients.col(target) = jet.gradient;
  }
  if (derivatives == Derivatives::Hessian)
  {
    const Eigen::Matrix3d& h = jet.hessian;
    result.hessians.col(target) << h(0, 0), h(1, 1), h(2, 2), h(0, 1), h(1, 2), h(0, 2);
  }
}

} // namespace

FieldValues Field::evaluate(const PointsRef& targets, const EvaluationParameters& parameters,
  const Execution& execution) const
{
  checkEvaluation(parameters);
  if (targets.cols() > std::numeric_limits<int>::max())
  {
    throw InvalidInput(
      "at most 2147483647 targets", std::to_string(targets.cols()), "Evaluate them in parts.");
  }
  const PointCloud& cloud = this->cloud();
  const Places places = placesOf(targets, cloud.origin(), execution.part(0.0, 0.1));
  FieldValues result = allNull(targets.cols(), parameters);
  parallelForEach((places.targets.size() + Grain - 1) / Grain, execution.part(0.1, 1.0),
    [&](std::size_t block, const Poll& poll)
    {
      Evaluator evaluator(*this, cloud, parameters);
      auto lastPoll = std::chrono::steady_clock::now();
      const std::size_t end = std::min(places.targets.size(), (block + 1) * Grain);
      std::size_t expected = block * Grain;
      for (std::size_t i = expected; i < end; ++i)
      {
        if (i == expected)
        {
          expected += static_cast<std::size_t>(evaluator.expect(places.points.middleCols(
            static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(end - i))));
        }
        evaluator.evaluate(
          places.points.col(static_cast<Eigen::Index>(i)), places.targets[i], result);
        const auto now = std::chrono::steady_clock::now();
        if (now - lastPoll > PollInterval)
        {
          poll();
          lastPoll = now;
        }
      }
    });
  return result;
}

} // namespace SurfaceScalars
