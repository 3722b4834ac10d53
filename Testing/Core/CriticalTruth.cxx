#include "CriticalTable.h"

#include "CriticalRun.h"

namespace SurfaceScalars::Truth
{
namespace
{

struct Disturbance
{
  const char* name;
  double onPoints;  ///< fraction of the diagonal
  double onValues;  ///< fraction of f's range
  double precision; ///< promised
  double recall;
  int fewestPoints; ///< for which it is promised
};

const std::vector<Disturbance> Disturbances{ { "none", 0.0, 0.0, 1.0, 1.0, 0 },
  { "1% on points", 0.01, 0.0, 0.95, 0.9, 0 }, { "1% on f", 0.0, 0.01, 0.95, 0.9, 0 },
  { "1% on both", 0.01, 0.01, 0.95, 0.9, 0 }, { "5% on f", 0.0, 0.05, 0.95, 0.8, 50000 } };

/// Promised without noise, in sampling steps.
double largestError(const Disturbance& noise, int pointCount)
{
  const bool clean = noise.onPoints == 0.0 && noise.onValues == 0.0;
  return !clean ? std::numeric_limits<double>::infinity() : pointCount < 50000 ? 0.15 : 0.05;
}

void reportRun(MarkdownReport& report, const CriticalCase& criticalCase, int pointCount,
  const Disturbance& noise, unsigned seeds)
{
  const TruthSampling sampling{ pointCount, 1, noise.onPoints, noise.onValues };
  const CriticalResult result = runSeeds(criticalCase, sampling, seeds);
  const CriticalScore& score = result.score;
  const bool kept = score.precision() >= noise.precision && score.recall() >= noise.recall &&
    score.errorMaximum <= largestError(noise, pointCount);
  report.row({ criticalCase.function.name + ", " + criticalCase.surface.name,
    std::to_string(pointCount), noise.name, std::to_string(result.neighborCount),
    number("%.3f", score.precision()), number("%.3f", score.recall()),
    std::to_string(score.uncertainCount), number("%.4f", score.meanError()),
    number("%.3f", score.errorMaximum), ofAll(result.rightIndexSums, result.runCount),
    number("%.1f", result.seconds / result.graphSeconds), report.kept(kept) });
}

} // namespace

void reportTruth(MarkdownReport& report, bool reduced)
{
  report.head("What is found",
    { "function", "points", "noise", "k", "precision", "recall", "uncertain", "mean error",
      "max error", "index sum = χ", "time / graph", "kept" });
  for (const CriticalCase& criticalCase : criticalCases())
  {
    for (const int pointCount : { 5000, 50000, 500000 })
    {
      for (const Disturbance& noise : Disturbances)
      {
        if (pointCount >= noise.fewestPoints && !(reduced && pointCount > 50000))
        {
          reportRun(report, criticalCase, pointCount, noise, reduced ? 2 : 5);
        }
      }
    }
  }
}

void reportStability(MarkdownReport& report)
{
  report.head("Half as many neighbors again",
    { "function", "points", "noise", "k", "found", "1.5 k", "found", "the same", "max distance",
      "kept" });
  for (const CriticalCase& criticalCase : criticalCases())
  {
    for (const Disturbance& noise : Disturbances)
    {
      const TruthSampling sampling{ 50000, 1, noise.onPoints, noise.onValues };
      const CriticalSamples samples(criticalCase, sampling);
      const NeighborGraph graph(samples.points, NeighborQuery());
      const auto find = [&](int neighborCount)
      {
        CriticalPointParameters parameters;
        parameters.neighborCount = neighborCount;
        return findCriticalPoints(graph, graph.average(samples.values), parameters);
      };
      const FuzzyCriticalPoints usual = find(0);
      const FuzzyCriticalPoints wider = find(usual.neighborCount * 3 / 2);
      const CriticalScore score =
        scoreCriticalPoints(wider.points, usual.points, unambiguousRadius(criticalCase.exact));
      const bool same = score.rightCount == static_cast<int>(usual.points.size()) &&
        usual.points.size() == wider.points.size();
      report.row({ criticalCase.function.name + ", " + criticalCase.surface.name,
        std::to_string(sampling.pointCount), noise.name, std::to_string(usual.neighborCount),
        std::to_string(usual.points.size()), std::to_string(wider.neighborCount),
        std::to_string(wider.points.size()), std::to_string(score.rightCount),
        number("%.3f", score.errorMaximum / samples.samplingStep), report.kept(same) });
    }
  }
}

} // namespace SurfaceScalars::Truth
