#include "SmoothingRun.h"

#include "Meshes.h"
#include "Sampling.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace SurfaceScalars::Truth
{
namespace
{

bool isExtremum(const CriticalPoint& point)
{
  return point.type == CriticalType::Minimum || point.type == CriticalType::Maximum;
}

/// From each feature to an extremum of its type, which no other has; the nearest are joined first.
double largestDistance(
  const std::vector<CriticalPoint>& features, const std::vector<CriticalPoint>& found)
{
  struct Candidate
  {
    double distance;
    std::size_t feature;
    std::size_t found;
  };
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < features.size(); ++i)
  {
    for (std::size_t j = 0; j < found.size(); ++j)
    {
      if (features[i].type == found[j].type)
      {
        candidates.push_back({ (features[i].position - found[j].position).norm(), i, j });
      }
    }
  }
  std::sort(candidates.begin(), candidates.end(),
    [](const Candidate& a, const Candidate& b) { return a.distance < b.distance; });
  std::vector<char> isJoined(features.size(), 0);
  std::vector<char> isTaken(found.size(), 0);
  std::size_t joined = 0;
  double largest = 0.0;
  for (const Candidate& candidate : candidates)
  {
    if (isJoined[candidate.feature] == 0 && isTaken[candidate.found] == 0)
    {
      isJoined[candidate.feature] = isTaken[candidate.found] = 1;
      largest = candidate.distance; // they ascend
      ++joined;
    }
  }
  return joined == features.size() ? largest : std::numeric_limits<double>::infinity();
}

SpaceFunction longWaves()
{
  return { "sin 3x cos 2y + 0.3 z",
    [](const Vector3d& p) { return std::sin(3.0 * p.x()) * std::cos(2.0 * p.y()) + 0.3 * p.z(); },
    {} };
}

SpaceFunction slantedHeight()
{
  return { "0.22 x + 0.52 y + 0.82 z",
    [](const Vector3d& p) { return p.dot(Vector3d(0.22, 0.52, 0.82)); }, {} };
}

Values averaged(const TriangleMesh& mesh, const Values& values)
{
  // An edge between two triangles adds its ends twice to each other, one on the boundary once.
  Values sums = 2.0 * values;
  Values counts = Values::Constant(values.size(), 2.0);
  for (const std::array<int, 3>& triangle : mesh.triangles)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const int a = triangle[i];
      const int b = triangle[(i + 1) % 3];
      sums[a] += values[b];
      sums[b] += values[a];
      counts[a] += 1.0;
      counts[b] += 1.0;
    }
  }
  return sums.cwiseQuotient(counts);
}

} // namespace

SpaceFunction waves()
{
  return { "sin 5x cos 4y + 0.3 z",
    [](const Vector3d& p) { return std::sin(5.0 * p.x()) * std::cos(4.0 * p.y()) + 0.3 * p.z(); },
    [](const Vector3d& p)
    {
      return Vector3d(5.0 * std::cos(5.0 * p.x()) * std::cos(4.0 * p.y()),
        -4.0 * std::sin(5.0 * p.x()) * std::sin(4.0 * p.y()), 0.3);
    } };
}

SmoothingCase::SmoothingCase(
  std::string caseName, TriangleMesh onMesh, const SpaceFunction& function, double leastPersistence)
  : name(std::move(caseName))
  , functionName(function.name)
  , mesh(std::move(onMesh))
  , clean(valuesOf(function, this->mesh.points))
  , range(this->clean.maxCoeff() - this->clean.minCoeff())
  , threshold(leastPersistence)
  , gap(0.0, std::numeric_limits<double>::infinity())
{
  for (const CriticalPoint& point : meshCriticalPoints(this->mesh, this->clean))
  {
    const double persistence = point.persistence / this->range;
    if (isExtremum(point) && persistence >= this->threshold)
    {
      this->gap.second = std::min(this->gap.second, persistence);
      this->features.push_back(point);
    }
    else if (isExtremum(point))
    {
      this->gap.first = std::max(this->gap.first, persistence);
    }
  }
  this->counts = countsOf(this->features);
  this->counts.saddles =
    static_cast<Index>(static_cast<int>(this->features.size()) - this->mesh.eulerCharacteristic());
}

Values SmoothingCase::noisy(double noise, unsigned seed) const
{
  Values values = this->clean;
  addNoise(values, noise * this->range, seed);
  return values;
}

std::vector<SmoothingCase> smoothingCases(const std::string& folder, int fineness)
{
  std::vector<SmoothingCase> cases;
  cases.emplace_back("sphere", subdividedSphere(5 + fineness), waves(), 0.06);
  cases.emplace_back(
    "torus", gridMesh(Grid::Torus, 140 * fineness, 70 * fineness), cosinesOfAngles(), 0.2);
  if (!folder.empty())
  {
    const auto read = [&](const char* name) { return readCentered(folder + "/" + name + ".off"); };
    cases.emplace_back("refined_elephant", read("refined_elephant"), waves(), 0.08);
    cases.emplace_back("bunny00", read("bunny00"), longWaves(), 0.04);
    cases.emplace_back("camel", read("camel"), slantedHeight(), 0.056);
  }
  return cases;
}

SmoothingScore scoreOf(const SmoothingCase& smoothingCase, const ValuesRef& values)
{
  const std::vector<CriticalPoint> found = meshCriticalPoints(smoothingCase.mesh, values);
  const CriticalCounts& expected = smoothingCase.counts;
  SmoothingScore score;
  score.counts = countsOf(found);
  score.hasFeatures = score.counts.minima == expected.minima &&
    score.counts.saddles == expected.saddles && score.counts.maxima == expected.maxima;
  score.largestDistance = largestDistance(smoothingCase.features, found);
  const Values errors = (values - smoothingCase.clean) / smoothingCase.range;
  score.meanSquareError = errors.norm() / std::sqrt(static_cast<double>(errors.size()));
  score.largestError = errors.lpNorm<Eigen::Infinity>();
  return score;
}

Averaged bestAverage(const SmoothingCase& smoothingCase, const ValuesRef& values)
{
  constexpr double Enough = 1.2; // times the best: it gets no better any more
  Averaged best{ values, 0 };
  double least = (values - smoothingCase.clean).norm();
  Values current = values;
  double error = least;
  for (int times = 1; error < Enough * least; ++times)
  {
    current = averaged(smoothingCase.mesh, current);
    error = (current - smoothingCase.clean).norm();
    if (error < least)
    {
      least = error;
      best = { current, times };
    }
  }
  return best;
}

} // namespace SurfaceScalars::Truth
