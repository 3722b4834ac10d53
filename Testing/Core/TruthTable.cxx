// Prints how right and how accurate the level sets are, as tables in Markdown for Documentation.
// The exit code tells whether the default scheme keeps its promises.

#include "Arguments.h"
#include "MarkdownReport.h"
#include "TruthRun.h"

#include <cmath>
#include <cstdio>
#include <functional>
#include <string>

using namespace SurfaceScalars;
using namespace SurfaceScalars::Truth;

namespace
{

const std::vector<unsigned> Seeds{ 1, 2, 3 };

MarkdownReport report;

TruthResult runSeeds(const TruthCase& truthCase, TruthSampling sampling,
  const ContourParameters& parameters, const std::vector<unsigned>& seeds)
{
  TruthResult all;
  for (const unsigned seed : seeds)
  {
    sampling.seed = seed;
    const TruthResult result = runTruth(truthCase, sampling, parameters);
    if (!result.disagreements.empty())
    {
      std::fprintf(
        stderr, "%s:\n%s", describe(truthCase, sampling).c_str(), result.disagreements.c_str());
    }
    all.add(result);
  }
  return all;
}

const char* surfaceName(const TruthCase& truthCase)
{
  return truthCase.torus == Torus::Closed ? "closed" : "cut";
}

void printDefaultScheme()
{
  report.head("Default scheme, no noise, three seeds (lengths in sampling steps)",
    { "points", "function", "torus", "right", "mean error", "max error", "exact to curve, max",
      "2 steps inside", "kept" });
  TruthResult total;
  for (const int pointCount : { 5000, 20000, 100000 })
  {
    for (const TruthCase& truthCase : truthCases())
    {
      const TruthSampling sampling{ pointCount };
      const TruthResult result = runSeeds(truthCase, sampling, {}, Seeds);
      const CurveScore& score = result.score;
      const bool accurate = pointCount < 100000 ||
        (score.pointMean() <= 0.01 && score.pointMaximum <= 0.1 && score.exactMaximum <= 0.1);
      report.row({ std::to_string(pointCount), truthCase.function.name, surfaceName(truthCase),
        ofAll(result.rightCount, result.isoValueCount), number("%.5f", score.pointMean()),
        number("%.4f", score.pointMaximum), number("%.4f", score.exactMaximum),
        number("%.4f", score.exactInnerMaximum), report.kept(accurate) });
      total.add(result);
    }
  }
  std::printf("\nRight: %d of %d iso-values (%.2f%%; promised 99%%: %s).\n", total.rightCount,
    total.isoValueCount, 100.0 * total.rightFraction(),
    report.kept(total.rightFraction() >= 0.99).c_str());
}

struct Noise
{
  const char* name;
  double onPoints;
  double onValues;
};

void printNoise()
{
  report.head("Default scheme with noise, 100000 points, three seeds",
    { "noise", "function", "torus", "k", "right", "mean error in steps", "in standard deviations",
      "kept" });
  for (const Noise& noise : { Noise{ "0.5% of the diagonal on the points", 0.005, 0.0 },
         Noise{ "1% of the diagonal on the points", 0.01, 0.0 },
         Noise{ "1% of the range on f", 0.0, 0.01 } })
  {
    TruthResult total;
    for (const TruthCase& truthCase : truthCases())
    {
      const TruthSampling sampling{ 100000, 1, noise.onPoints, noise.onValues };
      const TruthResult result = runSeeds(truthCase, sampling, {}, Seeds);
      const double mean = result.score.pointMean();
      const bool onPoints = noise.onPoints > 0.0;
      const double relative = onPoints ? mean / result.pointNoiseInSteps : std::nan("");
      const bool small = onPoints ? relative <= 0.3 : mean <= 0.35;
      report.row({ noise.name, truthCase.function.name, surfaceName(truthCase),
        std::to_string(result.neighborCount), ofAll(result.rightCount, result.isoValueCount),
        number("%.3f", mean), onPoints ? number("%.3f", relative) : "", report.kept(small) });
      total.add(result);
    }
    report.row({ noise.name, "all", "", "", number("%.1f%%", 100.0 * total.rightFraction()), "", "",
      report.kept(total.rightFraction() >= 0.9) });
  }
}

void printSchemes()
{
  report.head("Schemes beside each other, no noise, seed 1 (lengths in sampling steps)",
    { "scheme", "surface", "points", "right", "mean error", "max error", "exact to curve, max" });
  struct Choice
  {
    const char* name;
    const char* surfaceName;
    Scheme scheme;
    SurfaceModel surface;
  };
  for (const Choice& choice :
    { Choice{ "Linear", "Unprojected", Scheme::Linear, SurfaceModel::Unprojected },
      Choice{ "Linear", "MLS", Scheme::Linear, SurfaceModel::MLS },
      Choice{ "ExplicitMLS (the paper's)", "MLS", Scheme::ExplicitMLS, SurfaceModel::MLS },
      Choice{ "ParameterizedMLS (default)", "Unprojected", Scheme::ParameterizedMLS,
        SurfaceModel::Unprojected },
      Choice{ "ParameterizedMLS (default)", "MLS", Scheme::ParameterizedMLS, SurfaceModel::MLS },
      Choice{ "ParameterizedMLS", "RBF", Scheme::ParameterizedMLS, SurfaceModel::RBF },
      Choice{ "LocalRBF", "MLS", Scheme::LocalRBF, SurfaceModel::MLS },
      Choice{ "LocalRBF", "RBF", Scheme::LocalRBF, SurfaceModel::RBF },
      Choice{ "Hybrid", "MLS", Scheme::Hybrid, SurfaceModel::MLS } })
  {
    for (const int pointCount : { 5000, 20000, 100000 })
    {
      ContourParameters parameters;
      parameters.scheme = choice.scheme;
      parameters.surface = choice.surface;
      TruthResult total;
      for (const TruthCase& truthCase : truthCases())
      {
        total.add(runTruth(truthCase, TruthSampling{ pointCount }, parameters));
      }
      report.row({ choice.name, choice.surfaceName, std::to_string(pointCount),
        ofAll(total.rightCount, total.isoValueCount), number("%.5f", total.score.pointMean()),
        number("%.4f", total.score.pointMaximum), number("%.4f", total.score.exactMaximum) });
    }
  }
}

} // namespace

// Without arguments all tables; otherwise those named: clean, noise, schemes.
int main(int argc, char** argv)
{
  const Arguments arguments(argc, argv, { "clean", "noise", "schemes" });
  if (arguments.wants("clean"))
  {
    printDefaultScheme();
  }
  if (arguments.wants("noise"))
  {
    printNoise();
  }
  if (arguments.wants("schemes"))
  {
    printSchemes();
  }
  return report.exitCode();
}
