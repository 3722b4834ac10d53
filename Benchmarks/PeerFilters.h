#pragma once

#include "Laplacian.h"
#include "MeshTopology.h"

namespace SurfaceScalars::Benchmark
{

/**
 * Taubin's low-pass filter (1995; reference 24 of the smoothing paper): x - lambda L x, then x - mu
 * L x, with L the Laplacian whose rows are divided by their diagonal.
 *
 * @param lambda of the first of two passes, positive; the second's is -1 / (1 / lambda - 0.1)
 */
Values lowPass(const Laplacian& laplacian, const ValuesRef& values, int passPairs, double lambda);

struct SalientParameters
{
  double radius; ///< of the neighborhood, length: sigma
  double spread; ///< variance of the weight of a distance, length^2: sigma_1
  double range;  ///< variance of the weight of a difference, f's unit^2: sigma_2
  int steps;
};

/**
 * The bilateral filter of Liu et al. (2007; reference 15 of the smoothing paper, its sec. 2.2). The
 * differences f_ij that are averaged keep their sign: with the magnitudes that are printed, f would
 * only grow.
 */
Values salientSmoothing(const PointsRef& vertices, const MeshTopology& mesh,
  const ValuesRef& values, const SalientParameters& parameters);

} // namespace SurfaceScalars::Benchmark
