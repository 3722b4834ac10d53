/**
 * @class   vtkRBFEvaluate
 * @brief   evaluates a model made by vtkRBFExtend at the points of any dataset
 *
 * Input (port 0) is the output Model of vtkRBFExtend, or what was read back from a file of it; the
 * file must have been written in mode Binary. Target (port 1) is any dataset or composite of
 * datasets. The output is the target with `<result>`, `<result>Gradient`, `<result>Hessian` and
 * Valid, the same bits that vtkRBFExtend itself would give.
 *
 * @sa vtkRBFExtend
 */

#ifndef vtkRBFEvaluate_h
#define vtkRBFEvaluate_h

#include "SurfaceScalarsFiltersModule.h" // for the export macro
#include "vtkDataSetAlgorithm.h"

class SURFACESCALARSFILTERS_EXPORT vtkRBFEvaluate : public vtkDataSetAlgorithm
{
public:
  static vtkRBFEvaluate* New();
  vtkTypeMacro(vtkRBFEvaluate, vtkDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Where the model is evaluated.
   */
  void SetTargetConnection(vtkAlgorithmOutput* connection);
  void SetTargetData(vtkDataObject* data);
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
   * Name of the result. Default: empty, the name of the function the model was made of.
   */
  vtkSetStringMacro(ResultArrayName);
  vtkGetStringMacro(ResultArrayName);
  ///@}

protected:
  vtkRBFEvaluate();
  ~vtkRBFEvaluate() override;

  int FillInputPortInformation(int port, vtkInformation* information) override;
  int FillOutputPortInformation(int port, vtkInformation* information) override;
  int RequestDataObject(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkRBFEvaluate(const vtkRBFEvaluate&) = delete;
  void operator=(const vtkRBFEvaluate&) = delete;

  bool ComputeGradient = false;
  bool ComputeHessian = false;
  bool ClampToRange = false;
  double MaximumDistance = 0.0;
  double NullValue = 0.0;
  char* ResultArrayName = nullptr;
};

#endif
