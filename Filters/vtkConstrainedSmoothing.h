/**
 * @class   vtkConstrainedSmoothing
 * @brief   smooths a function on a mesh and keeps the critical points that matter
 *
 * The input is a triangle mesh (quads and strips are cut up) and a point array f, chosen by
 * SetInputArrayToProcess(0, ...), by default the active scalars. The result is a point array
 * without the noise of f (Patane and Falcidieno, Computing Smooth Approximations of Scalar
 * Functions with Constraints, sec. 4). Methods:
 *
 * - FEATURE_PRESERVING: f is smoothed as by TIKHONOV; the extrema of the smooth function that
 *   Constraints chooses are kept, by default those whose persistence is at least
 *   PersistenceThreshold; all others are removed with the saddles that cancel them. The result has
 *   exactly these minima and maxima, and on a closed mesh as many saddles as Euler's formula asks
 *   for. A persistent extremum of f without a counterpart is named in a warning.
 *
 * - TIKHONOV, (3) and (5): the function x of least energy(x) + t |x - f|^2, measured by Metric.
 * Energy is that of the gradient (HARMONIC, t = Epsilon / area) or of the Laplacian (BIHARMONIC, t
 * = Epsilon / area^2), so that Epsilon depends neither on unit nor on resolution.
 *
 * - INTERPOLATING_CONSTRAINTS, (6): the function of least energy that has the values of f at the
 *   vertices of Constraints. (The paper reduces this to a harmonic function, which is another one:
 *   HARMONIC.)
 *
 * - LEAST_SQUARES_CONSTRAINTS, (7): the function of least energy that comes close to these values,
 * as close as Epsilon says.
 *
 * The two last promise neither that constrained points remain critical nor that no others do.
 *
 * Port 0 is the input with the result as active scalars and field data: InputCriticalCounts and
 * OutputCriticalCounts (minima, saddles with their multiplicity, maxima of f and of the values
 * written, equal values told apart by the ids of points), EulerCharacteristic, LInfinityError (the
 * largest difference from f), SobolevSeminorm (the root of the energy), Epsilon (the one used; 0
 * where the method uses none).
 *
 * Port 1, CriticalPoints, has the critical points of the values written, as vtkMeshCriticalPoints.
 *
 * Port 2, ParameterCurve, is a table of what Epsilon was chosen from, empty if it was given:
 * Epsilon, Residual (the distance from f), Seminorm, GCV and Curvature of the L-curve.
 *
 * What depends on the mesh alone is kept for the next run on the same points and triangles: with
 * another Epsilon, threshold or time step only the equations are solved.
 *
 * Warnings and refusals are those of vtkMeshCriticalPoints; points that are left out get NaN.
 *
 * @sa vtkMeshCriticalPoints vtkMorseComplex
 */

#ifndef vtkConstrainedSmoothing_h
#define vtkConstrainedSmoothing_h

#include "SurfaceScalarsFiltersModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // for the memory

namespace SurfaceScalars
{
class SmoothingMesh;
template <class Mesh>
class MeshMemory;
}

