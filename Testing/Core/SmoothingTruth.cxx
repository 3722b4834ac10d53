// Prints what smoothing keeps of a function under noise, as tables in Markdown for Documentation.
// The exit code tells whether FeaturePreserving keeps its promise.

#include "Arguments.h"
#include "MarkdownReport.h"
#include "Meshes.h"
#include "SmoothingRun.h"

#include <algorithm>
#include <iterator>

using namespace SurfaceScalars;
using namespace SurfaceScalars::Truth;

namespace
{

constexpr unsigned Seeds[] = { 1, 2, 3, 4, 5, 21, 22, 23, 24, 25 }; // with 11 to 20 it was tuned

/// What is kept: on coarse meshes, where an edge is half a smoothing length, less.
struct Bound
{
  int repetitions;        ///< of Seeds
  double largestDistance; ///< in smoothing lengths
};
constexpr Bound FullBound{ static_cast<int>(std::size(Seeds)), 1.0 };
constexpr Bound ReducedBound{ 5, Pi };

constexpr double NoiseLevels[] = { 0.01, 0.05, 0.1 };

std::string textOf(const CriticalCounts& counts)
{
  return std::to_string(counts.minima) + "/" + std::to_string(counts.maxima) + "/" +
    std::to_string(counts.saddles);
}

/// A way to smooth, for comparison.
struct Way
{
  const char* name;
  SmoothingParameters parameters;
};

std::vector<Way> waysToCompare()
{
  Way preserving{ "FeaturePreserving", {} };
  Way tikhonov{ "Tikhonov", {} };
  tikhonov.parameters.method = SmoothingMethod::Tikhonov;
  Way papersInterpolation{ "(6), harmonic, all critical points of f", {} };
  papersInterpolation.parameters.method = SmoothingMethod::InterpolatingConstraints;
  papersInterpolation.parameters.constraints = ConstraintChoice::AllCriticalPoints;
  papersInterpolation.parameters.norms.energy = SmoothingEnergy::Harmonic;
  papersInterpolation.parameters.smoothedStars = false;
  Way interpolation{ "(6), biharmonic, persistent", {} };
  interpolation.parameters.method = SmoothingMethod::InterpolatingConstraints;
  Way papersLeastSquares{ "(7), all critical points of f", papersInterpolation.parameters };
  papersLeastSquares.parameters.method = SmoothingMethod::LeastSquaresConstraints;
  papersLeastSquares.parameters.norms.energy = SmoothingEnergy::Biharmonic;
  Way leastSquares{ "(7), persistent", {} };
  leastSquares.parameters.method = SmoothingMethod::LeastSquaresConstraints;
  return { preserving, tikhonov, papersInterpolation, interpolation, papersLeastSquares,
    leastSquares };
}

SmoothedFunction smooth(const SmoothingCase& smoothingCase, const SmoothingMesh& mesh,
  const ValuesRef& noisy, SmoothingParameters parameters)
{
  const double noisyRange = noisy.maxCoeff() - noisy.minCoeff();
  parameters.persistenceThreshold = smoothingCase.threshold * smoothingCase.range / noisyRange;
  return smoothFunction(mesh, noisy, parameters);
}

/// How often the promise is kept if only the noise differs.
struct Repetitions
{
  int right = 0;         ///< exactly the features, by brute force; nothing called lost
  int near = 0;          ///< and each within the smoothing length
  double farthest = 0.0; ///< in smoothing lengths

  void add(const SmoothedFunction& result, const SmoothingScore& score, double length)
  {
    const bool isRight = score.hasFeatures && result.lost.empty() &&
      textOf(score.counts) == textOf(result.outputCounts);
    this->right += isRight ? 1 : 0;
    this->near += isRight && score.largestDistance <= length ? 1 : 0;
    this->farthest = std::max(this->farthest, score.largestDistance / length);
  }
};

/// A row of each table of one case with one noise.
class Comparison
{
public:
  Comparison(const SmoothingCase& smoothingCase, const SmoothingMesh& mesh, double noise)
    : case_(smoothingCase)
    , mesh_(mesh)
    , noise_(noise)
    , values_(smoothingCase.noisy(noise, Seeds[0]))
    , result_(smooth(smoothingCase, mesh, this->values_, {}))
  {
  }

