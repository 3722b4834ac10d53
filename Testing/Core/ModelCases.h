#pragma once

#include "CriticalPoints.h"
#include "Field.h"
#include "ImplicitMesh.h"
#include "MeshExamples.h"
#include "ModelCriticalPoints.h"
#include "Surfaces.h"

#include <Eigen/LU>

#include <algorithm>
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

/// [-2, 2]^2 in the plane, irregular inside.
inline Mesh planarSquare(int size)
{
  Mesh mesh = squareMesh(size, 0.3);
  mesh.vertices.topRows<2>() = (4.0 * mesh.vertices.topRows<2>()).array() - 2.0;
  return mesh;
}

/// Where grad u vanishes in the plane z = 0 within that square, by Newton's method with differences
/// of the gradient from a grid of starts.
inline std::vector<CriticalPoint> planarCriticalPoints(const SpaceFunction& u)
{
  const auto gradient = [&](const Vector2d& p) -> Vector2d {
    return u.gradient({ p.x(), p.y(), 0.0 }).head<2>();
  };
  std::vector<CriticalPoint> found;
  constexpr int starts = 25; // along each side
  for (int start = 0; start < starts * starts; ++start)
  {
    Vector2d p = 4.0 / starts * Vector2d(start % starts + 0.5, start / starts + 0.5).array() - 2.0;
    Eigen::Matrix2d hessian;
    for (int i = 0; i < 30; ++i)
    {
      for (int axis = 0; axis < 2; ++axis)
      {
        const Vector2d shift = 1e-5 * Vector2d::Unit(axis);
        hessian.col(axis) = (gradient(p + shift) - gradient(p - shift)) / 2e-5;
      }
      const Vector2d step = -hessian.inverse() * gradient(p);
      p += step * std::min(1.0, 0.1 / step.norm());
    }
    const Vector3d place(p.x(), p.y(), 0.0);
    const auto isThere = [&](const CriticalPoint& other)
    { return (other.position - place).norm() < 1e-6; };
    if (gradient(p).norm() < 1e-9 && p.cwiseAbs().maxCoeff() < 2.0 &&
      std::none_of(found.begin(), found.end(), isThere))
    {
      CriticalPoint point;
      point.position = place;
      point.type = hessian.determinant() < 0.0 ? CriticalType::Saddle
        : hessian.trace() < 0.0                ? CriticalType::Maximum
                                               : CriticalType::Minimum;
      found.push_back(point);
    }
  }
  return found;
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
      if (point.isRefined())
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
  std::size_t countOf(RefinementEnd end) const
  {
    return static_cast<std::size_t>(
      std::count_if(this->result.points.begin(), this->result.points.end(),
        [=](const ModelCriticalPoint& point) { return point.end == end; }));
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
