/**
 * @class   vtkPointSetScalarFunction
 * @brief   functions of position, such as the height, at the points of a point set
 *
 * Adds a point array of double with the values of the chosen function and makes it the active
 * scalars (Patane and Falcidieno, Defining, Contouring, and Visualizing Scalar Functions on
 * Point-Sampled Surfaces, sec. 2.2). At a point p it is
 *
 * - HEIGHT: W(p) = <p, N>, the height in the direction N = Direction / |Direction|;
 *
 * - DISTANCE_TO_POINT: W(p) = |p - b|, the distance from b = Center;
 *
 * - DISTANCE_TO_PLANE: W(p) = |<p - b, N>|, the distance from the plane through b = Origin with the
 *   normal N = Normal / |Normal|, the same on both sides.
 *
 * All three are lengths in the unit of the coordinates; how long Direction and Normal are does not
 * matter.
 *
 * Polydata passes through with its cells; other point sets come out as polydata with one vertex per
 * point. The blocks of a composite dataset are merged, with the arrays that all of them have.
 *
 * Points with a NaN or infinite coordinate get NaN and are counted in one warning. An input array
 * that has the name of the result is renamed `<name>Input` with a warning.
 *
 * @warning A zero vector as Direction or Normal is refused.
 *
 * @sa vtkPointSetContour vtkElevationFilter
 */

#ifndef vtkPointSetScalarFunction_h
#define vtkPointSetScalarFunction_h

#include "SurfaceScalarsFiltersModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

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
    DISTANCE_TO_PLANE = 2
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
   * Name of the result. Default: empty, which means Height, DistanceToPoint or DistanceToPlane.
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
  char* ResultArrayName = nullptr;
};

#endif
