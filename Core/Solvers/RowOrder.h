#pragma once

#include "Aggregation.h"

#include <vector>

namespace SurfaceScalars
{

/// The rows breadth first: those that entries join are near each other, as memory likes it. Empty
/// if most are as they are.
/// @param near how far apart rows may be
std::vector<int> orderOfRows(const RowMatrix& matrix, int near);

/// Rows and columns in another order.
RowMatrix inOrder(const RowMatrix& matrix, const std::vector<int>& order);

} // namespace SurfaceScalars
