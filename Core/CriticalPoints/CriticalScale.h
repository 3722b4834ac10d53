#pragma once

#include "CriticalField.h"
#include "FuzzyCriticalPoints.h"
#include "PolynomialNeighborhood.h"

#include <memory>

namespace SurfaceScalars
{

/// What the local fits are made of: the samples, or averages of blocks of them.
struct CriticalScale
{
  const PointCloud* cloud = nullptr;    ///< that of the graph, or of the averages
  Values values;                        ///< at its points
  Vector3d origin = Vector3d::Zero();   ///< of the cloud, seen from the graph's
  FitSize size{ 0, 0.0 };               ///< of the fits
  int degree = 2;                       ///< of their polynomials
  int blockSize = 1;                    ///< samples to an average; 1 = not averaged
  int neighborCount = 0;                ///< samples that make a fit, averaged or not
  bool isNoisy = false;                 ///< too much for fits to be as fine as they could
  double heightNoise = 0.0;             ///< of a sample across the surface, length
  std::unique_ptr<PointCloud> averages; ///< if not the graph's points

  CriticalField field; ///< f~ in space, if it is not the polynomial of the fits

  double fitCount() const { return static_cast<double>(this->neighborCount) / this->blockSize; }
};

/**
 * The scale at which Hessians can be told from noise: the smallest neighborhoods in which, at the
 * median of sites spread over the samples, the standard error of the Hessian is a small fraction of
 * it and which are wide compared with the noise across the surface. One degree more than asked for
 * where there is no noise: derivatives cost a degree.
 *
 * Where this takes many neighbors, blocks of samples along the Morton order are averaged first,
 * which loses hardly anything and makes fits cheap.
 *
 * @param values f at the points of the graph, of range 1
 */
CriticalScale chooseCriticalScale(const NeighborGraph& graph, const Values& values,
  const CriticalPointParameters& parameters, const Execution& execution);

} // namespace SurfaceScalars
