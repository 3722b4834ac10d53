#pragma once

#include "ValueRanks.h"
#include "VolumeExamples.h"

#include <cmath>
#include <numeric>
#include <string>
#include <vector>

/// Functions on volumes, and volumes without their boundary, for the core's tests.
namespace SurfaceScalars::Truth
{

struct NamedFunction
{
  std::string name;
  Values values;
};

/// A height, noise on it, noise alone, few different values, and one.
inline std::vector<NamedFunction> functionsOn(const Volume& volume)
{
  const Values smooth = Vector3d(0.3, 0.5, 0.8).transpose() * volume.vertices;
  Values noise = Values::Zero(smooth.size());
  addNoise(noise, 1.0, 7);
  return { { "smooth", smooth }, { "noisy", smooth + 0.2 * noise }, { "random", noise },
    { "steps", noise.unaryExpr([](double value) { return std::floor(value); }) },
    { "constant", Values::Constant(smooth.size(), 3.0) } };
}

/// A volume glued to a mirror image of its own along the boundary: the image of an interior vertex
/// comes after all vertices.
struct Glued
{
  explicit Glued(const Volume& volume)
    : tetrahedra(4, 2 * volume.tetrahedra.cols())
  {
    const std::vector<bool> isBoundary = boundaryOf(volume);
    std::vector<Index> images;
    auto count = static_cast<Index>(volume.vertices.cols());
    this->originals.resize(count);
    std::iota(this->originals.begin(), this->originals.end(), Index(0));
    for (Index vertex = 0; vertex < isBoundary.size(); ++vertex)
    {
      images.push_back(isBoundary[vertex] ? vertex : count++);
      if (!isBoundary[vertex])
      {
        this->originals.push_back(vertex);
      }
    }
    this->tetrahedra << volume.tetrahedra,
      volume.tetrahedra.unaryExpr([&](Index vertex) { return images[vertex]; });
  }

  /// An image comes right after its vertex.
  std::vector<int> ranks(const Values& values) const
  {
    const std::vector<int> ofOriginals = ranksOf(values);
    Values twice(static_cast<Eigen::Index>(this->originals.size()));
    for (std::size_t i = 0; i < this->originals.size(); ++i)
    {
      twice[static_cast<Eigen::Index>(i)] = ofOriginals[this->originals[i]];
    }
    return ranksOf(twice);
  }

  Tetrahedra tetrahedra;
  std::vector<Index> originals; ///< of each vertex
};

} // namespace SurfaceScalars::Truth
