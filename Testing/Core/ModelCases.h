#pragma once

#include "CriticalPoints.h"
#include "Field.h"
#include "ImplicitMesh.h"
#include "MeshExamples.h"
#include "ModelCriticalPoints.h"
#include "Surfaces.h"

#include <cmath>
#include <memory>
#include <string>
#include <vector>

/// Functions of space on meshes of known surfaces, for what finds their critical points.
namespace SurfaceScalars::Truth
{

inline MeshTopology topologyOf(const Mesh& mesh)
{
  return { static_cast<Index>(mesh.vertices.cols()), mesh.triangles };
}

inline Mesh asMesh(const TriangleMesh& mesh)
{
  return { mesh.points, trianglesOf(mesh) };
}

/// A sum of radial functions through a few values on a surface.
inline Field fewCenters(
  const ClosedSurface& surface, int count, KernelType kernel, double width, unsigned seed)
{
  const Points centers = surface.sample(count, seed);
  const auto waves = [](const Vector3d& p)
  { return std::sin(2.6 * p.x() + 0.7) * std::cos(2.1 * p.y() - 0.4) + 0.7 * p.z() + 0.3 * p.x(); };
  FieldParameters parameters;
  parameters.scheme = Scheme::GlobalRBF;
  parameters.kernel = kernel;
  parameters.kernelWidth = width;
  return Field::fit(centers, valuesOf(waves, centers), parameters);
}

/// As a function that knows nothing of Hessians. The field must outlive it; for one thread.
inline SpaceFunction asFunction(const Field& field)
{
  const std::shared_ptr<FieldApproximation> approximation = field.approximation();
  const Vector3d origin = field.cloud().origin();
  return { "u",
    [=](const Vector3d& p) { return approximation->jet(p - origin, Derivatives::None).value; },
    [=](const Vector3d& p) -> Vector3d
    { return approximation->jet(p - origin, Derivatives::Gradient).gradient; } };
}

/// What a critical point search makes of a field on a mesh.
struct ModelRun
{
  MeshCriticalPoints candidates;
  ModelCriticalPoints result;
  double sum = 0.0; ///< of the indices

  ModelRun(const Points& vertices, const MeshTopology& mesh, const Field& field)
  {
    const Values values = field.evaluate(vertices, {}).values;
    this->candidates = meshCriticalPoints(vertices, mesh, values);
    this->result = refineOnModel(vertices, mesh, values, field, this->candidates);
    this->sum = indexSum(this->result.points, mesh);
  }

  std::vector<CriticalPoint> refined() const
  {
    std::vector<CriticalPoint> points;
    for (const ModelCriticalPoint& point : this->result.points)
    {
      if (point.isRefined)
      {
        points.push_back(point.point);
      }
    }
    return points;
  }
  int mostSteps() const
  {
    int most = 0;
    for (const ModelCriticalPoint& point : this->result.points)
    {
      most = std::max(most, point.iterations);
    }
    return most;
  }
  /// Of the refined points, in the scale of the gradient.
  double largestResidual() const
  {
    double largest = 0.0;
    for (const CriticalPoint& point : this->refined())
    {
      largest = std::max(largest, point.residual / this->result.gradientScale);
    }
    return largest;
  }
};

/// The mean length of the edges.
inline double meanEdge(const Points& vertices, const Triangles& triangles)
{
  double sum = 0.0;
  for (const auto corners : triangles.colwise())
  {
    for (int i = 0; i < 3; ++i)
    {
      sum += (vertices.col(corners[i]) - vertices.col(corners[(i + 1) % 3])).norm();
    }
  }
  return sum / (3.0 * static_cast<double>(triangles.cols()));
}

} // namespace SurfaceScalars::Truth
