#include "PaperMeshes.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataReader.h"

#include <array>
#include <cmath>
#include <map>
#include <random>
#include <stdexcept>
#include <vector>

namespace SurfaceScalars::Benchmark
{
namespace
{

constexpr double Level = 0.05; ///< of noise

Triangles trianglesOf(vtkPolyData* mesh)
{
  Triangles triangles(3, mesh->GetNumberOfPolys());
  Eigen::Index t = 0;
  const auto cells = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell(), ++t)
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    cells->GetCurrentCell(size, corners);
    for (int c = 0; c < 3; ++c)
    {
      triangles(c, t) = static_cast<Index>(corners[c]);
    }
  }
  return triangles;
}

NoisyFunction read(const std::string& folder, const std::string& name, double waves)
{
  vtkNew<vtkPolyDataReader> reader;
  reader->SetFileName((folder + "/" + name + ".vtk").c_str());
  reader->Update();
  vtkPolyData* mesh = reader->GetOutput();
  if (mesh->GetNumberOfPolys() == 0)
  {
    throw std::runtime_error("no triangles in " + folder + "/" + name + ".vtk");
  }
  Points vertices(3, mesh->GetNumberOfPoints());
  for (Eigen::Index i = 0; i < vertices.cols(); ++i)
  {
    mesh->GetPoint(i, vertices.col(i).data());
  }
  const Vector3d low = vertices.rowwise().minCoeff();
  const Vector3d high = vertices.rowwise().maxCoeff();
  vertices = (vertices.colwise() - 0.5 * (low + high)) * (2.0 / (high - low).norm());
  return withNoise(name, std::move(vertices), trianglesOf(mesh), waves, Level);
}

/// Triangles along u and v shrink and grow by a factor of 19 in area each.
NoisyFunction makeIrregularTorus()
{
  constexpr Index AroundAxis = 240;
  constexpr Index AroundTube = 80;
  const auto uneven = [](double t, int patches)
  { return t + 0.9 * std::sin(patches * t) / patches; };

  Points vertices(3, AroundAxis * AroundTube);
  Triangles triangles(3, 2 * vertices.cols());
  for (Index i = 0; i < AroundAxis; ++i)
  {
    for (Index j = 0; j < AroundTube; ++j)
    {
      const double u = uneven(2 * Pi * i / AroundAxis, 3);
      const double v = uneven(2 * Pi * j / AroundTube, 1);
      const double radius = 1.0 + 0.4 * std::cos(v);
      const Index corner = i * AroundTube + j;
      vertices.col(corner) =
        Vector3d(radius * std::cos(u), radius * std::sin(u), 0.4 * std::sin(v));
      const Index right = (i + 1) % AroundAxis * AroundTube + j;
      const Index up = i * AroundTube + (j + 1) % AroundTube;
      const Index across = (i + 1) % AroundAxis * AroundTube + (j + 1) % AroundTube;
      triangles.col(2 * corner) << corner, right, across;
      triangles.col(2 * corner + 1) << corner, across, up;
    }
  }
  return withNoise("irregular torus", std::move(vertices), triangles, 1.0, Level);
}

/// Halves every edge of triangles on the unit sphere.
void refine(std::vector<Vector3d>& points, std::vector<std::array<Index, 3>>& triangles)
{
  std::map<std::pair<Index, Index>, Index> middles;
  const auto middleOf = [&](Index a, Index b)
  {
    const auto [place, isNew] =
      middles.try_emplace(std::minmax(a, b), static_cast<Index>(points.size()));
    if (isNew)
    {
      points.push_back((points[a] + points[b]).normalized());
    }
    return place->second;
  };
  std::vector<std::array<Index, 3>> finer;
  for (const auto& [a, b, c] : triangles)
  {
    const Index ab = middleOf(a, b);
    const Index bc = middleOf(b, c);
    const Index ca = middleOf(c, a);
    finer.insert(finer.end(), { { a, ab, ca }, { b, bc, ab }, { c, ca, bc }, { ab, bc, ca } });
  }
  triangles = std::move(finer);
}

} // namespace

NoisyFunction withNoise(
  const std::string& name, Points vertices, const Triangles& triangles, double waves, double level)
{
  Values clean(vertices.cols());
  for (Eigen::Index i = 0; i < clean.size(); ++i)
  {
    const Vector3d p = vertices.col(i);
    clean[i] = Vector3d(0.9, 0.31, 0.17).dot(p) +
      0.15 * waves * std::sin(4 * waves * p.y() + 1) * std::cos(3 * waves * p.x());
  }
  const double range = clean.maxCoeff() - clean.minCoeff();
  std::mt19937 generator(5);
  std::normal_distribution<double> noise(0.0, level * range);
  Values noisy = clean;
  for (double& value : noisy)
  {
    value += noise(generator);
  }
  return { name, SmoothingMesh(std::move(vertices), triangles), clean, noisy, range };
}

PaperMeshes::PaperMeshes(const std::string& folder)
  : elephant(read(folder, "refined_elephant", 1.0))
  , turbine(read(folder, "turbine", 1.0))
  , irregularTorus(makeIrregularTorus())
{
}

NoisyFunction noisySphere(int halvings, double level)
{
  std::vector<Vector3d> points = { Vector3d::UnitX(), -Vector3d::UnitX(), Vector3d::UnitY(),
    -Vector3d::UnitY(), Vector3d::UnitZ(), -Vector3d::UnitZ() };
  std::vector<std::array<Index, 3>> triangles = { { 0, 2, 4 }, { 2, 1, 4 }, { 1, 3, 4 },
    { 3, 0, 4 }, { 2, 0, 5 }, { 1, 2, 5 }, { 3, 1, 5 }, { 0, 3, 5 } };
  for (int i = 0; i < halvings; ++i)
  {
    refine(points, triangles);
  }
  Points vertices(3, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    vertices.col(static_cast<Eigen::Index>(i)) = points[i];
  }
  Triangles corners(3, static_cast<Eigen::Index>(triangles.size()));
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    corners.col(static_cast<Eigen::Index>(t)) << triangles[t][0], triangles[t][1], triangles[t][2];
  }
  return withNoise("sphere", std::move(vertices), corners, 1.0, level);
}

} // namespace SurfaceScalars::Benchmark
