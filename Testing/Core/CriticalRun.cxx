#include "CriticalRun.h"

#include "CriticalPoints.h"
#include "Sampling.h"

#include <algorithm>
#include <chrono>

namespace SurfaceScalars::Truth
{
namespace
{

class Stopwatch
{
public:
  double seconds() const
  {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - this->start_;
    return elapsed.count();
  }

private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

} // namespace

CriticalCase::CriticalCase(ClosedSurface on, SpaceFunction of)
  : surface(std::move(on))
  , function(std::move(of))
  , exact(criticalPoints(surface, function))
{
  const auto [lowest, highest] = std::minmax_element(this->exact.begin(), this->exact.end(),
    [](const CriticalPoint& a, const CriticalPoint& b) { return a.value < b.value; });
  this->range = highest->value - lowest->value;
}

CriticalSamples::CriticalSamples(const CriticalCase& criticalCase, const TruthSampling& sampling)
  : exactPoints(criticalCase.surface.sample(sampling.pointCount, sampling.seed))
  , points(exactPoints)
  , values(valuesOf(criticalCase.function, exactPoints))
  , samplingStep(NeighborGraph(exactPoints, NeighborQuery()).medianSamplingStep())
{
  const Vector3d extent =
    this->exactPoints.rowwise().maxCoeff() - this->exactPoints.rowwise().minCoeff();
  addNoise(this->points, sampling.pointNoise * extent.norm(), sampling.seed + 1000);
  addNoise(this->values, sampling.valueNoise * criticalCase.range, sampling.seed + 2000);
}

void CriticalResult::add(const CriticalResult& other)
{
  this->score.add(other.score);
  this->runCount += other.runCount;
  this->rightIndexSums += other.rightIndexSums;
  this->neighborCount = std::max(this->neighborCount, other.neighborCount);
  this->seconds += other.seconds;
  this->graphSeconds += other.graphSeconds;
}

CriticalResult runCritical(const CriticalCase& criticalCase, const TruthSampling& sampling)
{
  const CriticalSamples samples(criticalCase, sampling);
  CriticalResult result;
  const Stopwatch graphTime;
  const NeighborGraph graph(samples.points, NeighborQuery());
  result.graphSeconds = graphTime.seconds();
  const Stopwatch time;
  const FuzzyCriticalPoints found = findCriticalPoints(graph, graph.average(samples.values), {});
  result.seconds = time.seconds();
  result.score =
    scoreCriticalPoints(found.points, criticalCase.exact, unambiguousRadius(criticalCase.exact))
      .inUnitsOf(samples.samplingStep);
  result.runCount = 1;
  result.rightIndexSums = found.indexSum == criticalCase.surface.eulerCharacteristic ? 1 : 0;
  result.neighborCount = found.neighborCount;
  return result;
}

CriticalResult runSeeds(const CriticalCase& criticalCase, TruthSampling sampling, unsigned seeds)
{
  CriticalResult all;
  for (sampling.seed = 1; sampling.seed <= seeds; ++sampling.seed)
  {
    all.add(runCritical(criticalCase, sampling));
  }
  return all;
}

const std::vector<CriticalCase>& criticalCases()
{
  static const std::vector<CriticalCase> cases{ { closedTorus(), tiltedHeight() },
    { closedTorus(), cosinesOfAngles() }, { unitSphere(), tiltedHeight() } };
  return cases;
}

} // namespace SurfaceScalars::Truth
