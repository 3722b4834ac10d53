// Prints how right and how accurate the level sets are, as tables in Markdown for Documentation.
// The exit code tells whether the default scheme keeps its promises.

#include "TruthRun.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>

using namespace SurfaceScalars;
using namespace SurfaceScalars::Truth;

namespace
{

const std::vector<unsigned> Seeds{ 1, 2, 3 };

bool promisesKept = true;

std::string kept(bool promise)
{
  promisesKept = promisesKept && promise;
  return promise ? "yes" : "**no**";
}

void heading(const char* title, const char* columns)
{
  std::printf("\n### %s\n\n%s\n", title, columns);
  for (const char* c = columns; *c != '\0'; ++c)
  {
    std::putchar(*c == '|' ? '|' : '-');
  }
  std::putchar('\n');
}

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

/// The character that separates columns is escaped.
std::string functionName(const TruthCase& truthCase)
{
  std::string name = truthCase.function.name;
  for (std::size_t i = name.find('|'); i != std::string::npos; i = name.find('|', i + 2))
  {
    name.insert(i, 1, '\\');
  }
  return name;
}

std::string threeDigits(double value)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.3f", value);
  return text;
}

const char* surfaceName(const TruthCase& truthCase)
{
  return truthCase.torus == Torus::Closed ? "closed" : "cut";
}

void printDefaultScheme()
{
  heading("Default scheme, no noise, three seeds (lengths in sampling steps)",
    "| points | function | torus | right | mean error | max error | exact to curve, max | 2 steps "
    "inside "
    "| kept |");
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
      std::printf("| %d | %s | %s | %d of %d | %.5f | %.4f | %.4f | %.4f | %s |\n", pointCount,
        functionName(truthCase).c_str(), surfaceName(truthCase), result.rightCount,
        result.isoValueCount, score.pointMean(), score.pointMaximum, score.exactMaximum,
        score.exactInnerMaximum, kept(accurate).c_str());
      std::fflush(stdout);
      total.add(result);
    }
  }
  std::printf("\nRight: %d of %d iso-values (%.2f%%; promised 99%%: %s).\n", total.rightCount,
    total.isoValueCount, 100.0 * total.rightFraction(),
    kept(total.rightFraction() >= 0.99).c_str());
}

struct Noise
{
  const char* name;
  double onPoints;
  double onValues;
};

void printNoise()
{
  heading("Default scheme with noise, 100000 points, three seeds",
    "| noise | function | torus | k | right | mean error in steps | in standard deviations | kept "
    "|");
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
      std::printf("| %s | %s | %s | %d | %d of %d | %.3f | %s | %s |\n", noise.name,
        functionName(truthCase).c_str(), surfaceName(truthCase), result.neighborCount,
        result.rightCount, result.isoValueCount, mean,
        onPoints ? threeDigits(relative).c_str() : "", kept(small).c_str());
      std::fflush(stdout);
      total.add(result);
    }
    std::printf("| %s | all | | | %.1f%% | | | %s |\n", noise.name, 100.0 * total.rightFraction(),
      kept(total.rightFraction() >= 0.9).c_str());
  }
}

void printSchemes()
{
  heading("Schemes beside each other, no noise, seed 1 (lengths in sampling steps)",
    "| scheme | surface | points | right | mean error | max error | exact to curve, max |");
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
      std::printf("| %s | %s | %d | %d of %d | %.5f | %.4f | %.4f |\n", choice.name,
        choice.surfaceName, pointCount, total.rightCount, total.isoValueCount,
        total.score.pointMean(), total.score.pointMaximum, total.score.exactMaximum);
      std::fflush(stdout);
    }
  }
}

} // namespace

// Without arguments all tables; otherwise those named: clean, noise, schemes.
int main(int argumentCount, char** arguments)
{
  const std::vector<std::string> wanted(arguments + 1, arguments + argumentCount);
  const auto prints = [&](const char* name)
  { return wanted.empty() || std::find(wanted.begin(), wanted.end(), name) != wanted.end(); };
  if (prints("clean"))
  {
    printDefaultScheme();
  }
  if (prints("noise"))
  {
    printNoise();
  }
  if (prints("schemes"))
  {
    printSchemes();
  }
  return promisesKept ? EXIT_SUCCESS : EXIT_FAILURE;
}