  std::vector<std::string> promise(MarkdownReport& report, const Bound& bound) const
  {
    const SmoothingScore score = scoreOf(this->case_, this->result_.values);
    const double length = this->mesh_.smoother({}).smoothingLength(this->result_.epsilon);
    Repetitions repetitions;
    repetitions.add(this->result_, score, length);
    for (int i = 1; i < bound.repetitions; ++i)
    {
      const SmoothedFunction again = smooth(
        this->case_, this->mesh_, this->case_.noisy(this->noise_, Seeds[i]), this->known({}));
      repetitions.add(again, scoreOf(this->case_, again.values), length);
    }
    std::vector<std::string> row = this->head();
    row.insert(row.end(),
      { textOf(this->result_.inputCounts), textOf(this->case_.counts), textOf(score.counts),
        number("%.3f", length), number("%.2f", score.largestDistance / length),
        ofAll(repetitions.right, bound.repetitions), ofAll(repetitions.near, bound.repetitions),
        number("%.2f", repetitions.farthest),
        report.kept(repetitions.right == bound.repetitions &&
          repetitions.farthest <= bound.largestDistance) });
    return row;
  }

  /// Counts and errors of all ways.
  std::array<std::vector<std::string>, 3> rows() const
  {
    std::array<std::vector<std::string>, 3> result{ this->head(), this->head(), this->head() };
    const auto add = [&](const ValuesRef& values, const std::string& remark)
    {
      const SmoothingScore score = scoreOf(this->case_, values);
      result[0].push_back(textOf(score.counts) + remark);
      result[1].push_back(number("%.4f", score.meanSquareError));
      result[2].push_back(number("%.4f", score.largestError));
    };
    add(this->case_.clean, "");
    add(this->values_, "");
    for (const Way& way : waysToCompare())
    {
      add(smooth(this->case_, this->mesh_, this->values_, this->known(way.parameters)).values, "");
    }
    const Averaged averaged = bestAverage(this->case_, this->values_);
    add(averaged.values, " (k " + std::to_string(averaged.times) + ")");
    return result;
  }

private:
  std::vector<std::string> head() const
  {
    return { this->case_.name, number("%g%%", 100.0 * this->noise_) };
  }

  /// With the epsilon of cross-validation.
  SmoothingParameters known(SmoothingParameters parameters) const
  {
    parameters.epsilonChoice = EpsilonChoice::Manual;
    parameters.epsilon = this->result_.epsilon;
    return parameters;
  }

  const SmoothingCase& case_;
  const SmoothingMesh& mesh_;
  double noise_;
  Values values_;
  SmoothedFunction result_; ///< FeaturePreserving
};

using Table = std::vector<std::vector<std::string>>;

void print(const MarkdownReport& report, const std::string& title,
  const std::vector<std::string>& columns, const Table& table)
{
  report.head(title, columns);
  for (const std::vector<std::string>& row : table)
  {
    report.row(row);
  }
}

} // namespace

// usage: surface-scalars-smoothing-truth [reduced] [compare] [meshes FOLDER]
int main(int argc, char** argv)
{
  const Arguments arguments(argc, argv, { "compare" }, { "meshes" });
  const bool isReduced = arguments.isReduced();
  MarkdownReport report;
  Table cases;
  Table promises;
  std::array<Table, 3> comparisons;
  for (const SmoothingCase& smoothingCase :
    smoothingCases(arguments.valueOf("meshes"), isReduced ? 1 : 2))
  {
    cases.push_back({ smoothingCase.name, smoothingCase.functionName,
      std::to_string(smoothingCase.mesh.points.cols()),
      std::to_string(smoothingCase.mesh.eulerCharacteristic()),
      number("%.3f", smoothingCase.gap.first), number("%.3f", smoothingCase.threshold),
      number("%.3f", smoothingCase.gap.second), textOf(smoothingCase.counts) });
    const SmoothingMesh mesh(smoothingCase.mesh.points, trianglesOf(smoothingCase.mesh));
    for (const double noise : NoiseLevels)
    {
      const Comparison comparison(smoothingCase, mesh, noise);
      promises.push_back(comparison.promise(report, isReduced ? ReducedBound : FullBound));
      std::fprintf(stderr, "%s, noise %g\n", smoothingCase.name.c_str(), noise);
      if (arguments.has("compare"))
      {
        const auto rows = comparison.rows();
        for (std::size_t i = 0; i < rows.size(); ++i)
        {
          comparisons[i].push_back(rows[i]);
        }
      }
    }
  }
  print(report, "The functions",
    { "mesh", "function", "vertices", "χ", "largest persistence below", "threshold",
      "smallest above", "features m/M/s" },
    cases);
  print(report, "The promise",
    { "mesh", "noise", "noisy m/M/s", "features m/M/s", "result m/M/s", "smoothing length",
      "farthest", "right", "and near", "farthest of all", "kept" },
    promises);
  if (!comparisons[0].empty())
  {
    std::vector<std::string> columns{ "mesh", "noise", "clean", "noisy" };
    for (const Way& way : waysToCompare())
    {
      columns.emplace_back(way.name);
    }
    columns.emplace_back("best average");
    print(report, "Critical points m/M/s", columns, comparisons[0]);
    print(report, "L2 error, of the range", columns, comparisons[1]);
    print(report, "L∞ error, of the range", columns, comparisons[2]);
  }
  return report.exitCode();
}
