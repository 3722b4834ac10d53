#pragma once

#include "Functions.h"
#include "MeshExamples.h"
#include "MeshlessApproximation.h"

#include <algorithm>
#include <cmath>

namespace SurfaceScalars::Truth
{

inline double rangeOf(const Values& values)
{
  return values.maxCoeff() - values.minCoeff();
}

inline Values waves(const Points& points, double frequency)
{
  return valuesOf([=](const Vector3d& p)
    { return std::sin(frequency * p.x()) * std::cos(0.8 * frequency * p.y()) + 0.3 * p.z(); },
    points);
}

inline MeshlessApproximation approximated(const TriangleMesh& mesh, const Values& values,
  const ApproximationParameters& parameters, int threadCount = 0)
{
  const MeshTopology topology = topologyOf(mesh);
  return approximateMeshless(
    surfaceDomain(mesh.points, topology), values, parameters, { threadCount, {} });
}

inline ApproximationParameters withFraction(double fraction, double persistence = 0.01)
{
  ApproximationParameters parameters;
  parameters.sampleFraction = fraction;
  parameters.persistenceThreshold = persistence;
  return parameters;
}

inline TriangleMesh torus(int around)
{
  const Mesh mesh = torusMesh(around, true);
  TriangleMesh result{ mesh.vertices, {} };
  for (const auto corners : mesh.triangles.colwise())
  {
    result.triangles.push_back(
      { static_cast<int>(corners[0]), static_cast<int>(corners[1]), static_cast<int>(corners[2]) });
  }
  return result;
}

/// The places of the model at which f is given by stars.
inline double largestMissAtStars(
  const TriangleMesh& mesh, const Values& values, const MeshlessApproximation& result)
{
  const MeshTopology topology = topologyOf(mesh);
  double largest = 0.0;
  for (const CriticalPoint& point : result.persistent)
  {
    const auto vertex = static_cast<Index>(point.input);
    largest = std::max(largest, std::abs(result.values[vertex] - values[vertex]));
    for (const Index neighbor : topology.link(vertex))
    {
      largest = std::max(largest, std::abs(result.values[neighbor] - values[neighbor]));
    }
  }
  return largest;
}

} // namespace SurfaceScalars::Truth
