#include "FieldMemory.h"

#include "EqualNumbers.h"

#include <tuple>
#include <utility>

namespace SurfaceScalars
{
namespace
{

auto tied(const FieldParameters& p)
{
  return std::tie(p.scheme, p.kernel, p.kernelWidth, p.neighborCount, p.searchRadius,
    p.polynomialDegree, p.regularization, p.hybridThreshold);
}

} // namespace

bool FieldMemory::hasPoints(const Points& points, const FieldParameters& parameters) const
{
  return this->field_ && tied(this->parameters_) == tied(parameters) &&
    equal(this->samples_.points, points);
}

const Field& FieldMemory::fieldOf(
  Samples&& samples, const FieldParameters& parameters, const Execution& execution)
{
  if (!this->hasPoints(samples.points, parameters))
  {
    this->field_.reset(); // makes room: there may not be enough memory for two
    this->field_ = Field::fit(samples.points, samples.values, parameters, execution);
  }
  else if (!equal(this->samples_.values, samples.values))
  {
    this->field_ = this->field_->withValues(samples.values, execution);
  }
  this->samples_ = std::move(samples);
  this->parameters_ = parameters;
  return *this->field_;
}

} // namespace SurfaceScalars
