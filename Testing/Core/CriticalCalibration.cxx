#include "CriticalTable.h"

#include "CriticalRun.h"
#include "Torus.h"

#include <algorithm>
#include <cmath>

namespace SurfaceScalars::Truth
{
namespace
{

constexpr double Probable = 0.1; ///< the stated probability from which a sample counts as critical

/// The same case with a sample at every critical point, after all others.
CriticalCase withSamplesAtCriticalPoints(CriticalCase criticalCase)
{
  const auto sample = criticalCase.surface.sample;
  const auto exact = criticalCase.exact;
  criticalCase.surface.sample = [=](int count, unsigned seed)
  {
    Points points(3, count + static_cast<int>(exact.size()));
    points.leftCols(count) = sample(count, seed);
    for (std::size_t i = 0; i < exact.size(); ++i)
    {
      points.col(count + static_cast<Eigen::Index>(i)) = exact[i].position;
    }
    return points;
  };
  return criticalCase;
}

/// What many repetitions say about CriticalProbability.
struct Calibration
{
  CriticalScore score;            ///< errors as lengths
  std::vector<double> atCritical; ///< probabilities of samples at critical points
  std::vector<double> nearest;    ///< of the other samples nearest to critical points
  std::vector<float> distances;   ///< of every sample from its nearest critical point
  std::vector<char> isProbable;   ///< whether its probability exceeds `Probable`
};

/// Index and distance of the column nearest to a place.
std::pair<Eigen::Index, double> nearestColumn(const PointsRef& points, const Vector3d& place)
{
  Eigen::Index nearest = 0;
  const double squared = (points.colwise() - place).colwise().squaredNorm().minCoeff(&nearest);
  return { nearest, std::sqrt(squared) };
}

void repeat(Calibration& all, const CriticalCase& criticalCase, const TruthSampling& sampling)
{
  const CriticalSamples samples(criticalCase, sampling);
  const NeighborGraph graph(samples.points, NeighborQuery());
  const FuzzyCriticalPoints found = findCriticalPoints(graph, graph.average(samples.values), {});
  all.score.add(
    scoreCriticalPoints(found.points, criticalCase.exact, unambiguousRadius(criticalCase.exact)));

  // A sample stands for the place on the surface that is closest to it.
  Points places = samples.points;
  for (Eigen::Index i = 0; i < places.cols(); ++i)
  {
    places.col(i) = torusPoint(torusAngles(places.col(i)));
  }
  const auto probability = [&](Eigen::Index i)
  { return found.samples.probability[graph.pointOfInput(static_cast<std::size_t>(i))]; };
  Values distances = Values::Constant(places.cols(), std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < criticalCase.exact.size(); ++i)
  {
    const Vector3d& place = criticalCase.exact[i].position;
    const auto at = sampling.pointCount + static_cast<Eigen::Index>(i);
    all.atCritical.push_back(probability(at));
    all.nearest.push_back(
      probability(nearestColumn(places.leftCols(sampling.pointCount), place).first));
    distances = distances.cwiseMin((places.colwise() - place).colwise().norm().transpose());
  }
  for (Eigen::Index i = 0; i < places.cols(); ++i)
  {
    all.distances.push_back(static_cast<float>(distances[i]));
    all.isProbable.push_back(probability(i) > Probable ? 1 : 0);
  }
}

double share(const std::vector<double>& probabilities, double largest)
{
  const auto count = std::count_if(probabilities.begin(), probabilities.end(),
    [=](double probability) { return probability <= largest; });
  return static_cast<double>(count) / static_cast<double>(probabilities.size());
}

/// Of the samples farther than this from every critical point, the share that is probable.
double falseShare(const Calibration& calibration, double distance)
{
  std::size_t far = 0;
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < calibration.distances.size(); ++i)
  {
    if (calibration.distances[i] > distance)
    {
      ++far;
      wrong += calibration.isProbable[i] != 0 ? 1 : 0;
    }
  }
  return static_cast<double>(wrong) / static_cast<double>(far);
}

struct Curve
{
  std::string name;
  std::vector<double> probabilities;
};

void writeCurves(const std::vector<Curve>& curves, const std::string& fileName)
{
  std::FILE* file = std::fopen(fileName.c_str(), "w");
  if (file == nullptr)
  {
    throw std::runtime_error("cannot write " + fileName);
  }
  std::fprintf(file, "stated");
  for (const Curve& curve : curves)
  {
    std::fprintf(file, ",%s", curve.name.c_str());
  }
  for (int percent = 0; percent <= 100; percent += 2)
  {
    std::fprintf(file, "\n%.2f", 0.01 * percent);
    for (const Curve& curve : curves)
    {
      std::fprintf(file, ",%.4f", share(curve.probabilities, 0.01 * percent));
    }
  }
  std::fprintf(file, "\n");
  std::fclose(file);
}

struct Noise
{
  const char* name;
  double onPoints;
  double onValues;
};

} // namespace

void reportCalibration(MarkdownReport& report, bool reduced, const std::string& curveFile)
{
  const unsigned repetitions = reduced ? 20 : 200;
  report.head(
    "CriticalProbability in " + std::to_string(repetitions) + " repetitions, 20000 points",
    { "function", "noise", "precision", "recall", "position error in steps",
      "at critical points > 0.1", "nearest sample > 0.1", "kept", "others > 0.1", "kept" });
  std::vector<Curve> curves;
  for (const SpaceFunction& function : { tiltedHeight(), cosinesOfAngles() })
  {
    const CriticalCase criticalCase =
      withSamplesAtCriticalPoints(CriticalCase(closedTorus(), function));
    for (const Noise& noise :
      { Noise{ "none", 0.0, 0.0 }, Noise{ "1% on f", 0.0, 0.01 }, Noise{ "5% on f", 0.0, 0.05 },
        Noise{ "1% on points", 0.01, 0.0 }, Noise{ "1% on both", 0.01, 0.01 } })
    {
      Calibration all;
      for (unsigned seed = 1; seed <= repetitions; ++seed)
      {
        repeat(all, criticalCase, { 20000, seed, noise.onPoints, noise.onValues });
      }
      const double step = CriticalSamples(criticalCase, { 20000 }).samplingStep;
      const double error = all.score.rootMeanSquareError();
      const double nearest = 1.0 - share(all.nearest, Probable);
      const double others = falseShare(all, 5.0 * error);
      const bool staysCritical = noise.onPoints == 0.0; // what was put at a critical point
      report.row({ function.name, noise.name, number("%.3f", all.score.precision()),
        number("%.3f", all.score.recall()), number("%.3f", error / step),
        staysCritical ? number("%.3f", 1.0 - share(all.atCritical, Probable)) : "",
        number("%.3f", nearest), report.kept(nearest >= 0.9), number("%.4f", others),
        report.kept(others < 0.01) });
      const std::string name = function.name + "; " + noise.name;
      if (staysCritical)
      {
        curves.push_back({ name + "; at critical points", all.atCritical });
      }
      curves.push_back({ name + "; nearest samples", all.nearest });
    }
  }
  if (!curveFile.empty())
  {
    writeCurves(curves, curveFile);
  }
}

} // namespace SurfaceScalars::Truth
