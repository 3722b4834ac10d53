#pragma once

#include "Field.h"
#include "FilterRun.h"

#include <string>

class vtkDataObject;
class vtkInformation;

namespace SurfaceScalars
{

/// What is to be written on a target.
struct TargetRequest
{
  EvaluationParameters evaluation;
  bool gradient = false;
  bool hessian = false;
  std::string resultName;
};

/// The request that the properties of vtkRBFExtend or vtkRBFEvaluate make.
/// @param valueName f's name, the result's if the user gave none
template <typename Filter>
TargetRequest targetRequestOf(Filter& filter, const std::string& valueName)
{
  TargetRequest request;
  request.gradient = filter.GetComputeGradient();
  request.hessian = filter.GetComputeHessian();
  request.evaluation.derivatives = request.hessian ? Derivatives::Hessian
    : request.gradient                             ? Derivatives::Gradient
                                                   : Derivatives::None;
  request.evaluation.maximumDistance = filter.GetMaximumDistance();
  request.evaluation.nullValue = filter.GetNullValue();
  request.evaluation.clampToRange = filter.GetClampToRange();
  const char* name = filter.GetResultArrayName();
  request.resultName = name && *name ? name : valueName;
  return request;
}

/// Makes a port accept any dataset and composites of them.
void acceptTargets(vtkInformation* port);

/// For RequestDataObject(): gives output 0 an empty object of the model's type, or of `otherwise`
/// where that is no dataset nor a composite (which the pipeline refuses once there is an output),
/// and the other ports those of their declared types; not to ports that have them.
void giveTypes(
  vtkAlgorithm& filter, vtkDataObject* model, const char* otherwise, vtkInformationVector* outputs);

/// For RequestUpdateExtent(), of data with an extent: without a request of its own an input would
/// get that of the output.
void askForAll(vtkInformation* input);

/// For RequestInformation(): what is known of the target is true of the output: the extent and
/// geometry of an image, the time steps.
void describeAsTarget(vtkInformation* target, vtkInformation* output);

/**
 * Makes `output`, of the target's type, the target with f~ at its points: `<result>`, which becomes
 * the active scalars, `<result>Gradient`, `<result>Hessian`, `Valid`. A composite keeps its
 * structure. Arrays of these names become `<name>Input`, with a warning. A target without points
 * gives empty arrays and a warning.
 */
void writeOnTarget(const Field& field, const TargetRequest& request, vtkDataObject* target,
  FilterRun& run, const Execution& execution, vtkDataObject* output);

} // namespace SurfaceScalars
