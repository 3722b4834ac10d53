#include "TruthRun.h"

#include "CriticalPoints.h"
#include "Sampling.h"

#include <chrono>
#include <cmath>
#include <sstream>

namespace SurfaceScalars::Truth
{
namespace
{

CurveScore inSteps(CurveScore score, double samplingStep)
{
  score.pointSum /= samplingStep;
  score.pointMaximum /= samplingStep;
  score.exactMaximum /= samplingStep;
  score.exactInnerMaximum /= samplingStep;
  return score;
}

std::vector<const LevelSetCurve*> curvesOfLevel(const LevelSets& levelSets, std::size_t level)
{
  std::vector<const LevelSetCurve*> curves;
  for (const LevelSetCurve& curve : levelSets.curves)
  {
    if (curve.level == level)
    {
      curves.push_back(&curve);
    }
  }
  return curves;
}

std::string disagreement(const ExactLevelSet& exact, int closedCount, int openCount)
{
  std::ostringstream line;
  line.precision(12);
  line << "f = " << exact.isoValue << ": " << closedCount << " closed and " << openCount
       << " open curves instead of " << exact.closedCount << " and " << exact.openCount << '\n';
  return line.str();
}

} // namespace

TruthCase makeTruthCase(const SpaceFunction& function, Torus torus, int isoValueCount)
{
  const std::vector<double> critical = criticalValues(function, torus);
  TruthCase result{ function, torus, critical.back() - critical.front(),
    regularIsoValues(critical, isoValueCount, 0.01), {} };
  const LevelSetFamily family(function, torus);
  for (const double isoValue : result.isoValues)
  {
    result.exact.push_back(family.at(isoValue));
  }
  return result;
}

const std::vector<TruthCase>& truthCases()
{
  static const std::vector<TruthCase> cases = []
  {
    std::vector<TruthCase> result;
    for (const SpaceFunction& function : { tiltedHeight(), saddleWithLogarithm() })
    {
      for (const Torus torus : { Torus::Closed, Torus::Cut })
      {
        result.push_back(makeTruthCase(function, torus));
      }
    }
    return result;
  }();
  return cases;
}

double TruthResult::rightFraction() const
{
  return static_cast<double>(this->rightCount) / this->isoValueCount;
}

void TruthResult::add(const TruthResult& other)
{
  this->isoValueCount += other.isoValueCount;
  this->rightCount += other.rightCount;
  this->score.add(other.score);
  this->samplingStep = this->samplingStep > 0.0 ? this->samplingStep : other.samplingStep;
  this->pointNoiseInSteps = std::max(this->pointNoiseInSteps, other.pointNoiseInSteps);
  this->neighborCount = std::max(this->neighborCount, other.neighborCount);
  this->seconds += other.seconds;
  this->disagreements += other.disagreements;
}

TruthResult runTruth(
  const TruthCase& truthCase, const TruthSampling& sampling, const ContourParameters& parameters)
{
  Points points = randomTorus(sampling.pointCount, truthCase.torus, sampling.seed);
  Values values = valuesOf(truthCase.function, points);
  addNoise(points, sampling.pointNoise * torusDiagonal(), sampling.seed + 1000);
  addNoise(values, sampling.valueNoise * truthCase.range, sampling.seed + 2000);

  const NeighborGraph graph(points, NeighborQuery());
  ContourParameters used = parameters;
  used.isoValues = truthCase.isoValues;
  const auto start = std::chrono::steady_clock::now();
  const LevelSets levelSets = traceLevelSets(graph, graph.average(values), used);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;

  TruthResult result;
  result.samplingStep = graph.medianSamplingStep();
  result.pointNoiseInSteps = sampling.pointNoise * torusDiagonal() / result.samplingStep;
  result.neighborCount = levelSets.neighborCount;
  result.seconds = elapsed.count();
  for (std::size_t level = 0; level < truthCase.exact.size(); ++level)
  {
    const ExactLevelSet& exact = truthCase.exact[level];
    const auto curves = curvesOfLevel(levelSets, level);
    const auto closedCount = static_cast<int>(std::count_if(
      curves.begin(), curves.end(), [](const LevelSetCurve* curve) { return curve->closed; }));
    const int openCount = static_cast<int>(curves.size()) - closedCount;
    const bool right = closedCount == exact.closedCount && openCount == exact.openCount;
    ++result.isoValueCount;
    result.rightCount += right ? 1 : 0;
    result.disagreements += right ? "" : disagreement(exact, closedCount, openCount);

    const double boundaryMargin = truthCase.torus == Torus::Cut ? 2.0 * result.samplingStep : 0.0;
    result.score.add(
      inSteps(scoreCurves(curves, truthCase.function, exact, boundaryMargin), result.samplingStep));
  }
  return result;
}

std::string describe(const TruthCase& truthCase, const TruthSampling& sampling)
{
  std::ostringstream text;
  text << truthCase.function.name << " on the "
       << (truthCase.torus == Torus::Closed ? "closed" : "cut") << " torus, " << sampling.pointCount
       << " points, seed " << sampling.seed;
  if (sampling.pointNoise > 0.0)
  {
    text << ", noise " << 100.0 * sampling.pointNoise << "% on the points";
  }
  if (sampling.valueNoise > 0.0)
  {
    text << ", noise " << 100.0 * sampling.valueNoise << "% on f";
  }
  return text.str();
}

} // namespace SurfaceScalars::Truth
