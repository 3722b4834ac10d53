#pragma once

#include "Basics.h"
#include "Execution.h"

#include <utility>
#include <vector>

namespace SurfaceScalars
{

/// The vertices in a strict order, and the place of each in it.
class VertexOrder
{
public:
  explicit VertexOrder(std::vector<Index> ascending)
    : vertices_(std::move(ascending))
    , places_(this->vertices_.size())
  {
    for (std::size_t place = 0; place < this->vertices_.size(); ++place)
    {
      this->places_[this->vertices_[place]] = static_cast<Index>(place);
    }
  }

  Index size() const { return static_cast<Index>(this->vertices_.size()); }
  Index vertexAt(Index place) const { return this->vertices_[place]; }
  Index placeOf(Index vertex) const { return this->places_[vertex]; }

  /// The same, the last first.
  VertexOrder reversed() const
  {
    return VertexOrder({ this->vertices_.rbegin(), this->vertices_.rend() });
  }

private:
  std::vector<Index> vertices_;
  std::vector<Index> places_;
};

/// Which vertices shall be extrema: 1 for a minimum, -1 for a maximum, 0 for neither.
using ExtremumSigns = std::vector<signed char>;

/// The order of the values; of equal ones minima come first and maxima last, otherwise by index.
VertexOrder orderByValue(
  const ValuesRef& values, const ExtremumSigns& signs, const Execution& execution);

} // namespace SurfaceScalars
