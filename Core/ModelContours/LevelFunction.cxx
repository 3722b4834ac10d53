#include "LevelFunction.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace SurfaceScalars
{
namespace
{

constexpr std::size_t Grain = 64; // places per block: many, as one may take a millisecond

/// Takes height (1 - t^2)^3, t = distance / radius < 1, off a jet.
void subtract(FieldJet& jet, const Dent& dent, const Vector3d& place, Derivatives derivatives)
{
  const Vector3d offset = (place - dent.center) / dent.radius;
  const double rest = 1.0 - offset.squaredNorm();
  if (!(rest > 0.0))
  {
    return;
  }
  jet.value -= dent.height * rest * rest * rest;
  if (derivatives >= Derivatives::Gradient)
  {
    jet.gradient += dent.height * 6.0 * rest * rest / dent.radius * offset;
  }
  if (derivatives == Derivatives::Hessian)
  {
    const double scale = dent.height * 6.0 * rest / (dent.radius * dent.radius);
    jet.hessian -= 4.0 * scale * offset * offset.transpose();
    jet.hessian.diagonal().array() += scale * rest;
  }
}

} // namespace

FieldJet LevelProbe::operator()(const Vector3d& place, Derivatives derivatives)
{
  ++this->count_;
  if (!this->field_->center(place))
  {
    const double nowhere = std::numeric_limits<double>::quiet_NaN();
    return { nowhere, Vector3d::Constant(nowhere), Eigen::Matrix3d::Constant(nowhere) };
  }
  FieldJet jet = this->field_->jet(place, derivatives);
  jet.value -= this->level_;
  for (const Dent& dent : this->dents_)
  {
    subtract(jet, dent, place, derivatives);
  }
  return jet;
}

void LevelFunction::forEach(std::size_t count, const Execution& execution,
  const std::function<void(std::size_t index, LevelProbe& probe)>& body)
{
  std::vector<std::size_t> counts((count + Grain - 1) / Grain);
  parallelForEach(counts.size(), execution,
    [&](std::size_t block, const Poll& poll)
    {
      LevelProbe probe(
        this->plateau_ ? this->plateau_->approximation() : this->field_.approximation(),
        this->level_, this->dents_);
      const std::size_t end = std::min(count, (block + 1) * Grain);
      for (std::size_t i = block * Grain; i < end; ++i)
      {
        poll();
        body(i, probe);
      }
      counts[block] = probe.evaluationCount();
    });
  this->count_ += std::accumulate(counts.begin(), counts.end(), std::size_t{ 0 });
}

} // namespace SurfaceScalars
