#include "Field.h"

#include "Error.h"
#include "FieldChecks.h"
#include "FieldChoices.h"
#include "FieldSchemes.h"
#include "GlobalSystem.h"
#include "MortonOrder.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace SurfaceScalars
{
namespace
{

constexpr std::size_t Grain = 256; // targets per block of a parallel loop
constexpr auto PollInterval = std::chrono::milliseconds(20);

/// Distinct samples in the order of their cloud, which is that of a cloud made of them alone: a
/// field made of its own model is the same.
class Samples
{
public:
  Samples(const PointsRef& points, const Execution& execution)
  {
    this->add(points, execution);
    // Points that are equal but for rounding have become one, and the cloud of what is left may
    // have another origin.
    while (this->cloud().pointCount() < this->cloud().inputCount())
    {
      this->add(Points(this->centers_), execution);
    }
  }

  const PointCloud& cloud() const { return this->clouds_.back(); }
  const Points& centers() const { return this->centers_; } ///< in the caller's coordinates
  std::size_t inputCount() const { return this->clouds_.front().inputCount(); }

  /// One value for each center, the mean over its duplicates.
  Values average(const ValuesRef& values) const
  {
    Values result = values;
    for (const PointCloud& cloud : this->clouds_)
    {
      result = cloud.average(result);
    }
    return result;
  }

  /// How many centers have a duplicate whose value is not `average`, the mean.
  std::size_t contradictions(const ValuesRef& values, const Values& average) const
  {
    std::vector<char> contradicting(this->cloud().pointCount(), 0);
    for (std::size_t input = 0; input < this->inputCount(); ++input)
    {
      const Index center = this->centerOf(input);
      if (values[static_cast<Eigen::Index>(input)] != average[center])
      {
        contradicting[center] = 1;
      }
    }
    return static_cast<std::size_t>(std::count(contradicting.begin(), contradicting.end(), 1));
  }

private:
  Index centerOf(std::size_t input) const
  {
    for (const PointCloud& cloud : this->clouds_)
    {
      input = cloud.pointOfInput(input);
    }
    return static_cast<Index>(input);
  }

  void add(const PointsRef& points, const Execution& execution)
  {
    this->clouds_.emplace_back(points, execution);
    this->centers_.resize(3, this->cloud().pointCount());
    for (Index i = 0; i < this->cloud().pointCount(); ++i)
    {
      this->centers_.col(i) = points.col(static_cast<Eigen::Index>(this->cloud().inputOfPoint(i)));
    }
  }

  std::vector<PointCloud> clouds_; // each made of the centers of the one before
  Points centers_;
};

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

} // namespace

struct Field::Implementation
{
  FieldParameters asked;
  std::shared_ptr<const Samples> samples;
  FieldModel model;
  std::vector<char> marked;                   ///< of the Hybrid scheme
  std::shared_ptr<const GlobalSystem> system; ///< of the GlobalRBF scheme, once it has been needed
  Values centerValues;                        ///< f at the centers, with the system
  std::size_t contradictions = 0;

  Implementation(const FieldParameters& parameters, std::shared_ptr<const Samples> distinct)
    : asked(parameters)
    , samples(std::move(distinct))
  {
  }

  void fit(const ValuesRef& inputValues, const Execution& execution);
  void solve(const Values& values, const Execution& execution);
  void prepare(const Execution& execution);
  FieldSamples fieldSamples() const { return { this->samples->cloud(), this->model.coefficients }; }
  std::unique_ptr<FieldApproximation> approximation() const;
  std::unique_ptr<FieldApproximation> globalApproximation() const;
};

/// Fills the model. @param inputValues one per input point
void Field::Implementation::fit(const ValuesRef& inputValues, const Execution& execution)
{
  const Values values = this->samples->average(inputValues);
  this->contradictions = this->samples->contradictions(inputValues, values);
  const FieldSamples known{ this->samples->cloud(), values };
  checkFieldSamples(known.cloud, this->asked);
  this->model.parameters = completed(this->asked, known, execution.part(0.0, 0.5));
  this->model.centers = this->samples->centers();
  this->model.coefficients = values;
  this->model.lowest = values.minCoeff();
  this->model.highest = values.maxCoeff();
  if (this->asked.scheme == Scheme::GlobalRBF)
  {
    this->solve(values, execution.part(0.5, 1.0));
  }
  this->prepare(execution.part(0.5, 1.0));
  execution.report(1.0);
}

/// The coefficients of the GlobalRBF scheme.
void Field::Implementation::solve(const Values& values, const Execution& execution)
{
  const PointCloud& cloud = this->samples->cloud();
  if (!this->system)
  {
    this->system = std::make_shared<const GlobalSystem>(
      FieldSamples{ cloud, values }, this->asked, execution.part(0.0, 0.8));
  }
  GlobalSum sum = this->system->solve(values, execution.part(0.8, 1.0));
  this->centerValues = values;
  this->model.parameters.kernelWidth = sum.kernel.width();
  this->model.coefficients = std::move(sum.coefficients);
  this->model.tail = sum.tail;
  this->model.tailOrigin = cloud.origin();
}

/// What evaluation needs beside the model, made of the model alone.
void Field::Implementation::prepare(const Execution& execution)
{
  if (this->model.parameters.scheme == Scheme::Hybrid)
  {
    this->marked = markMissedSamples(this->fieldSamples(), this->model.parameters, execution);
  }
}

std::unique_ptr<FieldApproximation> Field::Implementation::approximation() const
{
  const FieldParameters& parameters = this->model.parameters;
  switch (parameters.scheme)
  {
    case Scheme::ExplicitMLS:
      return makeExplicitMLS(this->fieldSamples(), parameters);
    case Scheme::ParameterizedMLS:
      return makeParameterizedMLS(this->fieldSamples(), parameters);
    case Scheme::Hybrid:
      return makeHybrid(this->fieldSamples(), parameters, this->marked);
    case Scheme::GlobalRBF:
      return this->globalApproximation();
    default:
      return makeLocalRBF(this->fieldSamples(), parameters);
  }
}

std::unique_ptr<FieldApproximation> Field::Implementation::globalApproximation() const
{
  const Vector3d shift = this->samples->cloud().origin() - this->model.tailOrigin;
  Eigen::Vector4d tail = this->model.tail;
  tail[0] += tail.tail<3>().dot(shift);
  return makeGlobalRBF(this->fieldSamples(),
    RadialKernel(this->model.parameters.kernel, this->model.parameters.kernelWidth), tail);
}

Field::Field(std::unique_ptr<Implementation> implementation)
  : implementation_(std::move(implementation))
{
}

Field::~Field() = default;
Field::Field(Field&&) noexcept = default;
Field& Field::operator=(Field&&) noexcept = default;

Field Field::fit(const PointsRef& points, const ValuesRef& values,
  const FieldParameters& parameters, const Execution& execution)
{
  checkFieldParameters(parameters);
  checkFieldValues(values, static_cast<std::size_t>(points.cols()));
  auto implementation = std::make_unique<Implementation>(
    parameters, std::make_shared<const Samples>(points, execution.part(0.0, 0.5)));
  implementation->fit(values, execution.part(0.5, 1.0));
  return Field(std::move(implementation));
}

Field::Field(FieldModel model, const Execution& execution)
{
  checkFieldModel(model);
  const auto samples = std::make_shared<const Samples>(model.centers, execution.part(0.0, 0.5));
  if (samples->centers().cols() != model.centers.cols())
  {
    throw InvalidInput("a model of distinct centers",
      std::to_string(model.centers.cols() - samples->centers().cols()) + " duplicates",
      "Make the model anew.");
  }
  this->implementation_ = std::make_unique<Implementation>(model.parameters, samples);
  // In the order of the cloud, in which they are already if the model is a field's.
  model.coefficients = samples->average(model.coefficients);
  model.centers = samples->centers();
  this->implementation_->model = std::move(model);
  this->implementation_->prepare(execution.part(0.5, 1.0));
}

Field Field::withValues(const ValuesRef& values, const Execution& execution) const
{
  const Implementation& self = *this->implementation_;
  checkFieldValues(values, self.samples->inputCount());
  auto implementation = std::make_unique<Implementation>(self.asked, self.samples);
  const bool widthFollowsValues =
    !(self.asked.kernelWidth > 0.0) && RadialKernel(self.asked.kernel, 1.0).dependsOnWidth();
  if (!widthFollowsValues)
  {
    implementation->system = self.system;
  }
  implementation->fit(values, execution);
  return Field(std::move(implementation));
}

const FieldModel& Field::model() const
{
  return this->implementation_->model;
}

const PointCloud& Field::cloud() const
{
  return this->implementation_->samples->cloud();
}

std::size_t Field::contradictionCount() const
{
  return this->implementation_->contradictions;
}

Values Field::leaveOneOutErrors() const
{
  if (!this->implementation_->system)
  {
    throw InvalidInput("the GlobalRBF scheme for leave-one-out errors", "another scheme or a model",
      "Choose the GlobalRBF Scheme.");
  }
  return this->implementation_->system->leaveOneOutErrors(this->implementation_->centerValues);
}

std::unique_ptr<FieldApproximation> Field::approximation() const
{
  return this->implementation_->approximation();
}

namespace
{

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
