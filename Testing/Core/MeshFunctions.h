#pragma once

#include "Meshes.h"
#include "Sampling.h"

#include <cmath>
#include <string>
#include <vector>

namespace SurfaceScalars::Truth
{

struct NamedValues
{
  std::string name;
  Values values;
};

inline Values randomValues(const TriangleMesh& mesh, unsigned seed)
{
  Values values = Values::Zero(mesh.points.cols());
  addNoise(values, 1.0, seed);
  return values;
}

/// A height, noise on it, noise alone, few different values, and one.
inline std::vector<NamedValues> meshFunctions(const TriangleMesh& mesh, unsigned seed)
{
  const Values smooth = Vector3d(0.3, 0.5, 0.8).transpose() * mesh.points;
  const double range = smooth.maxCoeff() - smooth.minCoeff();
  const Values noise = randomValues(mesh, seed);
  return { { "smooth", smooth }, { "noisy", smooth + 0.05 * range * noise }, { "random", noise },
    { "steps", noise.unaryExpr([](double value) { return std::floor(value); }) },
    { "constant", Values::Constant(smooth.size(), -3.0) } };
}

} // namespace SurfaceScalars::Truth
