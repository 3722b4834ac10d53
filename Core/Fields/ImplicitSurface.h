#pragma once

#include "FieldApproximation.h"
#include "PolynomialNeighborhood.h"
#include "SurfaceScalarsCoreExport.h"

#include <memory>

namespace SurfaceScalars
{

// The implicit surfaces of sec. 2.1: functions g that are 0 on the surface that samples lie on or
// close to and, nearby, about the distance to it. center() takes the samples around a place, jet()
// is g of these samples anywhere, with its exact gradient; only the radial one has Hessians.

/// Points of a surface and its unit normals there, consistently oriented (see NormalOrientation.h):
/// g is positive on their side.
struct OrientedSamples
{
  const PointCloud& cloud;
  const Points& normals;
};

/**
 * (1): the derivative along n(x) of the energy of the plane through x across n(x), where n(x) is
 * the direction in which the samples, weighted by exp(-(r/h)^2), spread least as seen from x.
 * Divided by twice the sum of the weights, which the paper leaves out: that makes it a length.
 *
 * @param kernelWidth h, length
 */
SURFACESCALARSCORE_EXPORT std::unique_ptr<FieldApproximation> makeExtremalSurface(
  const OrientedSamples& samples, double kernelWidth);

/**
 * (2): <x - b(x), n(x)> with b(x) the average of the samples with the same weights. Its gradient is
 * not n(x), as the paper says: n turns and b moves with x.
 */
SURFACESCALARSCORE_EXPORT std::unique_ptr<FieldApproximation> makeAverageSurface(
  const OrientedSamples& samples, double kernelWidth);

/// The height above the polynomial over the tangent plane that the parameterized fit (4)(5) makes
/// of the samples. The sign is any.
SURFACESCALARSCORE_EXPORT std::unique_ptr<FieldApproximation> makePolynomialSurface(
  const PointCloud& cloud, const FitSize& size, int degree);

/// How the conditions g(p_i) = 0, g(p_i +- delta n_i) = +-delta are met.
enum class RadialSurfaceFit
{
  Interpolate, ///< exactly, by radial functions around each of the 3 k places
  LeastSquares ///< closely, by radial functions around k samples or fewer
};

struct RadialSurfaceParameters
{
  RadialSurfaceFit fit = RadialSurfaceFit::Interpolate;
  KernelType kernel = KernelType::Cubic; ///< not Harmonic
  double kernelWidth = 0.0;              ///< h, length; 0 = from the sampling
};

/**
 * The radial implicit: a sum of radial functions and a linear polynomial that is 0 at the samples
 * around a place and +-delta at the places delta away from them along their normals.
 *
 * The paper asks for +-1 there; with +-delta g is a distance. It takes delta proportional to the
 * diagonal of all points, which knows nothing of how dense they are: here it is a third of the
 * neighborhood's radius, about a sampling step (and more than the noise wherever that asked for a
 * larger neighborhood), or less: never so much that another sample were closer to the offset place
 * than its own, as between two sheets. Where there is noise (LeastSquares) only samples of another
 * sheet, with a normal to the other side, shorten it.
 *
 * @throws InvalidInput from center() if the width makes the system singular
 */
SURFACESCALARSCORE_EXPORT std::unique_ptr<FieldApproximation> makeRadialSurface(
  const OrientedSamples& samples, const FitSize& size, const RadialSurfaceParameters& parameters);

} // namespace SurfaceScalars
