#include "CriticalTable.h"

#include "CriticalScore.h"
#include "DescentWays.h"
#include "Functions.h"
#include "FuzzyCriticalPoints.h"
#include "Sampling.h"

#include <algorithm>
#include <cmath>

namespace SurfaceScalars::Truth
{
namespace
{

constexpr int SampleCount = 2000;

/// A function on the square |x|, |y| <= halfWidth, and where its gradient vanishes.
struct PlanarCase
{
  SpaceFunction function; ///< without gradient
  double halfWidth;
  std::vector<CriticalPoint> exact;
};

CriticalPoint planarPoint(double x, double y, CriticalType type)
{
  CriticalPoint point;
  point.position = Vector3d(x, y, 0.0);
  point.type = type;
  return point;
}

// The first two: Fig. 17 of the point-set paper asks for a function whose only critical point is
// the origin, and does not say which it took. The last: Fig. 13 of the design paper.
std::vector<PlanarCase> planarCases()
{
  const auto square = [](const Vector3d& p) { return p.squaredNorm(); };
  const double half = std::sqrt(0.5);
  return { { { "exp(-x^2 - y^2)", [=](const Vector3d& p) { return std::exp(-square(p)); }, {} },
             0.5, { planarPoint(0.0, 0.0, CriticalType::Maximum) } },
    { { "sin x sin y", [](const Vector3d& p) { return std::sin(p.x()) * std::sin(p.y()); }, {} },
      0.5, { planarPoint(0.0, 0.0, CriticalType::Saddle) } },
    { { "x exp(-x^2 - y^2)", [=](const Vector3d& p) { return p.x() * std::exp(-square(p)); }, {} },
      2.0,
      { planarPoint(-half, 0.0, CriticalType::Minimum),
        planarPoint(half, 0.0, CriticalType::Maximum) } } };
}

struct PlanarSamples
{
  Points points;
  Values values;

