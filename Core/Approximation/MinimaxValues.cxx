#include "MinimaxValues.h"

#include "FarthestPoints.h"
#include "MinimaxSystem.h"

#include <algorithm>

namespace SurfaceScalars
{
namespace
{

constexpr double PlacesPerCenter = 16.0;
constexpr double MostDependences = 2.5e8; // two gigabytes
constexpr int Rounds = 10;
constexpr double EnoughOfAll = 1.02; // largest miss at all vertices, in that at the places

/// What is missed by more than this, most first, at most so many.
std::vector<Index> missedMore(const Values& misses, double than, Eigen::Index most)
{
  std::vector<Index> result;
  for (Index i = 0; i < static_cast<Index>(misses.size()); ++i)
  {
    if (misses[i] > than)
    {
      result.push_back(i);
    }
  }
  std::sort(result.begin(), result.end(),
    [&](Index a, Index b) { return misses[a] != misses[b] ? misses[a] > misses[b] : a < b; });
  result.resize(std::min(result.size(), static_cast<std::size_t>(most)));
  return result;
}

/// Spread over all vertices, as many as centers ask for and memory allows.
std::vector<Index> firstPlaces(
  const Points& vertices, Eigen::Index centerCount, const Execution& execution)
{
  const auto count = static_cast<double>(centerCount);
  const double most = MostDependences / count;
  return evenSubset(
    vertices, static_cast<std::size_t>(std::min(PlacesPerCenter * count, most)), execution);
}

} // namespace

void minimizeLargestMiss(CenterSum& sum, const CenterSet& centers, const Points& vertices,
  const ValuesRef& values, const Execution& execution)
{
  sum.interpolate(centers, execution.part(0.0, 0.1));
  const Eigen::Index free = centers.places.cols() - centers.starCount;
  const Values misses = values - sum.at(vertices, execution.part(0.1, 0.15));

  MinimaxSystem
    changes; // of the values at the centers that are not of stars, which are missed, too
  changes.add(sum.dependences(centers.places.rightCols(free), free, execution.part(0.15, 0.2)),
    Values::Zero(free), execution.part(0.2, 0.2));
  std::vector<Index> more = firstPlaces(vertices, free, execution.part(0.2, 0.2));
  std::vector<Index> places;
  Values best = centers.values;
  double least = misses.lpNorm<Eigen::Infinity>();
  for (int round = 0; round < Rounds && !more.empty(); ++round)
  {
    const Execution ofRound =
      execution.part(1.0 - 0.8 / (1.0 + round), 1.0 - 0.8 / (2.0 + round)); // the first is largest
    const Points added = vertices(Eigen::all, more);
    changes.add(
      sum.dependences(added, free, ofRound.part(0.0, 0.4)), misses(more), ofRound.part(0.4, 0.6));
    places.insert(places.end(), more.begin(), more.end());
    Values tried = centers.values;
    tried.tail(free) += changes.solve(ofRound.part(0.6, 0.9));
    sum.takeValues(tried, ofRound.part(0.9, 0.9));
    const Values left = (values - sum.at(vertices, ofRound.part(0.9, 1.0))).cwiseAbs();
    if (left.maxCoeff() < least)
    {
      least = left.maxCoeff();
      best = tried;
    }
    more = missedMore(left, EnoughOfAll * left(places).maxCoeff(), free);
  }
  sum.takeValues(best, execution.part(1.0, 1.0));
}

} // namespace SurfaceScalars
