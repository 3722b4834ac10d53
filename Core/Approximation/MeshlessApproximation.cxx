#include "MeshlessApproximation.h"

#include "CenterSum.h"
#include "ConstantValues.h"
#include "FarthestPoints.h"
#include "FieldChecks.h"
#include "GlobalSystem.h"
#include "GreedyCenters.h"
#include "KernelWidth.h"
#include "LevelSetCenters.h"
#include "MinimaxValues.h"
#include "NumberText.h"
#include "Require.h"
#include "SeparatedStars.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace SurfaceScalars
{
namespace
{

constexpr double FewestFree = 4;           // centers beside the stars
constexpr Eigen::Index CentersPerStar = 4; // from which on accuracy is promised

FieldParameters fieldParametersOf(const ApproximationParameters& parameters)
{
  FieldParameters result;
  result.scheme = Scheme::GlobalRBF;
  result.kernel = parameters.kernel;
  result.kernelWidth = parameters.kernelWidth;
  result.regularization = parameters.regularization;
  return result;
}

void check(const ApproximationDomain& domain, const ValuesRef& values,
  const ApproximationParameters& parameters)
{
  checkFieldParameters(fieldParametersOf(parameters));
  checkFieldValues(values, static_cast<std::size_t>(domain.vertices.cols()));
  require(domain.vertices.cols() > 0 && domain.vertices.allFinite(), "vertices that are finite",
    domain.vertices.cols() > 0 ? "NaN or infinity" : "none", "Choose another input.");
  require(parameters.sampleFraction > 0.0 && parameters.sampleFraction <= 1.0,
    "a SampleFraction above 0, at most 1", textOf(parameters.sampleFraction),
    "Use 0.01 if in doubt.");
  require(parameters.persistenceThreshold >= 0.0 && parameters.persistenceThreshold <= 1.0,
    "a PersistenceThreshold from 0 to 1", textOf(parameters.persistenceThreshold),
    "Use 0 to keep all critical points.");
}

/// The vertices of the points and of their links, each place once.
std::vector<Index> starsOf(const ApproximationDomain& domain,
  const std::vector<CriticalPoint>& points, const Execution& execution)
{
  std::vector<Index> result;
  for (const CriticalPoint& point : points)
  {
    const auto vertex = static_cast<Index>(point.input);
    const std::vector<Index> link = domain.link(vertex);
    result.push_back(vertex);
    result.insert(result.end(), link.begin(), link.end());
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return distinctPlaces(domain.vertices, result, execution);
}

/// None if f is constant: what ties by index, or rounding, make critical is no feature of it.
void findPersistent(const ApproximationDomain& domain, const ValuesRef& values, double threshold,
  MeshlessApproximation& result, const Execution& execution)
{
  if (result.isConstant)
  {
    return;
  }
  MeshCriticalPoints critical = domain.criticalPoints(values, execution);
  const std::vector<CriticalPoint> all = critical.points;
  removeBelow(critical.points, critical.pairs, threshold * (values.maxCoeff() - values.minCoeff()));
  result.leftOut = all.size() - critical.points.size();
  auto next = all.begin();
  for (CriticalPoint& point : critical.points)
  {
    next = std::find_if(next, all.end(),
      [&](const CriticalPoint& other)
      { return other.input == point.input && other.type == point.type; });
    point.multiplicity = next->multiplicity; // it is the star that u has in common with f
  }
  result.persistent = std::move(critical.points);
}

std::size_t centerCount(MeshlessApproximation& result, const std::vector<Index>& stars,
  Eigen::Index vertexCount, double fraction)
{
  require(static_cast<double>(stars.size()) + FewestFree <= MostDenseCenters,
    "persistent critical points with at most " + std::to_string(MostDenseCenters) +
      " vertices in their stars",
    std::to_string(result.persistent.size()) + " with " + std::to_string(stars.size()),
    "Raise PersistenceThreshold.");
  const double free = std::max(FewestFree, std::round(fraction * static_cast<double>(vertexCount)));
  result.starCount = static_cast<Eigen::Index>(stars.size());
  result.askedCount = std::min(vertexCount, result.starCount + static_cast<Eigen::Index>(free));
  return std::min(static_cast<std::size_t>(result.askedCount), std::size_t(MostDenseCenters));
}

/// Through the values at stars, and through or near the others.
CenterSum fittedSum(const ApproximationDomain& domain, const ValuesRef& values,
  const std::vector<Index>& stars, std::size_t count, const ApproximationParameters& parameters,
  const Execution& execution)
{
  const auto dimension = static_cast<int>(domain.simplices.rows()) - 1;
  CenterSum sum(fieldParametersOf(parameters), dimension, values.minCoeff(), values.maxCoeff());
  const ChosenCenters chosen = parameters.centerSelection == CenterSelection::Greedy
    ? greedyCenters(domain.vertices, values, stars, count, dimension, sum, execution.part(0.0, 0.6))
    : levelSetCenters(
        domain, values, stars, count, parameters.coverageTolerance, execution.part(0.0, 0.6));
  if (parameters.levelSetConstraints == LevelSetConstraints::LeastSquares)
  {
    sum.approximate(chosen.centers, chosen.further, execution.part(0.6, 1.0));
  }
  else if (parameters.levelSetConstraints == LevelSetConstraints::Minimax)
  {
    minimizeLargestMiss(sum, chosen.centers, domain.vertices, values, execution.part(0.6, 1.0));
  }
  else
  {
    sum.interpolate(chosen.centers, execution.part(0.6, 1.0));
  }
  return sum;
}

/// What of f is critical in u, too, and what else is.
void compare(
  const ApproximationDomain& domain, MeshlessApproximation& result, const Execution& execution)
{
  result.critical = domain.criticalPoints(result.values, execution);
  const auto kindOf = [](const CriticalPoint& point)
  { return std::make_tuple(point.input, point.type, point.multiplicity); };
  const auto isBefore = [&](const CriticalPoint& a, const CriticalPoint& b)
  { return kindOf(a) < kindOf(b); };
  const auto isAmong = [&](const CriticalPoint& point, const std::vector<CriticalPoint>& sorted)
  { return std::binary_search(sorted.begin(), sorted.end(), point, isBefore); };
  std::vector<CriticalPoint> asked = result.persistent;
  std::vector<CriticalPoint> found = result.critical.points;
  std::sort(asked.begin(), asked.end(), isBefore);
  std::sort(found.begin(), found.end(), isBefore);
  for (const CriticalPoint& point : result.critical.points)
  {
    result.prescribed.push_back(isAmong(point, asked) ? 1 : 0);
  }
  for (std::size_t i = 0; i < result.persistent.size(); ++i)
  {
    if (!isAmong(result.persistent[i], found))
    {
      result.lost.push_back(i);
    }
  }
}

} // namespace

MeshlessApproximation approximateMeshless(const ApproximationDomain& domain,
  const ValuesRef& values, const ApproximationParameters& parameters, const Execution& execution)
{
  check(domain, values, parameters);
  MeshlessApproximation result;
  result.isConstant = areConstant(values);
  findPersistent(domain, values, parameters.persistenceThreshold, result, execution.part(0.0, 0.1));
  const std::vector<Index> stars = starsOf(domain, result.persistent, execution.part(0.1, 0.1));
  const std::size_t count = centerCount(result, stars, values.size(), parameters.sampleFraction);

  const CenterSum sum = fittedSum(domain, withSeparatedStars(domain, values, result.persistent),
    stars, count, parameters, execution.part(0.1, 0.8));
  result.model = sum.model();
  result.condition = sum.condition();
  result.widthRemark = remarkOnWidth(
    fieldParametersOf(parameters), PointCloud(result.model.centers, execution.part(0.8, 0.8)));
  result.values = sum.at(domain.vertices, execution.part(0.8, result.isConstant ? 1.0 : 0.95));
  const Values misses = (result.values - values).cwiseAbs();
  result.largestError = misses.maxCoeff();
  result.meanError = misses.mean();
  if (!result.isConstant)
  {
    compare(domain, result, execution.part(0.95, 1.0));
  }
  return result;
}

std::vector<std::string> remarksOn(const MeshlessApproximation& result)
{
  std::vector<std::string> remarks;
  if (result.isConstant)
  {
    remarks.push_back("the function is " + textOf(result.model.lowest) +
      " everywhere, so that a few centers are enough and none is critical.");
  }
  const Eigen::Index count = std::min<Eigen::Index>(result.askedCount, MostDenseCenters);
  if (result.askedCount > MostDenseCenters)
  {
    remarks.push_back("SampleFraction asks for " + std::to_string(result.askedCount) +
      " centers, of which " + std::to_string(MostDenseCenters) +
      " are the most that a dense system can have: lower it to keep this sentence away.");
  }
  if (count < CentersPerStar * result.starCount)
  {
    remarks.push_back(std::to_string(result.starCount) + " of " + std::to_string(count) +
      " centers belong to the stars of " + std::to_string(result.persistent.size()) +
      " critical points, which leaves few for the rest: raise PersistenceThreshold or "
      "SampleFraction.");
  }
  if (!result.isConstant && !result.widthRemark.empty())
  {
    remarks.push_back(result.widthRemark);
  }
  if (result.model.parameters.regularization > 0.0)
  {
    remarks.push_back("the values at critical points are met only nearly, as Regularization is " +
      textOf(result.model.parameters.regularization) + "; the condition of the system is about " +
      textOf(result.condition) + ".");
  }
  if (!result.lost.empty())
  {
    const CriticalPoint& first = result.persistent[result.lost.front()];
    remarks.push_back(std::to_string(result.lost.size()) + " of " +
      std::to_string(result.persistent.size()) + " critical points are lost, the first the " +
      nameOf(first.type) + " at vertex " + std::to_string(first.input) +
      ": the values there are not met.");
  }
  return remarks;
}

std::size_t bytesOf(const FieldModel& model)
{
  const Eigen::Index numbers =
    model.centers.size() + model.coefficients.size() + model.tail.size() + model.tailOrigin.size();
  return sizeof(double) * static_cast<std::size_t>(numbers);
}

} // namespace SurfaceScalars
