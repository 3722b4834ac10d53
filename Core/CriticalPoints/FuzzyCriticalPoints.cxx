#include "FuzzyCriticalPoints.h"

#include "CriticalChecks.h"
#include "CriticalClusters.h"
#include "CriticalField.h"
#include "CriticalRefinement.h"
#include "CriticalScale.h"
#include "CriticalSweep.h"
#include "Persistence.h"
#include "ValueScaling.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace SurfaceScalars
{
namespace
{

constexpr double ClusterRadius = 0.5;         // in radii of the fits
constexpr double AutomaticProbability = 1e-4; // of the likeliest sample, which is within 2.4 steps

/// The samples that a critical point stands for.
struct Cluster
{
  Index nearest;
  Index likeliest;
};

Cluster clusterAround(const NeighborGraph& graph, const Vector3d& place, double radius,
  const Values& probability, Neighborhood& near)
{
  graph.nearest(place, 1, near);
  Cluster cluster{ near.indices.front(), near.indices.front() };
  graph.within(place, radius, near);
  for (const Index sample : near.indices)
  {
    cluster.likeliest =
      probability[sample] > probability[cluster.likeliest] ? sample : cluster.likeliest;
  }
  return cluster;
}

Values scaled(const ValuesRef& values, const ValueScaling& scaling)
{
  if (scaling.halfRange > 0.0)
  {
    return values.unaryExpr(scaling);
  }
  return Values::Zero(values.size());
}

class CriticalSearch
{
public:
  CriticalSearch(const NeighborGraph& graph, const ValuesRef& values,
    const CriticalPointParameters& parameters, const Execution& execution);

  FuzzyCriticalPoints run();

private:
  CriticalPoint describe(const TypedPoint& typed, Neighborhood& near) const;
  void collect(const std::vector<TypedPoint>& typed);
  void measurePersistence();
  void unscale();

  const NeighborGraph& graph_;
  const CriticalPointParameters& parameters_;
  Execution execution_;
  ValueScaling scaling_;
  Values values_; ///< scaled
  CriticalScale scale_;
  CriticalSweep sweep_;
  FuzzyCriticalPoints result_;
};

CriticalSearch::CriticalSearch(const NeighborGraph& graph, const ValuesRef& values,
  const CriticalPointParameters& parameters, const Execution& execution)
  : graph_(graph)
  , parameters_(parameters)
  , execution_(execution)
  , scaling_(values)
  , values_(scaled(values, this->scaling_))
  , scale_(chooseCriticalScale(graph, this->values_, parameters, execution.part(0.0, 0.08)))
{
  if (parameters.probabilityModel == ProbabilityModel::NormalAngle)
  {
    this->execution_.threadCount = 1; // the caller's function need not be safe for more
  }
  this->scale_.field =
    makeCriticalField(graph, this->values_, this->scaling_, parameters, execution.part(0.08, 0.1));
}

FuzzyCriticalPoints CriticalSearch::run()
{
  this->sweep_ = sweepSamples(this->graph_, this->scale_, this->parameters_.probabilityModel,
    this->execution_.part(0.1, 0.6));
  const std::vector<RefinedPoint> refined =
    refineCandidates(this->sweep_.candidates, this->scale_, this->execution_.part(0.6, 0.75));
  this->collect(clusterPoints(refined, this->scale_, this->execution_.part(0.75, 0.85)));
  this->measurePersistence();
  this->unscale();
  this->result_.neighborCount =
    this->parameters_.searchRadius > 0.0 ? 0 : this->scale_.neighborCount;
  return std::move(this->result_);
}

CriticalPoint CriticalSearch::describe(const TypedPoint& typed, Neighborhood& near) const
{
  const SampleCriticality& samples = this->sweep_.samples;
  const Vector3d place = typed.point.place + this->scale_.origin;
  const Cluster cluster = clusterAround(
    this->graph_, place, ClusterRadius * typed.point.reach, samples.probability, near);
  CriticalPoint point;
  point.type = typed.type;
  point.multiplicity = typed.multiplicity;
  point.probability = samples.probability[cluster.likeliest];
  if (this->parameters_.refine)
  {
    point.position = place + this->graph_.origin();
    point.value = typed.point.value;
    point.residual = typed.point.residual;
    point.input = this->graph_.inputOfPoint(cluster.nearest);
    return point;
  }
  const Index sample = cluster.likeliest;
  point.position = this->graph_.points().col(sample) + this->graph_.origin();
  point.value = this->sweep_.values[sample];
  point.residual = samples.gradient.col(sample).norm();
  point.input = this->graph_.inputOfPoint(sample);
  return point;
}

void CriticalSearch::collect(const std::vector<TypedPoint>& typed)
{
  const double threshold = this->parameters_.probabilityThreshold > 0.0
    ? this->parameters_.probabilityThreshold
    : AutomaticProbability;
  Neighborhood near;
  for (const TypedPoint& found : typed)
  {
    const CriticalPoint point = this->describe(found, near);
    if (point.probability >= threshold)
    {
      this->result_.points.push_back(point);
    }
  }
  std::sort(this->result_.points.begin(), this->result_.points.end(),
    [](const CriticalPoint& a, const CriticalPoint& b)
    { return a.value != b.value ? a.value < b.value : a.input < b.input; });
}

void CriticalSearch::measurePersistence()
{
  if (this->result_.points.empty())
  {
    return;
  }
  const double reach = std::sqrt(this->scale_.neighborCount / Pi);
  const std::vector<CriticalPair> pairs = assignPersistence(this->result_.points, this->graph_,
    this->sweep_.values, reach, this->execution_.part(0.85, 1.0));
  if (this->parameters_.persistenceThreshold > 0.0)
  {
    removeBelow(this->result_.points, pairs, this->parameters_.persistenceThreshold);
  }
}

/// Into the caller's values; f's range was 1.
void CriticalSearch::unscale()
{
  const double range = 2.0 * this->scaling_.halfRange;
  this->result_.samples = std::move(this->sweep_.samples);
  SampleCriticality& samples = this->result_.samples;
  samples.gradient *= range;
  samples.type.assign(this->graph_.pointCount(), CriticalType::Regular);
  for (CriticalPoint& point : this->result_.points)
  {
    point.value = this->scaling_.inverse(point.value);
    point.persistence *= range;
    point.residual *= range;
    samples.type[this->graph_.pointOfInput(point.input)] = point.type;
    this->result_.indexSum += indexOf(point);
  }
}

} // namespace

FuzzyCriticalPoints findCriticalPoints(const NeighborGraph& graph, const ValuesRef& values,
  const CriticalPointParameters& parameters, const Execution& execution)
{
  checkCriticalInput(graph, values, parameters);
  return CriticalSearch(graph, values, parameters, execution).run();
}

} // namespace SurfaceScalars
