#pragma once

#include "Basics.h"

namespace SurfaceScalars
{

/// The order of the vertices by value, ties by index (simulation of simplicity): strict, so that no
/// two are equal.
struct ValueOrder
{
  const double* values;

  double value(Index vertex) const { return this->values[vertex]; } ///< never falls in this order

  bool operator()(Index a, Index b) const
  {
    const double first = this->values[a];
    const double second = this->values[b];
    return a < b ? first <= second : first < second; // noise makes branches slow
  }
};

} // namespace SurfaceScalars
