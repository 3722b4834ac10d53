#pragma once

#include "MatrixReduction.h"
#include "MeshCriticalPoints.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

/// What the critical points of a mesh or volume have to do with those of it glued to its mirror
/// image.
namespace SurfaceScalars::Truth
{

using TypedVertex = std::pair<CriticalType, Index>;
using TypedPairs = std::multiset<std::pair<TypedVertex, TypedVertex>>; ///< saddles, what they end

/// For an image its vertex. A pair of saddles is one of each.
/// @param types of what begins or ends in each dimension
inline TypedPairs typedPairs(
  const std::vector<VertexPair>& all, const std::vector<CriticalType>& types)
{
  TypedPairs pairs;
  for (const auto& [dimension, birth, death] : all)
  {
    const auto ofBirth = static_cast<std::size_t>(dimension);
    const TypedVertex first{ types[ofBirth], birth.first };
    const TypedVertex second{ types[ofBirth + 1], death.first };
    if (ofBirth > 0)
    {
      pairs.emplace(first, second);
    }
    if (ofBirth + 2 < types.size())
    {
      pairs.emplace(second, first);
    }
  }
  return pairs;
}

inline TypedPairs typedPairs(const MeshCriticalPoints& critical)
{
  const auto vertex = [&](std::size_t point) -> TypedVertex {
    return { critical.points[point].type, static_cast<Index>(critical.points[point].input) };
  };
  TypedPairs pairs;
  for (const CriticalPair& pair : critical.pairs)
  {
    EXPECT_EQ(pair.persistence,
      std::abs(critical.points[pair.saddle].value - critical.points[pair.extremum].value));
    pairs.emplace(vertex(pair.saddle), vertex(pair.extremum));
  }
  return pairs;
}

/// Of each critical point, those of its vertex and its image: the persistence of each time that it
/// is there, descending, infinity for what is never cancelled.
template <class Topology>
std::vector<std::vector<double>> gluedPersistences(
  const MeshCriticalPoints& found, const TypedPairs& all, const Topology& topology, const Values& f)
{
  std::map<TypedVertex, std::vector<double>> ofPairs;
  for (const auto& [saddle, other] : all)
  {
    const double persistence = std::abs(f[saddle.second] - f[other.second]);
    ofPairs[saddle].push_back(persistence);
    if (other.first == CriticalType::Minimum || other.first == CriticalType::Maximum)
    {
      ofPairs[other].push_back(persistence);
    }
  }
  std::vector<std::vector<double>> result;
  for (const CriticalPoint& point : found.points)
  {
    const auto vertex = static_cast<Index>(point.input);
    const bool isSingle = topology.isClosed() || topology.isBoundary(vertex);
    std::vector<double>& persistences = ofPairs[{ point.type, vertex }];
    const auto times = static_cast<std::size_t>((isSingle ? 1 : 2) * point.multiplicity);
    EXPECT_LE(persistences.size(), times);
    persistences.resize(times, std::numeric_limits<double>::infinity());
    std::sort(persistences.rbegin(), persistences.rend());
    result.push_back(persistences);
  }
  return result;
}

/// How often a point is there: half as often as vertex and image together, rounded up.
inline int halfOf(const CriticalPoint& point, std::size_t isThere, std::size_t times)
{
  const auto images = times / static_cast<std::size_t>(point.multiplicity);
  return static_cast<int>((isThere + images - 1) / images);
}

/// A point has the largest persistence of its vertex and image, f's range for infinity; removeBelow
/// keeps half of what both keep, rounded up: what has the persistence, and nothing else.
template <class Topology>
void expectHalfOfGlued(
  const MeshCriticalPoints& found, const TypedPairs& all, const Topology& topology, const Values& f)
{
  const std::vector<std::vector<double>> persistences = gluedPersistences(found, all, topology, f);
  const double range = f.maxCoeff() - f.minCoeff();
  std::set<double> thresholds{ 0.5 * range, range };
  for (std::size_t i = 0; i < found.points.size(); ++i)
  {
    EXPECT_EQ(found.points[i].persistence, std::min(persistences[i].front(), range));
    thresholds.insert(found.points[i].persistence);
  }
  for (const double threshold : thresholds)
  {
    std::vector<CriticalPoint> kept = found.points;
    removeBelow(kept, found.pairs, threshold);
    auto next = kept.begin();
    for (std::size_t i = 0; i < found.points.size(); ++i)
    {
      const CriticalPoint& point = found.points[i];
      const auto isThere = std::count_if(persistences[i].begin(), persistences[i].end(),
        [=](double persistence) { return persistence >= threshold; });
      const bool isKept =
        next != kept.end() && next->input == point.input && next->type == point.type;
      EXPECT_EQ(isKept, point.persistence >= threshold);
      EXPECT_EQ(isKept ? next->multiplicity : 0,
        halfOf(point, static_cast<std::size_t>(isThere), persistences[i].size()));
      next += isKept ? 1 : 0;
    }
    EXPECT_EQ(next, kept.end());
  }
}

} // namespace SurfaceScalars::Truth
