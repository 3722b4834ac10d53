#include "LevelSets.h"

#include "ContourChecks.h"
#include "CurveOrientation.h"
#include "CurveShaper.h"
#include "CurveTracer.h"
#include "EdgeCrossings.h"
#include "EdgeSampler.h"
#include "NeighborhoodSize.h"
#include "Polyline.h"
#include "SampleThreading.h"
#include "SchemeModels.h"
#include "ValueScaling.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

namespace SurfaceScalars
{
namespace
{

constexpr std::size_t SamplesPerBlock = 256;

class LevelSetTracing
{
public:
  LevelSetTracing(const NeighborGraph& graph, const ValuesRef& values, const ValueScaling& scaling,
    const ContourParameters& parameters, const Execution& execution);
  LevelSets run(std::vector<double> levels);

private:
  void scaleVolumeFunction(const ValueScaling& scaling);
  void chooseFitSize();
  std::vector<LevelCrossings> findSpacedCrossings() const;
  void sampleLevels(const std::vector<LevelCrossings>& crossings);
  void traceLevels();
  std::vector<LevelSetCurve> traceLevel(std::size_t level, const Poll& poll) const;
  TracingLimits tracingLimits() const;
  void collect(LevelSets& result);

  ContourParameters parameters_;
  Execution execution_;
  SampledFunction function_;
  FitSize fitSize_{ 0, 0.0 };
  double widening_ = 1.0;
  std::vector<double> levels_;                      ///< scaled iso-values
  std::vector<std::vector<LevelSetPoint>> samples_; ///< per level
  std::vector<std::vector<LevelSetCurve>> curves_;  ///< per level
};

LevelSetTracing::LevelSetTracing(const NeighborGraph& graph, const ValuesRef& values,
  const ValueScaling& scaling, const ContourParameters& parameters, const Execution& execution)
  : parameters_(parameters)
  , execution_(execution)
  , function_{ graph, values.unaryExpr(scaling), {}, {}, {} }
{
  if (parameters.volumeFunction)
  {
    this->scaleVolumeFunction(scaling);
    this->execution_.threadCount = 1; // the caller's function need not be safe for more
  }
}

void LevelSetTracing::scaleVolumeFunction(const ValueScaling& scaling)
{
  const Vector3d origin = this->function_.graph.origin();
  const VolumeFunction function = this->parameters_.volumeFunction;
  this->function_.volumeFunction = [=](const Vector3d& place, Vector3d* gradient)
  {
    const double value = function(place + origin, gradient);
    if (gradient)
    {
      *gradient *= 0.5 / scaling.halfRange;
    }
    return scaling(value);
  };
}

void LevelSetTracing::chooseFitSize()
{
  const NeighborGraph& graph = this->function_.graph;
  this->fitSize_ = { this->parameters_.neighborCount, this->parameters_.searchRadius };
  if (this->fitSize_.count == 0)
  {
    this->fitSize_.count = this->fitSize_.radius > 0.0
      ? LocalFit::termCount(polynomialDegree(this->parameters_)) + 1
      : chooseNeighborCount(graph,
          this->function_.volumeFunction ? Values() : this->function_.values,
          polynomialDegree(this->parameters_), this->execution_.part(0.0, 0.1));
  }
  this->fitSize_.count = std::min(this->fitSize_.count, static_cast<int>(graph.pointCount()));
  const double steps = this->fitSize_.radius / graph.medianSamplingStep();
  const double used = std::max<double>(
    this->fitSize_.count, std::min<double>(Pi * steps * steps, graph.pointCount()));
  this->widening_ = std::sqrt(std::max(1.0, used / UsualNeighborCount));
}

TracingLimits LevelSetTracing::tracingLimits() const
{
  // Random samples leave a disc of radius r (in steps) empty with probability exp(-pi r^2) at a
  // place; this radius makes an empty disc unlikely among all the places there are.
  double voidRadius = std::sqrt(std::log(1e5 * this->function_.graph.pointCount()) / Pi);
  const double link = this->parameters_.linkDistance;
  if (link > 0.0)
  {
    voidRadius = std::min(voidRadius, 0.5 * link);
  }
  return { this->parameters_.tolerance * this->function_.graph.medianSamplingStep(),
    this->parameters_.maximumIterations, this->widening_, voidRadius, link };
}

std::vector<LevelCrossings> LevelSetTracing::findSpacedCrossings() const
{
  std::vector<LevelCrossings> crossings =
    findCrossings(this->function_, this->levels_, this->execution_.part(0.2, 0.25));
  parallelForEach(crossings.size(), this->execution_.part(0.25, 0.3),
    [&](std::size_t level, const Poll& poll)
    {
      const NeighborGraph& graph = this->function_.graph;
      crossings[level] = chained(thinned(crossings[level], graph, this->widening_, poll), graph);
    });
  return crossings;
}

void LevelSetTracing::sampleLevels(const std::vector<LevelCrossings>& crossings)
{
  // One list of all the crossings, so that one level keeps all threads busy too.
  std::vector<std::size_t> ends;
  ends.reserve(crossings.size());
  std::size_t count = 0;
  for (const LevelCrossings& ofLevel : crossings)
  {
    ends.push_back(count += ofLevel.size());
  }
  std::vector<std::optional<LevelSetPoint>> found(count);
  parallelForEach((count + SamplesPerBlock - 1) / SamplesPerBlock, this->execution_.part(0.3, 0.6),
    [&](std::size_t block, const Poll& poll)
    {
      EdgeSampler sampler(
        this->function_, this->fitSize_, this->parameters_, this->tracingLimits());
      const std::size_t end = std::min(count, (block + 1) * SamplesPerBlock);
      for (std::size_t i = block * SamplesPerBlock; i < end; ++i)
      {
        poll(); // a large SearchRadius makes even one sample slow
        const auto level =
          static_cast<std::size_t>(std::upper_bound(ends.begin(), ends.end(), i) - ends.begin());
        const std::size_t first = ends[level] - crossings[level].size();
        found[i] = sampler.sample(crossings[level][i - first], this->levels_[level]);
      }
    });
  this->samples_.resize(crossings.size());
  for (std::size_t i = 0, level = 0; i < count; ++i)
  {
    for (; i >= ends[level]; ++level)
    {
    }
    if (found[i])
    {
      this->samples_[level].push_back(*found[i]);
    }
  }
}

std::vector<LevelSetCurve> LevelSetTracing::traceLevel(std::size_t level, const Poll& poll) const
{
  const std::unique_ptr<LevelSetModel> model =
    makeModel(this->function_, this->fitSize_, this->parameters_);
  const TracingLimits limits = this->tracingLimits();
  const bool onLevelSet = this->parameters_.scheme != Scheme::Linear &&
    this->parameters_.surface != SurfaceModel::Unprojected;
  const CurveShaper shape(*model, this->levels_[level], limits,
    { this->parameters_.fit, this->parameters_.sampleSpacing, onLevelSet }, poll);

  std::vector<TracedCurve> tracedCurves =
    traceCurves(*model, this->function_, this->levels_[level], this->samples_[level], limits, poll);
  if (!onLevelSet)
  {
    tracedCurves = threadSamples(tracedCurves, this->samples_[level]);
  }
  std::vector<LevelSetCurve> curves;
  for (const TracedCurve& tracedCurve : tracedCurves)
  {
    poll();
    TracedCurve traced = shape(tracedCurve);
    LevelSetCurve curve;
    curve.level = level;
    curve.component = static_cast<int>(curves.size());
    curve.closed = traced.closed;
    const Vector3d saddle = traced.points.front().position; // if it has corners
    curve.points = std::move(traced.points);
    curve.length = polylineLength(curve.points, curve.closed);
    orientOutwards(curve.points);
    if (!traced.corners.empty() && curve.points.front().position != saddle)
    {
      // Reversed: it begins at its saddle again.
      std::rotate(curve.points.begin(), curve.points.end() - 1, curve.points.end());
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

void LevelSetTracing::traceLevels()
{
  this->curves_.resize(this->levels_.size());
  parallelForEach(this->levels_.size(), this->execution_.part(0.6, 1.0),
    [this](std::size_t level, const Poll& poll)
    { this->curves_[level] = this->traceLevel(level, poll); });
}

void LevelSetTracing::collect(LevelSets& result)
{
  const Vector3d& origin = this->function_.graph.origin();
  for (std::size_t level = 0; level < this->levels_.size(); ++level)
  {
    result.componentCounts.push_back(static_cast<int>(this->curves_[level].size()));
    for (LevelSetCurve& curve : this->curves_[level])
    {
      for (LevelSetPoint& point : curve.points)
      {
        point.position += origin;
      }
      result.curves.push_back(std::move(curve));
    }
    for (LevelSetPoint& point : this->samples_[level])
    {
      orientOutwards(point);
      point.position += origin;
      result.samples.push_back({ level, point });
    }
  }
  result.neighborCount = this->fitSize_.radius > 0.0 ? 0 : this->fitSize_.count;
}

LevelSets LevelSetTracing::run(std::vector<double> levels)
{
  this->levels_ = std::move(levels);
  this->chooseFitSize();
  prepareModels(
    this->function_, this->fitSize_, this->parameters_, this->execution_.part(0.1, 0.2));
  this->sampleLevels(this->findSpacedCrossings());
  this->traceLevels();
  LevelSets result;
  this->collect(result);
  return result;
}

} // namespace

LevelSets traceLevelSets(const NeighborGraph& graph, const ValuesRef& values,
  const ContourParameters& parameters, const Execution& execution)
{
  checkContourInput(graph, values, parameters);
  std::vector<double> isoValues = parameters.isoValues;
  std::sort(isoValues.begin(), isoValues.end());
  isoValues.erase(std::unique(isoValues.begin(), isoValues.end()), isoValues.end());

  LevelSets result;
  const ValueScaling scaling(values);
  if (scaling.halfRange > 0.0)
  {
    std::vector<double> levels(isoValues.size());
    std::transform(isoValues.begin(), isoValues.end(), levels.begin(), scaling);
    result = LevelSetTracing(graph, values, scaling, parameters, execution).run(std::move(levels));
  }
  else
  {
    result.componentCounts.assign(
      isoValues.size(), 0); // constant: no edge has its ends on different sides
  }
  result.isoValues = std::move(isoValues);
  return result;
}

} // namespace SurfaceScalars
