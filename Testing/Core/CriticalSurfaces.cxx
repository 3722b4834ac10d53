#include "CriticalTable.h"

#include "CriticalRun.h"
#include "Sampling.h"
#include "Torus.h"

#include <algorithm>
#include <cmath>

namespace SurfaceScalars::Truth
{
namespace
{

void reportDoubleTorus(MarkdownReport& report, bool reduced)
{
  report.head("On a surface of genus 2, Euler characteristic −2",
    { "function", "points", "noise on f", "k", "exact", "precision", "recall", "mean error",
      "max error", "index sum = χ", "kept" });
  for (const SpaceFunction& function : { tiltedHeight(), saddleWithLogarithm() })
  {
    const CriticalCase criticalCase(doubleTorus(), function);
    for (const int pointCount : { 20000, 50000, 500000 })
    {
      for (const double noise : { 0.0, 0.01 })
      {
        if (reduced && pointCount > 50000)
        {
          continue;
        }
        const CriticalResult result =
          runSeeds(criticalCase, { pointCount, 1, 0.0, noise }, reduced ? 2 : 5);
        const CriticalScore& score = result.score;
        const bool isPromised = noise == 0.0 && pointCount >= 50000;
        report.row({ function.name, std::to_string(pointCount), number("%g%%", 100.0 * noise),
          std::to_string(result.neighborCount), std::to_string(criticalCase.exact.size()),
          number("%.3f", score.precision()), number("%.3f", score.recall()),
          number("%.4f", score.meanError()), number("%.3f", score.errorMaximum),
          ofAll(result.rightIndexSums, result.runCount),
          isPromised ? report.kept(result.rightIndexSums == result.runCount) : "" });
      }
    }
  }
}

/// What findCriticalPoints() makes of samples without noise.
struct OpenSurface
{
  NeighborGraph graph;
  FuzzyCriticalPoints found;

  OpenSurface(const Points& points, const SpaceFunction& function)
    : graph(points, NeighborQuery())
    , found(findCriticalPoints(graph, graph.average(valuesOf(function, points)), {}))
  {
  }
};

std::vector<std::string> cellsOf(const CriticalScore& score, MarkdownReport& report)
{
  return { std::to_string(score.exactCount), number("%.3f", score.precision()),
    number("%.3f", score.recall()), std::to_string(score.uncertainCount),
    number("%.4f", score.meanError()), number("%.3f", score.errorMaximum),
    report.kept(score.precision() == 1.0 && score.recall() == 1.0) };
}

void addRow(
  MarkdownReport& report, std::vector<std::string> row, const std::vector<std::string>& more)
{
  row.insert(row.end(), more.begin(), more.end());
  report.row(row);
}

/// Nothing is critical at the edges of the square.
void reportPlanarSaddles(MarkdownReport& report, unsigned seeds)
{
  report.head("Saddles of multiplicity m in the middle of a square",
    { "function", "m", "points", "exact", "precision", "recall", "uncertain", "mean error",
      "max error", "kept" });
  for (int multiplicity = 1; multiplicity <= 4; ++multiplicity)
  {
    CriticalPoint saddle;
    saddle.position.setZero();
    saddle.type = CriticalType::Saddle;
    saddle.multiplicity = multiplicity;
    const SpaceFunction function = planarSaddle(multiplicity);
    for (const int pointCount : { 5000, 50000 })
    {
      CriticalScore score;
      for (unsigned seed = 1; seed <= seeds; ++seed)
      {
        const OpenSurface square(randomPlane(pointCount, seed), function);
        score.add(scoreCriticalPoints(square.found.points, { saddle }, 0.25)
                    .inUnitsOf(square.graph.medianSamplingStep()));
      }
      addRow(report, { function.name, std::to_string(multiplicity), std::to_string(pointCount) },
        cellsOf(score, report));
    }
  }
}

/// Within three steps of the boundary, points may be found or not.
void reportCutTorus(MarkdownReport& report, unsigned seeds)
{
  report.head("On the torus without a piece",
    { "function", "points", "exact", "precision", "recall", "uncertain", "mean error", "max error",
      "kept" });
  for (const SpaceFunction& function : { tiltedHeight(), cosinesOfAngles() })
  {
    std::vector<CriticalPoint> exact = CriticalCase(closedTorus(), function).exact;
    exact.erase(std::remove_if(exact.begin(), exact.end(),
                  [](const CriticalPoint& point) { return distanceFromCut(point.position) < 0.0; }),
      exact.end());
    for (const int pointCount : { 5000, 50000 })
    {
      CriticalScore score;
      for (unsigned seed = 1; seed <= seeds; ++seed)
      {
        const OpenSurface torus(randomTorus(pointCount, Torus::Cut, seed), function);
        const double step = torus.graph.medianSamplingStep();
        score.add(scoreCriticalPoints(torus.found.points, exact, unambiguousRadius(exact),
          [=](const Vector3d& place) {
            return std::abs(distanceFromCut(place)) > 3.0 * step;
          }).inUnitsOf(step));
      }
      addRow(report, { function.name, std::to_string(pointCount) }, cellsOf(score, report));
    }
  }
}

} // namespace

void reportSurfaces(MarkdownReport& report, bool reduced)
{
  reportDoubleTorus(report, reduced);
  reportPlanarSaddles(report, reduced ? 2 : 5);
  reportCutTorus(report, reduced ? 2 : 5);
}

} // namespace SurfaceScalars::Truth
