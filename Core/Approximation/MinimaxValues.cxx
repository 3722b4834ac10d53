#include "MinimaxValues.h"

#include "FarthestPoints.h"
#include "LargestMisses.h"
#include "MinimaxSystem.h"

#include <algorithm>

namespace SurfaceScalars
{
namespace
{

constexpr double PlacesPerCenter = 16.0;  // at first
constexpr double MostDependences = 2.5e8; // of misses on values: two gigabytes
constexpr double FirstShare = 0.8;        // of these at most
constexpr int Rounds = 10;
constexpr double EnoughOfAll = 1.02; // largest miss at all vertices, in that at the places

/// Of places at which all values at so many centers count.
Eigen::Index mostPlaces(Eigen::Index centerCount)
{
  return static_cast<Eigen::Index>(MostDependences) / centerCount;
}

/// Spread over all vertices.
std::vector<Index> firstPlaces(
  const Points& vertices, Eigen::Index centerCount, const Execution& execution)
{
  const double count = std::min(PlacesPerCenter * static_cast<double>(centerCount),
    FirstShare * static_cast<double>(mostPlaces(centerCount)));
  return evenSubset(vertices, static_cast<std::size_t>(count), execution);
}

} // namespace

void minimizeLargestMiss(CenterSum& sum, const CenterSet& centers, const Points& vertices,
  const ValuesRef& values, const Execution& execution)
{
  sum.interpolate(centers, execution.part(0.0, 0.1));
  const Eigen::Index free = centers.places.cols() - centers.starCount;
  if (free == 0)
  {
    return;
  }
  const Values misses = values - sum.at(vertices, execution.part(0.1, 0.15));
  const Points freePlaces = centers.places.rightCols(free);

  MinimaxSystem changes; // of the values at these places
  changes.add(sum.dependences(freePlaces, free, execution.part(0.15, 0.2)),
    centers.values.tail(free) - sum.at(freePlaces, execution.part(0.15, 0.15)),
    execution.part(0.2, 0.2));
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
    const double largest = left.maxCoeff();
    if (largest < least)
    {
      least = largest;
      best = tried;
    }
    const auto placeCount = free + static_cast<Eigen::Index>(places.size());
    const auto most = std::clamp<Eigen::Index>(mostPlaces(free) - placeCount, 0, free);
    more =
      largestMisses(left, EnoughOfAll * left(places).maxCoeff(), static_cast<std::size_t>(most));
  }
  sum.takeValues(best, execution.part(1.0, 1.0));
}

} // namespace SurfaceScalars
