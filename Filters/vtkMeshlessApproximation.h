/**
 * @class   vtkMeshlessApproximation
 * @brief   a function on a surface or volume as a sum of few radial functions
 *
 * The input is a surface (triangles, quads, strips; a flat image) or a volume (tetrahedra, voxels,
 * hexahedra, wedges, pyramids; an image) with n points and a point array f, chosen by
 * SetInputArrayToProcess(0, ...), by default the active scalars. The result is u, a sum of k << n
 * radial functions and a linear polynomial (Patane, Mesh-based and Meshless Design and
 * Approximation of Scalar Functions, sec. 4).
 *
 * - The persistent critical points of f and their neighbors, their stars, are centers, at which u
 * is f: each is critical in u as well, of the same type and multiplicity.
 *
 * - GREEDY: the other centers are a sparse cover, then in rounds the points where u misses f most.
 *
 * - LEVEL_SETS: the paper's. They are points of the level sets that cover the surface.
 *
 * - INTERPOLATING: u is f at all centers. LEAST_SQUARES: at those beside the stars it has the
 * values with which it comes nearest to f at four times as many places.
 *
 * Port 0 is the input with the point arrays `<result>`, u at the points, and ApproximationError,
 * f - u; NaN at points that are left out. Field data:
 *
 * - LInfinityError and MeanError, of |f - u| at the points, in f's unit;
 * - CentreCount, and StarCount of these;
 * - ModelBytes, of centers, coefficients and polynomial as doubles; ScalarBytes, of f's array as it
 *   is stored; SpaceSaving, 1 - ModelBytes / ScalarBytes. (Both need the geometry when u is to be
 *   known at the points; it is not counted.)
 * - ConditionNumber, an estimate, of the system that was solved;
 * - Missing, how many of f's persistent critical points are not so in u.
 *
 * Port 1, Model, is u itself, as of vtkRBFExtend: vtkRBFEvaluate evaluates it anywhere, also read
 * back from a file written in mode Binary, to the same bits.
 *
 * Port 2, CriticalPoints, has the critical points of u as vtkMeshCriticalPoints, in volumes also
 * 2-saddles (CriticalType 2), with the array Prescribed: 1 for f's persistent ones, else 0.
 *
 * What is left out and refused is as of vtkMeshCriticalPoints for surfaces. Volumes need not be
 * manifolds. A warning says what a user should know: noise whose stars take the centers away, more
 * centers asked for than a dense system can have, critical points that are missing. The blocks of a
 * composite dataset are worked on one by one.
 *
 * @sa vtkRBFEvaluate vtkRBFExtend vtkMeshCriticalPoints
 */

#ifndef vtkMeshlessApproximation_h
#define vtkMeshlessApproximation_h

#include "SurfaceScalarsFiltersModule.h" // for the export macro
#include "vtkDataSetAlgorithm.h"

class SURFACESCALARSFILTERS_EXPORT vtkMeshlessApproximation : public vtkDataSetAlgorithm
{
public:
  static vtkMeshlessApproximation* New();
  vtkTypeMacro(vtkMeshlessApproximation, vtkDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// How the centers beside the stars are chosen. The numbers are fixed.
  enum CentreSelectionType
  {
    GREEDY = 0,    ///< where u misses f
    LEVEL_SETS = 1 ///< the paper's: on level sets
  };

  /// What the values at centers beside the stars are. The numbers are fixed.
  enum LevelSetConstraintsType
  {
    INTERPOLATING = 0, ///< f's
    LEAST_SQUARES = 1, ///< those that come nearest to f around
    MINIMAX = 2        ///< those that make the largest error small
  };

  /// Of r = distance, h = KernelWidth, t = r / h. The numbers are fixed.
  enum KernelType
  {
    GAUSSIAN = 0,             ///< exp(-t^2)
    EXPONENTIAL = 1,          ///< exp(-t)
    LINEAR = 2,               ///< r
    CUBIC = 3,                ///< t^3
    THIN_PLATE = 4,           ///< t^2 log t
    MULTIQUADRIC = 5,         ///< sqrt(1 + t^2)
    INVERSE_MULTIQUADRIC = 6, ///< 1 / sqrt(1 + t^2)
    WENDLAND = 7,             ///< (1 - t)^4 (4 t + 1)
    WU = 8                    ///< (1 - t)^4 (4 + 16 t + 12 t^2 + 3 t^3)
  };

  ///@{
  /**
   * How the centers beside the stars are chosen: a CentreSelectionType. Default: GREEDY.
   */
  vtkSetMacro(CentreSelection, int);
  vtkGetMacro(CentreSelection, int);
  ///@}

  ///@{
  /**
   * What the values at centers beside the stars are: a LevelSetConstraintsType. Default:
   * INTERPOLATING.
   */
  vtkSetMacro(LevelSetConstraints, int);
  vtkGetMacro(LevelSetConstraints, int);
  ///@}

  ///@{
  /**
   * How many centers there are beside the stars: a fraction of the points, above 0 and at most 1.
   * Default: 0.01.
   */
  vtkSetMacro(SampleFraction, double);
  vtkGetMacro(SampleFraction, double);
  ///@}

  ///@{
  /**
   * Critical points of less persistence are not kept: a fraction of the range of f, 0 to 1.
   * Default: 0, all are kept; in noise these are too many.
   */
  vtkSetMacro(PersistenceThreshold, double);
  vtkGetMacro(PersistenceThreshold, double);
  ///@}

  ///@{
  /**
   * The radial function: a KernelType. Default: CUBIC.
   */
  vtkSetMacro(Kernel, int);
  vtkGetMacro(Kernel, int);
  ///@}

  ///@{
  /**
   * The width h of the kernel, length units. 0 = automatic. Default: 0.
   */
  vtkSetMacro(KernelWidth, double);
  vtkGetMacro(KernelWidth, double);
  ///@}

  ///@{
  /**
   * What is added to the diagonal of the kernel matrix: above 0, a system that is singular
   * otherwise can be solved, and not even stars are met exactly. Default: 0.
   */
  vtkSetMacro(Regularization, double);
  vtkGetMacro(Regularization, double);
  ///@}

  ///@{
  /**
   * Of LEVEL_SETS: level sets are added until no more of them change their coverage of the surface
   * by this much of its limit; above 0, below 1. Default: 1e-4.
   */
  vtkSetMacro(CoverageTolerance, double);
  vtkGetMacro(CoverageTolerance, double);
  ///@}

  ///@{
  /**
   * Name of the result. Default: empty, f's name followed by "Approximation".
   */
  vtkSetStringMacro(ResultArrayName);
  vtkGetStringMacro(ResultArrayName);
  ///@}

protected:
  vtkMeshlessApproximation();
  ~vtkMeshlessApproximation() override;

  int FillOutputPortInformation(int port, vtkInformation* information) override;
  int RequestDataObject(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkMeshlessApproximation(const vtkMeshlessApproximation&) = delete;
  void operator=(const vtkMeshlessApproximation&) = delete;

  int CentreSelection = GREEDY;
  int LevelSetConstraints = INTERPOLATING;
  double SampleFraction = 0.01;
  double PersistenceThreshold = 0.0;
  int Kernel = CUBIC;
  double KernelWidth = 0.0;
  double Regularization = 0.0;
  double CoverageTolerance = 1e-4;
  char* ResultArrayName = nullptr;
};

#endif
