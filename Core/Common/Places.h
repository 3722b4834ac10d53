#pragma once

#include "Basics.h"

namespace SurfaceScalars
{

/// The places of the items of a list, one per column.
template <class Items, class PlaceOf>
Points placesOf(const Items& items, const PlaceOf& placeOf)
{
  Points places(3, static_cast<Eigen::Index>(items.size()));
  Eigen::Index column = 0;
  for (const auto& item : items)
  {
    places.col(column++) = placeOf(item);
  }
  return places;
}

} // namespace SurfaceScalars