class SURFACESCALARSFILTERS_EXPORT vtkConstrainedSmoothing : public vtkPolyDataAlgorithm
{
public:
  static vtkConstrainedSmoothing* New();
  vtkTypeMacro(vtkConstrainedSmoothing, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The numbers are fixed: state files keep them.
  enum MethodType
  {
    FEATURE_PRESERVING = 0,
    TIKHONOV = 1,                  ///< (3), (5)
    INTERPOLATING_CONSTRAINTS = 2, ///< (6)
    LEAST_SQUARES_CONSTRAINTS = 3  ///< (7)
  };

  /// The weights of the Laplacian. The numbers are fixed.
  enum WeightsType
  {
    COTANGENT = 3,
    NORMALIZED_COTANGENT = 4, ///< the same, rows divided by their sums
    MEAN_VALUE = 5            ///< not symmetric
  };

  /// How the distance from f is measured. The numbers are fixed.
  enum MetricType
  {
    IDENTITY = 0,    ///< every point alike
    MASS_MATRIX = 1, ///< by area, of linear finite elements
    LUMPED_MASS = 2  ///< by area, its row sums
  };

  /// What is made small. The numbers are fixed.
  enum EnergyType
  {
    HARMONIC = 0,  ///< the integral of the squared gradient
    BIHARMONIC = 1 ///< the integral of the squared Laplacian
  };

  /// How Epsilon is chosen. The numbers are fixed.
  enum EpsilonChoiceType
  {
    GCV = 0,     ///< generalized cross-validation
    L_CURVE = 1, ///< the corner of the L-curve
    MANUAL = 2   ///< by SetEpsilon()
  };

  /// What is kept, or constrained. The numbers are fixed.
  enum ConstraintsType
  {
    ALL_CRITICAL_POINTS = 0,
    DELTA_SIMPLIFIED = 1, ///< those of more than Delta
    PERSISTENT = 2,       ///< those of at least PersistenceThreshold
    MASK_ARRAY = 3        ///< points where ConstraintArray is not 0
  };

  ///@{
  /**
   * A MethodType. Default: FEATURE_PRESERVING.
   */
  vtkSetMacro(Method, int);
  vtkGetMacro(Method, int);
  ///@}

  ///@{
  /**
   * The weights of the Laplacian: a WeightsType. Default: COTANGENT.
   */
  vtkSetMacro(Weights, int);
  vtkGetMacro(Weights, int);
  ///@}

  ///@{
  /**
   * How the distance from f is measured: a MetricType. Default: IDENTITY, for noise that does not
   * depend on the area of a vertex.
   */
  vtkSetMacro(Metric, int);
  vtkGetMacro(Metric, int);
  ///@}

  ///@{
  /**
   * What is made small: an EnergyType. Default: BIHARMONIC.
   */
  vtkSetMacro(Energy, int);
  vtkGetMacro(Energy, int);
  ///@}

  ///@{
  /**
   * How Epsilon is chosen: an EpsilonChoiceType. Default: GCV.
   */
  vtkSetMacro(EpsilonChoice, int);
  vtkGetMacro(EpsilonChoice, int);
  ///@}

  ///@{
  /**
   * How close the result comes to f, if EpsilonChoice is MANUAL; above 0, without unit. Details are
   * smoothed below a length of about sqrt(area) / Epsilon^(1/4) (BIHARMONIC). Default: 1e5.
   */
  vtkSetMacro(Epsilon, double);
  vtkGetMacro(Epsilon, double);
  ///@}

  ///@{
  /**
   * What is kept, or constrained: a ConstraintsType. Not for TIKHONOV. Default: PERSISTENT.
   */
  vtkSetMacro(Constraints, int);
  vtkGetMacro(Constraints, int);
  ///@}

  ///@{
  /**
   * Of PERSISTENT: critical points of less persistence are not kept; a fraction of the range of f,
   * 0 to 1. Default: 0.
   */
  vtkSetMacro(PersistenceThreshold, double);
  vtkGetMacro(PersistenceThreshold, double);
  ///@}

  ///@{
  /**
   * Of DELTA_SIMPLIFIED: critical points of at most this delta (see vtkMeshCriticalPoints) are not
   * kept; a fraction of the range of f, 0 to 1. Default: 0, all are.
   */
  vtkSetMacro(Delta, double);
  vtkGetMacro(Delta, double);
  ///@}

  ///@{
  /**
   * Of MASK_ARRAY: the name of a point array, not 0 where points are kept. The same as
   * SetInputArrayToProcess(1, ...).
   */
  void SetConstraintArray(const char* name);
  const char* GetConstraintArray();
  ///@}

  ///@{
  /**
   * Whether INTERPOLATING_CONSTRAINTS and LEAST_SQUARES_CONSTRAINTS constrain the neighbors of
   * constrained points, too. Default: on.
   */
  vtkSetMacro(IncludeOneStars, bool);
  vtkGetMacro(IncludeOneStars, bool);
  vtkBooleanMacro(IncludeOneStars, bool);
  ///@}

  ///@{
  /**
   * Whether the constraints' values are those of smoothed f instead of f. Default: on.
   */
  vtkSetMacro(SmoothedStars, bool);
  vtkGetMacro(SmoothedStars, bool);
  vtkBooleanMacro(SmoothedStars, bool);
  ///@}

  ///@{
  /**
   * Name of the result. Default: SmoothedScalars, also if empty.
   */
  vtkSetStringMacro(ResultArrayName);
  vtkGetStringMacro(ResultArrayName);
  ///@}

protected:
  vtkConstrainedSmoothing();
  ~vtkConstrainedSmoothing() override;

  int FillOutputPortInformation(int port, vtkInformation* information) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkConstrainedSmoothing(const vtkConstrainedSmoothing&) = delete;
  void operator=(const vtkConstrainedSmoothing&) = delete;

  int Method = FEATURE_PRESERVING;
  int Weights = COTANGENT;
  int Metric = IDENTITY;
  int Energy = BIHARMONIC;
  int EpsilonChoice = GCV;
  double Epsilon = 1e5;
  int Constraints = PERSISTENT;
  double PersistenceThreshold = 0.0;
  double Delta = 0.0;
  bool IncludeOneStars = true;
  bool SmoothedStars = true;
  char* ResultArrayName = nullptr;
  std::unique_ptr<SurfaceScalars::MeshMemory<SurfaceScalars::SmoothingMesh>> Memory;
};

#endif
