/**
 * @class   vtkOsculatingParaboloid
 * @brief   how a function behaves around one of its samples
 *
 * Extends f off the neighborhood of one sample p by an analytic function F (vtkFieldAlgorithm) and
 * gives the iso-surface of F through p, inside a ball around p: "osculating paraboloid" in Patane
 * and Falcidieno, Defining, Contouring, and Visualizing Scalar Functions on Point-Sampled Surfaces,
 * sec. 3.2 and Fig. 8. Where it meets the surface that the points sample is the iso-curve through
 * p; around a critical point it touches that surface or crosses it in a saddle.
 *
 * The neighborhood is that of p everywhere: F is one smooth function. The iso-value is F(p), which
 * is f(p) for the schemes that interpolate.
 *
 * - Points: an array with f's name that holds the iso-value; Normals, the direction of the gradient
 *   of F, computed from F itself.
 *
 * @warning Where f is constant there is no such surface: the output is empty, with a warning.
 *
 * @sa vtkRBFExtend vtkPointSetContour
 */

#ifndef vtkOsculatingParaboloid_h
#define vtkOsculatingParaboloid_h

#include "SurfaceScalarsFiltersModule.h" // for the export macro
#include "vtkFieldAlgorithm.h"

class SURFACESCALARSFILTERS_EXPORT vtkOsculatingParaboloid : public vtkFieldAlgorithm
{
public:
  static vtkOsculatingParaboloid* New();
  vtkTypeMacro(vtkOsculatingParaboloid, vtkFieldAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The sample p: an id of the input's points. In a composite input the points of all blocks are
   * counted, in the order of the blocks. Default: 0.
   */
  vtkSetMacro(PointId, vtkIdType);
  vtkGetMacro(PointId, vtkIdType);
  ///@}

  ///@{
  /**
   * Radius of the ball, a length. Default: 0, the distance from p to the farthest sample of its
   * neighborhood (GLOBAL_RBF: to the 32nd).
   */
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /**
   * Number of voxels corners along each side of the cube around the ball, at least 2. Default: 48,
   * 48, 48.
   */
  vtkSetVector3Macro(GridDimensions, int);
  vtkGetVector3Macro(GridDimensions, int);
  ///@}

protected:
  vtkOsculatingParaboloid();
  ~vtkOsculatingParaboloid() override;

  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkOsculatingParaboloid(const vtkOsculatingParaboloid&) = delete;
  void operator=(const vtkOsculatingParaboloid&) = delete;

  vtkIdType PointId = 0;
  double Radius = 0.0;
  int GridDimensions[3] = { 48, 48, 48 };
};

#endif
