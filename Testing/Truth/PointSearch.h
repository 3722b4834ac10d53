#pragma once

#include "Basics.h"

#include <nanoflann.hpp>

#include <utility>
#include <vector>

namespace SurfaceScalars::Truth
{

/// Nearest neighbors among a list of places.
class PointSearch
{
public:
  explicit PointSearch(const std::vector<Vector3d>& places)
    : places_{ places }
    , tree_(3, places_, nanoflann::KDTreeSingleIndexAdaptorParams(10))
  {
    this->tree_.buildIndex();
  }

  /// Index and distance of the nearest place; there must be one.
  std::pair<std::size_t, double> nearest(const Vector3d& query) const
  {
    std::size_t index = 0;
    double squaredDistance = 0.0;
    this->tree_.knnSearch(query.data(), 1, &index, &squaredDistance);
    return { index, std::sqrt(squaredDistance) };
  }

  /// All places within the radius, in no order.
  std::vector<std::size_t> within(const Vector3d& query, double radius) const
  {
    std::vector<std::pair<std::size_t, double>> matches;
    nanoflann::SearchParams unsorted;
    unsorted.sorted = false;
    this->tree_.radiusSearch(query.data(), radius * radius, matches, unsorted);
    std::vector<std::size_t> indices;
    for (const auto& match : matches)
    {
      indices.push_back(match.first);
    }
    return indices;
  }

private:
  struct Adaptor
  {
    const std::vector<Vector3d>& places;
    std::size_t kdtree_get_point_count() const { return this->places.size(); }
    double kdtree_get_pt(std::size_t i, std::size_t axis) const { return this->places[i][axis]; }
    template <typename Box>
    bool kdtree_get_bbox(Box&) const
    {
      return false;
    }
  };
  using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Adaptor>,
    Adaptor, 3, std::size_t>;

  Adaptor places_;
  Tree tree_;
};

} // namespace SurfaceScalars::Truth
