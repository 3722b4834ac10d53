/**
 * @class   vtkScalarFunctionDesign
 * @brief   makes a smooth function on a mesh that has the critical points one asks for
 *
 * The input is a triangle mesh (quads and strips are cut up), no function is needed. CriticalPoints
 * says where minima, saddles and maxima are to be: points of any type or several blocks, such as
 * the output CriticalPoints of another filter, with the point arrays
 *
 * - CriticalType: 0 minimum, 1 saddle, 3 maximum. Points of type 4, 5 and -1 (uncertain, regular,
 *   excluded) ask for nothing;
 * - Multiplicity of saddles, 1 without it;
 * - ScalarValue: the value there, chosen where it is NaN or without the array.
 *
 * Each goes to the nearest vertex, at most MaximumDistance away. A TemplateArray, a function on the
 * mesh, gives further ones: its own, with the values there and around them; those next to
 * CriticalPoints are left out.
 *
 * The result is a function with these critical points (Patane, Mesh-based and Meshless Design and
 * Approximation of Scalar Functions, sec. 3):
 *
 * - MESH_BASED, sec. 3.2: the function of least Energy that has the values of the critical points
 *   and of their neighbors, which make them what they are (INTERPOLATING), or comes close to them
 *   (LEAST_SQUARES, as close as Epsilon says);
 *
 * - MESHLESS, sec. 3.3: a sum of radial functions about these vertices.
 *
 * INTERPOLATING keeps what was asked for. What Euler's formula asks for beyond that is added by
 * itself: max - saddles + min, saddles with their multiplicity, is the Euler characteristic of a
 * closed mesh. CleanUp removes what else was added.
 *
 * A saddle of multiplicity m needs 2 + 2m neighbors, on the boundary m + 2: where there are fewer,
 * the triangles around it are split, and the output has more points, after those of the input, with
 * point data as far along the edges.
 *
 * Port 0 is the mesh with the result as active scalars, the cell array Split (1 for parts of split
 * triangles) and the field data CriticalCounts (minima, saddles with their multiplicity, maxima),
 * EulerCharacteristic, Missing (how many were asked for and are not critical so), Added (how many
 * are critical and were not asked for) and Epsilon (of LEAST_SQUARES, else 0).
 *
 * Port 1, CriticalPoints, has the critical points of the values written, as vtkMeshCriticalPoints,
 * with the array Prescribed: 1 for those that were asked for, else 0. And the same field data.
 *
 * Port 2, ParameterCurve, is the table that Epsilon was chosen from, as of vtkConstrainedSmoothing;
 * empty if there was no choice.
 *
 * What depends on the mesh alone is kept for the next run on the same points and triangles: moving
 * a critical point does not factor anything again unless triangles are split anew.
 *
 * @sa vtkMeshCriticalPoints vtkConstrainedSmoothing vtkMorseComplex
 */

#ifndef vtkScalarFunctionDesign_h
#define vtkScalarFunctionDesign_h

#include "SurfaceScalarsFiltersModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // for the memory

namespace SurfaceScalars
{
class DesignMesh;
template <class Mesh>
class MeshMemory;
}

class SURFACESCALARSFILTERS_EXPORT vtkScalarFunctionDesign : public vtkPolyDataAlgorithm
{
public:
  static vtkScalarFunctionDesign* New();
  vtkTypeMacro(vtkScalarFunctionDesign, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The numbers are fixed: state files keep them.
  enum ApproachType
  {
    MESH_BASED = 0, ///< sec. 3.2
    MESHLESS = 1    ///< sec. 3.3
  };

  /// The numbers are fixed.
  enum ConstraintTypes
  {
    INTERPOLATING = 0, ///< (2): the values are met
    LEAST_SQUARES = 1  ///< (3): the values are approached
  };

  /// How the distance from the values is measured. The numbers are fixed.
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
    L_CURVE = 1, ///< the corner of the L-curve
    MANUAL = 2   ///< by SetEpsilon()
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
    WU = 8,                   ///< (1 - t)^4 (4 + 16 t + 12 t^2 + 3 t^3)
    HARMONIC_KERNEL = 9       ///< 1 / r, centers beside the surface
  };

  ///@{
  /**
   * The critical points that are asked for: points, or a composite dataset of points. Required
   * unless there is a TemplateArray. Null or RemoveCriticalPoints() takes them away.
   */
  void SetCriticalPointsConnection(vtkAlgorithmOutput* connection);
  void SetCriticalPointsData(vtkDataObject* data);
  void RemoveCriticalPoints();
  ///@}

