#pragma once

#include "Sampling.h"
#include "Tetrahedra.h"
#include "VolumeTopology.h"

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <string>
#include <vector>

/// Volumes of known topology, for the core's tests.
namespace SurfaceScalars::Truth
{

struct Volume
{
  Points vertices;
  Tetrahedra tetrahedra;
};

using Cube = std::array<int, 3>; ///< its place in a grid

/// Unit cubes in six tetrahedra each, along the ways from a corner to the opposite one.
/// @param isThere of a cube @param isPeriodic opposite sides of the grid are one
inline Volume cubesVolume(const std::array<int, 3>& size,
  const std::function<bool(const Cube&)>& isThere, bool isPeriodic = false)
{
  std::map<Cube, Index> numbers;
  std::vector<Vector3d> places;
  std::vector<Eigen::Matrix<Index, 4, 1>> cells;
  const auto numberOf = [&](Cube place)
  {
    const Vector3d position(place[0], place[1], place[2]);
    for (std::size_t axis = 0; axis < 3 && isPeriodic; ++axis)
    {
      place[axis] %= size[axis];
    }
    const auto [entry, isNew] = numbers.try_emplace(place, static_cast<Index>(places.size()));
    if (isNew)
    {
      places.push_back(position);
    }
    return entry->second;
  };
  const auto addCube = [&](const Cube& cube)
  {
    std::array<std::size_t, 3> axes{ 0, 1, 2 };
    do
    {
      Cube place = cube;
      Eigen::Matrix<Index, 4, 1> corners;
      corners[0] = numberOf(place);
      for (std::size_t step = 0; step < 3; ++step)
      {
        ++place[axes[step]];
        corners[static_cast<Eigen::Index>(step) + 1] = numberOf(place);
      }
      cells.push_back(corners);
    } while (std::next_permutation(axes.begin(), axes.end()));
  };
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i)
      {
        if (isThere({ i, j, k }))
        {
          addCube({ i, j, k });
        }
      }
    }
  }
  return { Eigen::Map<const Points>(places[0].data(), 3, static_cast<Eigen::Index>(places.size())),
    Eigen::Map<const Tetrahedra>(cells[0].data(), 4, static_cast<Eigen::Index>(cells.size())) };
}

inline Volume blockVolume(int x, int y, int z)
{
  return cubesVolume({ x, y, z }, [](const Cube&) { return true; });
}

/// The cube with opposite sides glued, which has no boundary.
inline Volume threeTorus(int size)
{
  return cubesVolume(
    { size, size, size }, [](const Cube&) { return true; }, true);
}

inline VolumeTopology topologyOf(const Volume& volume, int threadCount = 0)
{
  return { static_cast<Index>(volume.vertices.cols()), volume.tetrahedra, { threadCount, {} } };
}

struct NamedVolume
{
  std::string name;
  Volume volume;
  int eulerCharacteristic;
  int components;
  bool isClosed;
};

/// Manifolds with and without boundary.
inline std::vector<NamedVolume> volumesOfAllKinds()
{
  const auto isMiddle = [](int i) { return i == 1 || i == 2; };
  return { { "ball", blockVolume(5, 4, 3), 1, 1, false },
    { "shell",
      cubesVolume({ 4, 4, 4 },
        [=](const Cube& cube)
        { return !(isMiddle(cube[0]) && isMiddle(cube[1]) && isMiddle(cube[2])); }),
      2, 1, false },
    { "ring",
      cubesVolume(
        { 4, 4, 2 }, [=](const Cube& cube) { return !(isMiddle(cube[0]) && isMiddle(cube[1])); }),
      0, 1, false },
    { "two", cubesVolume({ 5, 2, 2 }, [](const Cube& cube) { return cube[0] != 2; }), 2, 2, false },
    { "3-torus", threeTorus(5), 0, 1, true } };
}

/// The corners of a tetrahedron without one.
inline std::array<Index, 3> faceOf(const Tetrahedra& tetrahedra, Eigen::Index cell, int without)
{
  std::array<Index, 3> face;
  for (int i = 1; i < 4; ++i)
  {
    face[static_cast<std::size_t>(i) - 1] = tetrahedra((without + i) % 4, cell);
  }
  std::sort(face.begin(), face.end());
  return face;
}

/// Whether a vertex has a face of one tetrahedron.
inline std::vector<bool> boundaryOf(const Volume& volume)
{
  std::map<std::array<Index, 3>, int> counts;
  for (Eigen::Index cell = 0; cell < volume.tetrahedra.cols(); ++cell)
  {
    for (int corner = 0; corner < 4; ++corner)
    {
      ++counts[faceOf(volume.tetrahedra, cell, corner)];
    }
  }
  std::vector<bool> isBoundary(static_cast<std::size_t>(volume.vertices.cols()), false);
  for (const auto& [face, count] : counts)
  {
    for (const Index corner : face)
    {
      isBoundary[corner] = isBoundary[corner] || count == 1;
    }
  }
  return isBoundary;
}

} // namespace SurfaceScalars::Truth
