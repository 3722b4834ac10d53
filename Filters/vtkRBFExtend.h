/**
 * @class   vtkRBFExtend
 * @brief   extends a function off its samples: to points, a mesh, a grid
 *
 * Input (port 0) is any dataset with a point array f, chosen by SetInputArrayToProcess(0, ...): its
 * points count, be it a cloud, a mesh, an image or another grid. Target (port 1, optional) is any
 * dataset or composite of datasets. The output is the target with f~ at its points;
 * vtkFieldAlgorithm says what f~ is.
 *
 * Port 0 has the target's type (so that for others than polydata it is GetOutputDataObject(0)); a
 * composite keeps its structure, and all arrays of the target pass through. Without a target it is
 * a uniform grid around the samples, vtkImageData.
 *
 * - Points: `<result>`, `<result>Gradient` (3 components), `<result>Hessian` (6: xx, yy, zz, xy,
 * yz, xz), Valid (0 or 1).
 *
 * Port 1, Model, is f~ itself: vertices at the centers with the point array Coefficient, and field
 * data that makes it self-contained. vtkRBFEvaluate evaluates it, also read back from a file
 * written in mode Binary, to the same bits.
 *
 * @warning Far from the samples f~ means little: see MaximumDistance.
 *
 * @sa vtkRBFEvaluate vtkFieldAlgorithm vtkPointInterpolator
 */

#ifndef vtkRBFExtend_h
#define vtkRBFExtend_h

#include "SurfaceScalarsFiltersModule.h" // for the export macro
#include "vtkFieldAlgorithm.h"

class SURFACESCALARSFILTERS_EXPORT vtkRBFExtend : public vtkFieldAlgorithm
{
public:
  static vtkRBFExtend* New();
  vtkTypeMacro(vtkRBFExtend, vtkFieldAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Where f~ is evaluated. Null or RemoveTarget() returns to the uniform grid.
   */
  void SetTargetConnection(vtkAlgorithmOutput* connection);
  void SetTargetData(vtkDataObject* data);
  void RemoveTarget();
  ///@}

  ///@{
  /**
   * Number of points of the uniform grid along each axis, at least 1. Default: 64, 64, 64.
   */
  vtkSetVector3Macro(GridDimensions, int);
  vtkGetVector3Macro(GridDimensions, int);
  ///@}

  ///@{
  /**
   * How far the uniform grid reaches beyond the samples on each side, a fraction of their extent
   * along that axis. (Where they have none, the grid is a tenth as thick as they are wide.)
   * Default: 0.05.
   */
  vtkSetMacro(GridPadding, double);
  vtkGetMacro(GridPadding, double);
  ///@}

  ///@{
  /**
   * Whether `<result>Gradient` and `<result>Hessian` are written. Default: off.
   */
  vtkSetMacro(ComputeGradient, bool);
  vtkGetMacro(ComputeGradient, bool);
  vtkBooleanMacro(ComputeGradient, bool);
  vtkSetMacro(ComputeHessian, bool);
  vtkGetMacro(ComputeHessian, bool);
  vtkBooleanMacro(ComputeHessian, bool);
  ///@}

  ///@{
  /**
   * Whether values are kept within f's range. Derivatives remain f~'s own. Default: off.
   */
  vtkSetMacro(ClampToRange, bool);
  vtkGetMacro(ClampToRange, bool);
  vtkBooleanMacro(ClampToRange, bool);
  ///@}

  ///@{
  /**
   * Whether Model gets the point array LeaveOneOutError: f at each center less what all other
   * centers predict there. Its size tells kernels and widths apart. Other schemes than
   * GLOBAL_RBF have none. Default: off.
   */
  vtkSetMacro(ComputeLeaveOneOutErrors, bool);
  vtkGetMacro(ComputeLeaveOneOutErrors, bool);
  vtkBooleanMacro(ComputeLeaveOneOutErrors, bool);
  ///@}

  ///@{
  /**
   * A length: targets farther from every sample get NullValue and Valid 0. Default: 0, unlimited.
   */
  vtkSetMacro(MaximumDistance, double);
  vtkGetMacro(MaximumDistance, double);
  ///@}

  ///@{
  /**
   * What is written where f~ is not defined. Default: 0.
   */
  vtkSetMacro(NullValue, double);
  vtkGetMacro(NullValue, double);
  ///@}

  ///@{
  /**
   * Name of the result. Default: empty, f's name.
   */
  vtkSetStringMacro(ResultArrayName);
  vtkGetStringMacro(ResultArrayName);
  ///@}

  int ProcessRequest(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

protected:
  vtkRBFExtend();
  ~vtkRBFExtend() override;

  int FillInputPortInformation(int port, vtkInformation* information) override;
  int FillOutputPortInformation(int port, vtkInformation* information) override;
  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkRBFExtend(const vtkRBFExtend&) = delete;
  void operator=(const vtkRBFExtend&) = delete;

  int GridDimensions[3] = { 64, 64, 64 };
  double GridPadding = 0.05;
  bool ComputeGradient = false;
  bool ComputeHessian = false;
  bool ClampToRange = false;
  bool ComputeLeaveOneOutErrors = false;
  double MaximumDistance = 0.0;
  double NullValue = 0.0;
  char* ResultArrayName = nullptr;
};

#endif