  ///@{
  /**
   * How the function is made: an ApproachType. Default: MESH_BASED.
   */
  vtkSetMacro(Approach, int);
  vtkGetMacro(Approach, int);
  ///@}

  ///@{
  /**
   * Whether values are met or approached: a ConstraintTypes. Default: INTERPOLATING.
   */
  vtkSetMacro(ConstraintType, int);
  vtkGetMacro(ConstraintType, int);
  ///@}

  ///@{
  /**
   * Whether critical points that were not asked for are removed, as far as Euler's formula and the
   * prescribed ones allow. Default: off.
   */
  vtkSetMacro(CleanUp, bool);
  vtkGetMacro(CleanUp, bool);
  vtkBooleanMacro(CleanUp, bool);
  ///@}

  ///@{
  /**
   * Of MESH_BASED: what is made small, an EnergyType. Default: BIHARMONIC.
   */
  vtkSetMacro(Energy, int);
  vtkGetMacro(Energy, int);
  ///@}

  ///@{
  /**
   * Of MESH_BASED and LEAST_SQUARES: how the distance from the values is measured, a MetricType.
   * Default: IDENTITY.
   */
  vtkSetMacro(Metric, int);
  vtkGetMacro(Metric, int);
  ///@}

  ///@{
  /**
   * Of LEAST_SQUARES: how Epsilon is chosen, an EpsilonChoiceType. Default: L_CURVE.
   */
  vtkSetMacro(EpsilonChoice, int);
  vtkGetMacro(EpsilonChoice, int);
  ///@}

  ///@{
  /**
   * Of LEAST_SQUARES: how close the function comes to the values, if EpsilonChoice is MANUAL; above
   * 0, without unit. Default: 1e5.
   */
  vtkSetMacro(Epsilon, double);
  vtkGetMacro(Epsilon, double);
  ///@}

  ///@{
  /**
   * Of MESHLESS: the radial function, a KernelType. Default: CUBIC.
   */
  vtkSetMacro(Kernel, int);
  vtkGetMacro(Kernel, int);
  ///@}

  ///@{
  /**
   * Of MESHLESS: the width h of the kernel, length units. 0 = automatic. Default: 0.
   */
  vtkSetMacro(KernelWidth, double);
  vtkGetMacro(KernelWidth, double);
  ///@}

  ///@{
  /**
   * How far a critical point may be from the nearest vertex, length units. 0 = automatic: a
   * twentieth of the diagonal of the mesh, or the longest edge at that vertex. Default: 0.
   */
  vtkSetMacro(MaximumDistance, double);
  vtkGetMacro(MaximumDistance, double);
  ///@}

  ///@{
  /**
   * The name of a point array of the mesh whose critical points are asked for as well; null, empty
   * or "None" for none. The same as SetInputArrayToProcess(0, ...). Default: none.
   */
  void SetTemplateArray(const char* name);
  const char* GetTemplateArray();
  ///@}

  ///@{
  /**
   * Critical points of TemplateArray of less persistence are not asked for: a fraction of its
   * range, 0 to 1. Default: 0.
   */
  vtkSetMacro(PersistenceThreshold, double);
  vtkGetMacro(PersistenceThreshold, double);
  ///@}

  ///@{
  /**
   * Name of the result. Default: DesignedScalars, also if empty.
   */
  vtkSetStringMacro(ResultArrayName);
  vtkGetStringMacro(ResultArrayName);
  ///@}

protected:
  vtkScalarFunctionDesign();
  ~vtkScalarFunctionDesign() override;

  int FillInputPortInformation(int port, vtkInformation* information) override;
  int FillOutputPortInformation(int port, vtkInformation* information) override;
  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkScalarFunctionDesign(const vtkScalarFunctionDesign&) = delete;
  void operator=(const vtkScalarFunctionDesign&) = delete;

  int Approach = MESH_BASED;
  int ConstraintType = INTERPOLATING;
  bool CleanUp = false;
  int Energy = BIHARMONIC;
  int Metric = IDENTITY;
  int EpsilonChoice = L_CURVE;
  double Epsilon = 1e5;
  int Kernel = CUBIC;
  double KernelWidth = 0.0;
  double MaximumDistance = 0.0;
  double PersistenceThreshold = 0.0;
  char* ResultArrayName = nullptr;
  std::unique_ptr<SurfaceScalars::MeshMemory<SurfaceScalars::DesignMesh>> Given;
  std::unique_ptr<SurfaceScalars::MeshMemory<SurfaceScalars::DesignMesh>> Refined;
};

#endif
