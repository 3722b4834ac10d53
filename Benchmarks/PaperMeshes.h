#pragma once

#include "ConstrainedSmoothing.h"

#include <string>

namespace SurfaceScalars::Benchmark
{

/// A function on a mesh, and the same with noise.
struct NoisyFunction
{
  std::string name;
  SmoothingMesh mesh;
  Values clean;
  Values noisy;
  double range; ///< of clean
};

/// Adds normally distributed noise, always the same, to a smooth function: some hills of a tilted
/// height, or as many as `waves` asks for.
/// @param level standard deviation, a fraction of the range
NoisyFunction withNoise(
  const std::string& name, Points vertices, const Triangles& triangles, double waves, double level);

/// The meshes of the paper's figures, or what comes near.
struct PaperMeshes
{
  /// @param folder with refined_elephant.vtk and turbine.vtk
  explicit PaperMeshes(const std::string& folder);

  NoisyFunction elephant;       ///< genus 3, 44,460 vertices
  NoisyFunction turbine;        ///< genus 11, 9,210 vertices
  NoisyFunction irregularTorus; ///< patches of small and large triangles
};

/// A sphere of some vertices: an octahedron, each edge halved time and again.
NoisyFunction noisySphere(int halvings, double level);

} // namespace SurfaceScalars::Benchmark
