#pragma once

#include "Execution.h"
#include "FieldJet.h"
#include "PointCloud.h"
#include "RadialKernel.h"
#include "SurfaceScalarsCoreExport.h"

#include <memory>

namespace SurfaceScalars
{

/// How f is extended off its samples; the numbers are those of the public interface.
enum class Scheme
{
  Linear = 0,           ///< linear along the edges of the neighbor graph
  ExplicitMLS = 1,      ///< weighted average, (6)
  ParameterizedMLS = 2, ///< polynomial over the tangent plane, (4)(5)
  LocalRBF = 3,         ///< radial functions at the neighbors, (8)-(10)
  Hybrid = 4,           ///< ExplicitMLS, and LocalRBF where that misses the samples (sec. 3.3)
  GlobalRBF = 5         ///< radial functions at all samples
};

struct FieldParameters
{
  Scheme scheme = Scheme::LocalRBF;      ///< not Linear
  KernelType kernel = KernelType::Cubic; ///< of the RBF schemes
  double kernelWidth = 0.0;      ///< h of ExplicitMLS and the RBF schemes, length; 0 = automatic
  int neighborCount = 0;         ///< k of the local schemes; 0 = automatic
  double searchRadius = 0.0;     ///< length; > 0 replaces neighborCount, which
                                 ///< ParameterizedMLS takes at least
  int polynomialDegree = 2;      ///< of ParameterizedMLS, 1 to 4
  double regularization = 0.0;   ///< of the RBF schemes: see RadialBasisFit
  double hybridThreshold = 0.01; ///< of Hybrid: e_MLS of a sample's neighborhood, root mean
                                 ///< square, as a fraction of f's range
};

/**
 * An extension f~ of a function off its samples, near one place: center() takes the neighborhood
 * and the frame of a place; jet() is the analytic function they define, with exact derivatives,
 * anywhere. (For a global scheme center() does nothing.)
 *
 * Places are relative to the origin of the cloud. Not for several threads at once.
 */
class SURFACESCALARSCORE_EXPORT FieldApproximation
{
public:
  virtual ~FieldApproximation();

  /// The places that come next, at least one, in an order in which neighbors follow each other:
  /// what the first of them have in common is found for all of these at once. Only makes center()
  /// faster. @returns how many these are
  virtual Eigen::Index expect(const PointsRef& places);

  /// @returns false where f~ is not defined: no sample is within the search radius, or those there
  /// do not determine it
  /// @throws InvalidInput if the system of a neighborhood is singular at machine precision
  virtual bool center(const Vector3d& place) = 0;
  /// After center() returned true.
  virtual FieldJet jet(const Vector3d& place, Derivatives derivatives) const = 0;
};

/// Finite samples of f: one value per point of the cloud. Both must outlive what is made of them.
struct FieldSamples
{
  const PointCloud& cloud;
  const Values& values;
};

} // namespace SurfaceScalars
