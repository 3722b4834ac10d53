#pragma once

#include "ConstrainedSmoothing.h"
#include "Meshes.h"

#include <gtest/gtest.h>

namespace SurfaceScalars::Truth
{

inline SmoothingMesh smoothingMesh(const TriangleMesh& mesh)
{
  return SmoothingMesh(mesh.points, trianglesOf(mesh));
}

inline SmoothingParameters with(SmoothingMethod method, double threshold = 0.0)
{
  SmoothingParameters parameters;
  parameters.method = method;
  parameters.persistenceThreshold = threshold;
  return parameters;
}

inline void expectEqual(const CriticalCounts& a, const CriticalCounts& b)
{
  EXPECT_EQ(a.minima, b.minima);
  EXPECT_EQ(a.saddles, b.saddles);
  EXPECT_EQ(a.maxima, b.maxima);
}

} // namespace SurfaceScalars::Truth
