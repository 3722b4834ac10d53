#pragma once

#include "Field.h"
#include "FieldTruth.h"
#include "MeshExamples.h"
#include "MeshlessContour.h"

#include <algorithm>
#include <cmath>
#include <vector>

/// Functions of space whose level sets are known, as models.
namespace SurfaceScalars::Truth
{

/// A sum of Gaussians and a linear function. The range is that of the Gaussians.
inline Field gaussians(const Points& centers, const Values& heights, double width,
  const Eigen::Vector4d& tail = Eigen::Vector4d::Zero())
{
  FieldModel model;
  model.parameters.scheme = Scheme::GlobalRBF;
  model.parameters.kernel = KernelType::Gaussian;
  model.parameters.kernelWidth = width;
  model.centers = centers;
  model.coefficients = heights;
  model.tail = tail;
  model.lowest = std::min(0.0, heights.minCoeff());
  model.highest = std::max(1.0, heights.maxCoeff());
  return Field(model);
}

/// Terms at random centers in the plane z = 0; heights are from -1 to 1.
inline FieldModel termsInThePlane(
  int count, double width, const Values& heights, KernelType kernel = KernelType::Wendland)
{
  FieldModel model;
  model.parameters.scheme = Scheme::GlobalRBF;
  model.parameters.kernel = kernel;
  model.parameters.kernelWidth = width;
  model.centers = randomPlaces(count, 1.0, 3);
  model.centers.row(2).setZero();
  model.coefficients = heights;
  model.lowest = -1.0;
  model.highest = 1.0;
  return model;
}

/// exp(-r^2 / width^2): its level sets are spheres around the center.
inline Field bump(const Vector3d& center, double width)
{
  return gaussians(center, Values::Ones(1), width);
}

/// The radius at which a bump has this value.
inline double radiusOf(double level, double width)
{
  return width * std::sqrt(-std::log(level));
}

/// offset + slope . p, and nothing else.
inline Field linearField(const Vector3d& slope, double offset = 0.0)
{
  Eigen::Vector4d tail;
  tail << offset, slope;
  return gaussians(Vector3d::Zero(), Values::Zero(1), 1.0, tail);
}

/// A square around the origin in the plane z = 0.
inline Mesh centeredSquare(int size, double side, double shake)
{
  Mesh mesh = squareMesh(size, shake);
  mesh.vertices.topRows(2).array() -= 0.5;
  mesh.vertices *= side;
  mesh.vertices.row(2).setZero();
  return mesh;
}

inline MeshlessContours contoursOf(const Field& field, const Mesh& mesh,
  const std::vector<double>& isoValues, double tolerance = 0.0, int maximumRefinement = 8)
{
  return traceMeshlessContours(
    field, mesh.vertices, mesh.triangles, { isoValues, tolerance, maximumRefinement });
}

/// The largest distance of the points of a curve, and of places between them, from a function.
template <typename Distance>
double largestDistance(const LevelSetCurve& curve, const Distance& distance)
{
  constexpr int Parts = 8;
  double largest = 0.0;
  const std::size_t count = curve.points.size();
  for (std::size_t i = 0; i + (curve.closed ? 0 : 1) < count; ++i)
  {
    const Vector3d& from = curve.points[i].position;
    const Vector3d along = curve.points[(i + 1) % count].position - from;
    for (int part = 0; part < Parts; ++part)
    {
      largest = std::max(largest, distance(Vector3d(from + along * part / Parts)));
    }
  }
  return largest;
}

} // namespace SurfaceScalars::Truth