  PlanarSamples(const PlanarCase& planarCase, double noise)
    : points(planarCase.halfWidth * randomPlane(SampleCount, 1))
    , values(valuesOf(planarCase.function, points))
  {
    addNoise(this->values, noise * (this->values.maxCoeff() - this->values.minCoeff()), 2);
  }
};

struct Contestant
{
  const char* name;
  Scheme scheme;
  KernelType kernel;
  double width;          ///< of the kernel, in half widths of the square
  double regularization; ///< with noise
};

const std::vector<Contestant> Contestants{ { "ExplicitMLS, h = 0.2 of the half width",
                                             Scheme::ExplicitMLS, KernelType::Gaussian, 0.2, 0.0 },
  { "GlobalRBF, Gaussian", Scheme::GlobalRBF, KernelType::Gaussian, 0.5, 1.0 } };

FieldParameters parametersOf(const Contestant& contestant, double halfWidth, double noise)
{
  FieldParameters parameters;
  parameters.scheme = contestant.scheme;
  parameters.kernel = contestant.kernel;
  parameters.kernelWidth = contestant.width * halfWidth;
  parameters.searchRadius =
    contestant.scheme == Scheme::ExplicitMLS ? 6.0 * parameters.kernelWidth : 0.0;
  parameters.regularization = noise > 0.0 ? contestant.regularization : 1e-8; // nearly none
  return parameters;
}

/// Of the starts that converge within a tenth of the half width of an exact point: how many, how
/// far their ends are apart, and from the exact point.
void reportWays(
  MarkdownReport& report, const PlanarCase& planarCase, double noise, const Contestant& contestant)
{
  const PlanarSamples samples(planarCase, noise);
  const Field field = Field::fit(
    samples.points, samples.values, parametersOf(contestant, planarCase.halfWidth, noise));
  const std::vector<Way> ways = followFromRandomStarts(field, planarCase.halfWidth, 100);
  for (const CriticalPoint& exact : planarCase.exact)
  {
    std::vector<Way> near;
    std::copy_if(ways.begin(), ways.end(), std::back_inserter(near),
      [&](const Way& way)
      {
        const double distance = (way.end - exact.position.head<2>()).norm();
        return way.converged() && distance < 0.2 * planarCase.halfWidth;
      });
    if (near.empty())
    {
      report.row({ planarCase.function.name, number("%g%%", 100.0 * noise), contestant.name, "0",
        "", "", "", "" });
      continue;
    }
    double spread = 0.0;
    double largestGradient = 0.0;
    std::size_t iterations = 0;
    for (const Way& way : near)
    {
      spread = std::max(spread, (way.end - near.front().end).norm());
      largestGradient = std::max(largestGradient, way.gradients.back());
      iterations = std::max(iterations, way.gradients.size() - 1);
    }
    report.row({ planarCase.function.name, number("%g%%", 100.0 * noise), contestant.name,
      std::to_string(near.size()), number("%.0e", spread), number("%.0e", largestGradient),
      std::to_string(iterations),
      number("%.5f", (near.front().end - exact.position.head<2>()).norm()) });
  }
}

void reportFound(MarkdownReport& report, const PlanarCase& planarCase, double noise)
{
  const PlanarSamples samples(planarCase, noise);
  const NeighborGraph graph(samples.points, NeighborQuery());
  const FuzzyCriticalPoints found = findCriticalPoints(graph, graph.average(samples.values), {});
  const CriticalScore score =
    scoreCriticalPoints(found.points, planarCase.exact, 0.2 * planarCase.halfWidth);
  double residual = 0.0;
  for (const CriticalPoint& point : found.points)
  {
    residual = std::max(residual, point.residual);
  }
  report.row({ planarCase.function.name, number("%g%%", 100.0 * noise),
    std::to_string(found.neighborCount), number("%.2f", score.precision()),
    number("%.2f", score.recall()), number("%.5f", score.errorMaximum),
    number("%.2f", score.errorMaximum / graph.medianSamplingStep()), number("%.0e", residual) });
}

/// The design paper's Table 3: |grad F| on the ways from the first starts that lead to a critical
/// point.
void reportSteps(MarkdownReport& report)
{
  const PlanarCase planarCase = planarCases().back();
  const PlanarSamples samples(planarCase, 0.1);
  const Field field = Field::fit(
    samples.points, samples.values, parametersOf(Contestants.back(), planarCase.halfWidth, 0.1));
  std::vector<Way> ways = followFromRandomStarts(field, planarCase.halfWidth, 100);
  ways.erase(
    std::remove_if(ways.begin(), ways.end(), [](const Way& way) { return !way.converged(); }),
    ways.end());
  ways.resize(std::min<std::size_t>(ways.size(), 4));
  report.head("Norm of the gradient on the ways from four starts, " + planarCase.function.name +
      " with 10% noise, " + Contestants.back().name,
    { "step", "1", "2", "3", "4" });
  bool goesOn = true;
  for (std::size_t step = 0; goesOn; ++step)
  {
    std::vector<std::string> row{ std::to_string(step) };
    goesOn = false;
    for (const Way& way : ways)
    {
      const bool isOnWay = step < way.gradients.size();
      row.push_back(isOnWay ? number("%.1e", way.gradients[step]) : "");
      goesOn = goesOn || step + 1 < way.gradients.size();
    }
    report.row(row);
  }
}

} // namespace

void reportStarts(MarkdownReport& report)
{
  const std::vector<double> noises{ 0.0, 0.01, 0.1 };
  report.head("Newton's method with a trust region from 100 random starts, 2000 samples",
    { "function", "noise on f", "F", "starts that end there", "distance between ends",
      "largest gradient", "most steps", "distance from the exact point" });
  for (const PlanarCase& planarCase : planarCases())
  {
    for (const double noise : noises)
    {
      for (const Contestant& contestant : Contestants)
      {
        reportWays(report, planarCase, noise, contestant);
      }
    }
  }
  report.head("Fuzzy Critical Points on the same samples",
    { "function", "noise on f", "k", "precision", "recall", "error", "in steps", "residual" });
  for (const PlanarCase& planarCase : planarCases())
  {
    for (const double noise : noises)
    {
      reportFound(report, planarCase, noise);
    }
  }
  reportSteps(report);
}

} // namespace SurfaceScalars::Truth
