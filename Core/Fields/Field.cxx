#include "Field.h"

#include "DistinctSamples.h"
#include "Error.h"
#include "FieldChecks.h"
#include "FieldChoices.h"
#include "FieldSchemes.h"
#include "GlobalSystem.h"

#include <string>
#include <utility>

namespace SurfaceScalars
{

struct Field::Implementation
{
  FieldParameters asked;
  std::shared_ptr<const DistinctSamples> samples;
  FieldModel model;
  std::vector<char> marked;                   ///< of the Hybrid scheme
  std::shared_ptr<const GlobalSystem> system; ///< of the GlobalRBF scheme, once it has been needed
  Values centerValues;                        ///< f at the centers, with the system
  std::size_t contradictions = 0;

  Implementation(const FieldParameters& parameters, std::shared_ptr<const DistinctSamples> distinct)
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
    parameters, std::make_shared<const DistinctSamples>(points, execution.part(0.0, 0.5)));
  implementation->fit(values, execution.part(0.5, 1.0));
  return Field(std::move(implementation));
}

Field::Field(FieldModel model, const Execution& execution)
{
  checkFieldModel(model);
  const auto samples =
    std::make_shared<const DistinctSamples>(model.centers, execution.part(0.0, 0.5));
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

Values Field::leaveOneOutErrors(const Execution& execution) const
{
  if (!this->implementation_->system)
  {
    throw InvalidInput("the GlobalRBF scheme for leave-one-out errors", "another scheme or a model",
      "Choose the GlobalRBF Scheme.");
  }
  return this->implementation_->system->leaveOneOutErrors(
    this->implementation_->centerValues, execution);
}

std::unique_ptr<FieldApproximation> Field::approximation() const
{
  return this->implementation_->approximation();
}

} // namespace SurfaceScalars
