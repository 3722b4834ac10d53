#pragma once

namespace SurfaceScalars
{

/// Of Eigen's matrices, whose == wants equal sizes.
template <typename Numbers>
bool equal(const Numbers& a, const Numbers& b)
{
  return a.cols() == b.cols() && a.rows() == b.rows() && a == b;
}

} // namespace SurfaceScalars
