#pragma once

#include "GlobalSystem.h"
#include "RadialTruth.h"

#include <cmath>

/// What the tests of systems of radial functions share.
namespace SurfaceScalars
{

inline FieldParameters parametersOf(KernelType kernel, double width, double regularization = 0.0)
{
  FieldParameters result;
  result.scheme = Scheme::GlobalRBF;
  result.kernel = kernel;
  result.kernelWidth = width;
  result.regularization = regularization;
  return result;
}

/// The support that reaches this many points around a typical one.
inline double supportOf(const PointCloud& cloud, int count)
{
  Neighborhood found;
  cloud.nearest(cloud.points().col(cloud.pointCount() / 2), count, found);
  return std::sqrt(found.squaredDistances.back());
}

} // namespace SurfaceScalars
