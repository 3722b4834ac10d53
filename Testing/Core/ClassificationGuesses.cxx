#include "ClassificationGuesses.h"

#include "CriticalScore.h"
#include "ModelCases.h"
#include "SurfaceNewton.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace SurfaceScalars::Truth
{
namespace
{

/// A function on [-2, 2]^2 and how it is sampled and approximated.
struct PlanarCase
{
  std::string name;
  std::function<double(const Vector3d&)> function;
  double noise; ///< standard deviation, in the range of the samples
};

double bump(const Vector3d& p)
{
  return p.x() * std::exp(-p.squaredNorm());
}

/// Hills and hollows with nine critical points in the square.
double peaks(const Vector3d& p)
{
  const double x = p.x();
  const double y = p.y();
  return 3.0 * (1.0 - x) * (1.0 - x) * std::exp(-x * x - (y + 1.0) * (y + 1.0)) -
    10.0 * (x / 5.0 - x * x * x - std::pow(y, 5)) * std::exp(-x * x - y * y) -
    std::exp(-(x + 1.0) * (x + 1.0) - y * y) / 3.0;
}

std::vector<PlanarCase> planarCases()
{
  std::vector<PlanarCase> cases;
  for (const double noise : { 0.0, 0.01, 0.05 })
  {
    cases.push_back({ "x exp(-x^2 - y^2)", bump, noise });
    cases.push_back({ "peaks", peaks, noise });
  }
  return cases;
}

constexpr int PlanarSamples = 600;

Field approximate(const PlanarCase& one)
{
  Points centers = randomPlane(PlanarSamples, 7);
  centers *= 2.0;
  Values values = valuesOf(one.function, centers);
  addNoise(values, one.noise * (values.maxCoeff() - values.minCoeff()), 11);
  FieldParameters parameters;
  parameters.scheme = Scheme::GlobalRBF;
  parameters.kernel = KernelType::Gaussian;
  parameters.kernelWidth = 0.8;
  parameters.regularization = one.noise > 0.0 ? 0.3 : 1e-8;
  return Field::fit(centers, values, parameters);
}

/// As a function with a gradient by differences, for finding critical points of f itself.
SpaceFunction withDifferences(const std::function<double(const Vector3d&)>& function)
{
  const auto gradient = [=](const Vector3d& p) -> Vector3d
  {
    Vector3d result;
    for (int axis = 0; axis < 3; ++axis)
    {
      const Vector3d shift = 1e-4 * Vector3d::Unit(axis);
      result[axis] = (8.0 * (function(p + shift) - function(p - shift)) -
                       function(p + 2.0 * shift) + function(p - 2.0 * shift)) /
        12e-4;
    }
    return result;
  };
  return { "f", function, gradient };
}

/// The nearest of these and how far it is.
std::pair<std::size_t, double> nearest(const std::vector<CriticalPoint>& points, const Vector3d& p)
{
  std::pair<std::size_t, double> result{ 0, std::numeric_limits<double>::infinity() };
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const double distance = (points[i].position - p).norm();
    if (distance < result.second)
    {
      result = { i, distance };
    }
  }
  return result;
}

/// Searches in the plane from random places.
struct GuessRun
{
  int count = 0;
  int converged = 0;
  int left = 0;  ///< the square
  int wrong = 0; ///< converged where no critical point is known
  int stalled = 0;
  int mostSteps = 0;
  double stepSum = 0.0;
  std::vector<int> hits; ///< of each known point

  void add(const SurfaceSearch& search, const std::vector<CriticalPoint>& exact)
  {
    ++this->count;
    this->hits.resize(exact.size());
    if (!search.isOnMesh)
    {
      ++this->left;
    }
    else if (!search.isCritical)
    {
      ++this->stalled;
    }
    else if (nearest(exact, search.place).second > 1e-6)
    {
      ++this->wrong;
    }
    else
    {
      ++this->converged;
      ++this->hits[nearest(exact, search.place).first];
      this->stepSum += search.stepCount();
      this->mostSteps = std::max(this->mostSteps, search.stepCount());
    }
  }
};

struct Guess
{
  Vector3d place;
  Index vertex; ///< the nearest
};

std::vector<Guess> randomGuesses(const Mesh& mesh, int count)
{
  Points places = randomPlane(count, 23);
  places *= 2.0;
  std::vector<Guess> guesses;
  for (const auto place : places.colwise())
  {
    Eigen::Index vertex = 0;
    (mesh.vertices.colwise() - place).colwise().squaredNorm().minCoeff(&vertex);
    guesses.push_back({ place, static_cast<Index>(vertex) });
  }
  return guesses;
}

constexpr int SquareSize = 40;     // edges along a side
constexpr int MostGuessSteps = 50; // from places far from any critical point

/// A search for any critical point that goes on from chart to chart.
SurfaceSearch roam(SurfaceNewton& newton, const Guess& guess)
{
  SurfaceSearch whole;
  whole.place = guess.place;
  whole.vertex = guess.vertex;
  do
  {
    newton.enter(whole.vertex);
    SurfaceSearch part = newton.search(
      whole.place, CriticalType::Uncertain, { MostGuessSteps - whole.stepCount(), true });
    part.evaluations += whole.evaluations;
    if (!whole.residuals.empty()) // the last of which the part begins with
    {
      part.residuals.insert(
        part.residuals.begin(), whole.residuals.begin(), whole.residuals.end() - 1);
    }
    whole = part;
  } while (!whole.isOnChart && whole.isOnMesh && whole.stepCount() < MostGuessSteps);
  return whole;
}

void reportShares(MarkdownReport& report, bool isReduced)
{
  const Mesh mesh = planarSquare(SquareSize);
  const MeshTopology topology = topologyOf(mesh);
  const std::vector<Guess> guesses = randomGuesses(mesh, isReduced ? 100 : 1000);
  report.head("random guesses in [-2, 2]^2, u from " + std::to_string(PlanarSamples) +
      " samples: where searches for any critical point lead",
    { "function", "noise", "critical points of f", "of u", "largest distance", "converged",
      "to each", "left the square", "stalled", "elsewhere", "steps (mean, most)", "from vertices",
      "at most steps", "kept" });
  for (const PlanarCase& one : planarCases())
  {
    const Field u = approximate(one);
    const std::vector<CriticalPoint> exact = planarCriticalPoints(asFunction(u));
    const std::vector<CriticalPoint> ofFunction =
      planarCriticalPoints(withDifferences(one.function));
    double distance = 0.0;
    for (const CriticalPoint& point : ofFunction)
    {
      distance = std::max(distance, nearest(exact, point.position).second);
    }
    const Values values = u.evaluate(mesh.vertices, {}).values;
    const double scale = gradientScale(mesh.vertices, mesh.triangles, values);
    SurfaceNewton newton(mesh.vertices, topology, values, u, 1e-10 * scale);
    GuessRun run;
    for (const Guess& guess : guesses)
    {
      run.add(roam(newton, guess), exact);
    }
    std::string hits;
    for (const int hit : run.hits)
    {
      hits += (hits.empty() ? "" : " ") + std::to_string(hit);
    }
    const ModelRun fromVertices(mesh.vertices, topology, u);
    const auto isInside = [](const Vector3d& p) {
      return p.cwiseAbs().maxCoeff() < 2.0 - 8.0 / SquareSize;
    }; // two edges, for the boundary stays
    const CriticalScore score = scoreCriticalPoints(fromVertices.refined(), exact, 1e-6, isInside);
    const bool isKept = score.rightCount == score.exactCount &&
      score.foundCount == score.exactCount && fromVertices.mostSteps() <= 10 && run.wrong == 0;
    report.row({ one.name, number("%g", one.noise), std::to_string(ofFunction.size()),
      std::to_string(exact.size()), number("%.1e", distance), ofAll(run.converged, run.count), hits,
      std::to_string(run.left), std::to_string(run.stalled), std::to_string(run.wrong),
      number("%.1f", run.stepSum / run.converged) + ", " + std::to_string(run.mostSteps),
      ofAll(score.rightCount, score.exactCount) + ", " + std::to_string(score.foundCount) +
        " found",
      std::to_string(fromVertices.mostSteps()), report.kept(isKept) });
  }
}

/// Table 3: how the gradient vanishes from four guesses, down to rounding.
void reportIterations(const MarkdownReport& report)
{
  const Mesh mesh = planarSquare(SquareSize);
  const MeshTopology topology = topologyOf(mesh);
  for (const double noise : { 0.0, 0.01 })
  {
    const Field u = approximate({ "", peaks, noise });
    const Values values = u.evaluate(mesh.vertices, {}).values;
    SurfaceNewton newton(mesh.vertices, topology, values, u, 0.0);
    report.head("peaks, noise " + number("%g", noise) + ": norms of the gradient step by step",
      { "guess", "place", "evaluations", "gradient" });
    int shown = 0;
    for (const Guess& guess : randomGuesses(mesh, 40))
    {
      const SurfaceSearch search = roam(newton, guess);
      if (!search.isOnMesh || search.residuals.back() > 1e-9 || shown == 4)
      {
        continue;
      }
      ++shown;
      std::string norms;
      for (const double residual : search.residuals)
      {
        norms += (norms.empty() ? "" : ", ") + number("%.1e", residual);
      }
      const auto placeOf = [](const Vector3d& p)
      { return number("%.2f", p.x()) + ", " + number("%.2f", p.y()); };
      report.row(
        { placeOf(guess.place), placeOf(search.place), std::to_string(search.evaluations), norms });
    }
  }
}

} // namespace

void reportGuesses(MarkdownReport& report, bool isReduced)
{
  reportShares(report, isReduced);
  reportIterations(report);
}

} // namespace SurfaceScalars::Truth
