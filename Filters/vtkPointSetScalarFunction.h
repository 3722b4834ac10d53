/**
 * @class   vtkPointSetScalarFunction
 * @brief   functions of position and functions on the surface, at the points of a point set
 *
 * Adds a point array of double with the values of the chosen function and makes it the active
 * scalars (Patane and Falcidieno, Defining, Contouring, and Visualizing Scalar Functions on
 * Point-Sampled Surfaces, sec. 2.2). Functions of the position p:
 *
 * - HEIGHT: W(p) = <p, N>, the height in the direction N = Direction / |Direction|;
 *
 * - DISTANCE_TO_POINT: W(p) = |p - b|, the distance from b = Center;
 *
 * - DISTANCE_TO_PLANE: W(p) = |<p - b, N>|, the distance from the plane through b = Origin with the
 *   normal N = Normal / |Normal|, the same on both sides.
 *
 * Functions on the surface, which the graph of nearest neighbors or, with some Weights but never
 * for GEODESIC, the triangles of polydata stand for:
 *
 * - GEODESIC: the length of the shortest way along the surface to the nearest source;
 *
 * - HARMONIC: f with Laplacian f = 0 except at constrained points, whose values are given: the
 *   smoothest function between them, with no extrema elsewhere (but with COTANGENT and
 *   NORMALIZED_COTANGENT, where triangles are obtuse);
 *
 * - LAPLACIAN_EIGENFUNCTION: f with -Laplacian f = lambda f, of the EigenIndex-th eigenvalue lambda
 *   in ascending order, integral of f^2 = 1; field data Eigenvalue holds lambda, 1 / length^2;
 *
 * - DIFFUSION: the heat that spreads in DiffusionTime from the sources, each of which starts with
 *   one unit, per area.
 *
 * Sources and constraints are chosen by SourceType. Their ids are those of the points of the input,
 * of all blocks of a composite one. Points at the same place share their value.
 *
 * Polydata passes through with its cells; other point sets come out as polydata with one vertex per
 * point. The blocks of a composite dataset are merged, with the arrays that all of them have.
 *
 * Points with a NaN or infinite coordinate get NaN and are counted in one warning; so are points
 * that no way leads to (GEODESIC) or that are in no triangle. An input array that has the name of
 * the result is renamed `<name>Input` with a warning.
 *
 * @warning A zero vector as Direction or Normal is refused, and so are sources that are missing or
 * have no finite coordinates, two values at one place, and a HARMONIC function on a surface of
 * several pieces one of which has no constraint.
 *
 * @sa vtkPointSetContour vtkFuzzyCriticalPoints vtkElevationFilter
 */

#ifndef vtkPointSetScalarFunction_h
#define vtkPointSetScalarFunction_h

#include "SurfaceScalarsFiltersModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

#include <vector> // for the lists

class SURFACESCALARSFILTERS_EXPORT vtkPointSetScalarFunction : public vtkPolyDataAlgorithm
{
public:
  static vtkPointSetScalarFunction* New();
  vtkTypeMacro(vtkPointSetScalarFunction, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The numbers are fixed: state files keep them.
  enum FunctionType
  {
    HEIGHT = 0,
    DISTANCE_TO_POINT = 1,
    DISTANCE_TO_PLANE = 2,
    GEODESIC = 3,
    HARMONIC = 4,
    LAPLACIAN_EIGENFUNCTION = 5,
    DIFFUSION = 6
  };

  /// How sources and constraints are chosen. The numbers are fixed.
  enum SourceChoiceType
  {
    IDS = 0,       ///< by the ids of points
    SELECTION = 1, ///< by the second input
    POINT = 2      ///< as the points nearest to given places
  };

  /// The weights of the Laplacian. The numbers are fixed.
  enum WeightsType
  {
    GAUSSIAN = 0,             ///< (3): exp(-d^2 / h^2)
    DENSITY_NORMALIZED = 1,   ///< the second Laplacian of sec. 2.2
    LOCAL_SCALE = 2,          ///< exp(-3 d^2 / (sigma_i sigma_j)), for any density
    COTANGENT = 3,            ///< of triangles, as the following
    NORMALIZED_COTANGENT = 4, ///< the same, rows divided by their sums
    MEAN_VALUE = 5            ///< not symmetric: not for eigenfunctions
  };

  ///@{
  /**
   * The function: a FunctionType. Default: HEIGHT.
   */
  vtkSetMacro(Function, int);
  vtkGetMacro(Function, int);
  ///@}

  ///@{
  /**
   * The direction in which HEIGHT grows; of any length but 0. Default: (0, 0, 1).
   */
  vtkSetVector3Macro(Direction, double);
  vtkGetVector3Macro(Direction, double);
  ///@}

  ///@{
  /**
   * The point from which DISTANCE_TO_POINT is measured. Default: (0, 0, 0).
   */
  vtkSetVector3Macro(Center, double);
  vtkGetVector3Macro(Center, double);
  ///@}

  ///@{
  /**
   * A point of the plane from which DISTANCE_TO_PLANE is measured. Default: (0, 0, 0).
   */
  vtkSetVector3Macro(Origin, double);
  vtkGetVector3Macro(Origin, double);
  ///@}

  ///@{
  /**
   * A normal of that plane, of any length but 0. Default: (0, 0, 1).
   */
  vtkSetVector3Macro(Normal, double);
  vtkGetVector3Macro(Normal, double);
  ///@}

  ///@{
  /**
   * How sources and constraints are chosen: a SourceChoiceType. Default: IDS.
   */
  vtkSetMacro(SourceType, int);
  vtkGetMacro(SourceType, int);
  ///@}

  ///@{
  /**
   * The points from which GEODESIC measures and DIFFUSION starts, if SourceType is IDS.
   */
  void SetNumberOfSourceIds(int number);
  int GetNumberOfSourceIds();
  void SetSourceIds(int i, vtkIdType id); ///< adds ids up to i if there are fewer
  vtkIdType GetSourceIds(int i);
  ///@}

  ///@{
  /**
   * The place nearest to which they start, if SourceType is POINT. Default: (0, 0, 0).
   */
  vtkSetVector3Macro(SourcePoint, double);
  vtkGetVector3Macro(SourcePoint, double);
  ///@}

  ///@{
  /**
   * The points whose values HARMONIC is given, if SourceType is IDS.
   */
  void SetNumberOfConstraintIds(int number);
  int GetNumberOfConstraintIds();
  void SetConstraintIds(int i, vtkIdType id); ///< adds ids up to i if there are fewer
  vtkIdType GetConstraintIds(int i);
  ///@}

  ///@{
  /**
   * Their values, in the same order. If SourceType is SELECTION the selected points get them in the
   * order of their ids; if it is POINT, ConstraintPoint1 and ConstraintPoint2 get the first two. In
   * these cases none means values that rise evenly from 0 to 1.
   */
  void SetNumberOfConstraintValues(int number);
  int GetNumberOfConstraintValues();
  void SetConstraintValues(int i, double value); ///< adds values up to i if there are fewer
  double GetConstraintValues(int i);
  ///@}

  ///@{
  /**
   * The places whose nearest points are constrained, if SourceType is POINT. Default: (0, 0, 0) and
   * (1, 1, 1).
   */
  vtkSetVector3Macro(ConstraintPoint1, double);
  vtkGetVector3Macro(ConstraintPoint1, double);
  vtkSetVector3Macro(ConstraintPoint2, double);
  vtkGetVector3Macro(ConstraintPoint2, double);
  ///@}

  ///@{
  /**
   * The second input: a vtkSelection of points, or of cells whose points are meant, used if
   * SourceType is SELECTION.
   */
  void SetSelectionConnection(vtkAlgorithmOutput* connection);
  void SetSelectionData(vtkDataObject* selection);
  void RemoveSelection();
  ///@}

  ///@{
  /**
   * Which eigenfunction, by ascending eigenvalue, at most 299; 0 is constant on a connected
   * surface. Default: 1.
   */
  vtkSetMacro(EigenIndex, int);
  vtkGetMacro(EigenIndex, int);
  ///@}

  ///@{
  /**
   * For how long heat spreads, a length squared: about the square root of it far. Default: 0, the
   * square of a tenth of the diagonal of the bounding box.
   */
  vtkSetMacro(DiffusionTime, double);
  vtkGetMacro(DiffusionTime, double);
  ///@}

  ///@{
  /**
   * The weights of the Laplacian of HARMONIC, LAPLACIAN_EIGENFUNCTION and DIFFUSION: a WeightsType.
   * Default: LOCAL_SCALE.
   */
  vtkSetMacro(Weights, int);
  vtkGetMacro(Weights, int);
  ///@}

  ///@{
  /**
   * Number k of neighbors of each point in the graph, the point itself not counted. Default: 0,
   * which means 16.
   */
  vtkSetMacro(NeighborCount, int);
  vtkGetMacro(NeighborCount, int);
  ///@}

  ///@{
  /**
   * If positive, all points closer than this length are neighbors instead. Default: 0.
   */
  vtkSetMacro(SearchRadius, double);
  vtkGetMacro(SearchRadius, double);
  ///@}

  ///@{
  /**
   * The length h of the weights GAUSSIAN and DENSITY_NORMALIZED. Default: 0, chosen from the
   * sampling.
   */
  vtkSetMacro(KernelWidth, double);
  vtkGetMacro(KernelWidth, double);
  ///@}

  ///@{
  /**
   * Name of the result. Default: empty, which means that of the function: Height,
   * DistanceToPoint, DistanceToPlane, Geodesic, Harmonic, LaplacianEigenfunction or Diffusion.
   */
  vtkSetStringMacro(ResultArrayName);
  vtkGetStringMacro(ResultArrayName);
  ///@}

protected:
  vtkPointSetScalarFunction();
  ~vtkPointSetScalarFunction() override;

  int FillInputPortInformation(int port, vtkInformation* information) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkPointSetScalarFunction(const vtkPointSetScalarFunction&) = delete;
  void operator=(const vtkPointSetScalarFunction&) = delete;

  int Function = HEIGHT;
  double Direction[3] = { 0.0, 0.0, 1.0 };
  double Center[3] = { 0.0, 0.0, 0.0 };
  double Origin[3] = { 0.0, 0.0, 0.0 };
  double Normal[3] = { 0.0, 0.0, 1.0 };
  int SourceType = IDS;
  std::vector<vtkIdType> SourceIds;
  double SourcePoint[3] = { 0.0, 0.0, 0.0 };
  std::vector<vtkIdType> ConstraintIds;
  std::vector<double> ConstraintValues;
  double ConstraintPoint1[3] = { 0.0, 0.0, 0.0 };
  double ConstraintPoint2[3] = { 1.0, 1.0, 1.0 };
  int EigenIndex = 1;
  double DiffusionTime = 0.0;
  int Weights = LOCAL_SCALE;
  int NeighborCount = 0;
  double SearchRadius = 0.0;
  double KernelWidth = 0.0;
  char* ResultArrayName = nullptr;
};

#endif
