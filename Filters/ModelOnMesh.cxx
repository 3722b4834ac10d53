#include "ModelOnMesh.h"

#include "FieldModelData.h"
#include "FilterRun.h"
#include "OutputArrays.h"
#include "Require.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace SurfaceScalars
{
namespace
{

constexpr double BoxMargin = 0.05; // of the diagonal

void noteOutsideOf(FilterRun& run, const Points& centers, const Points& places)
{
  Vector3d low = centers.rowwise().minCoeff();
  Vector3d high = centers.rowwise().maxCoeff();
  const double margin = BoxMargin * (high - low).norm();
  low.array() -= margin;
  high.array() += margin;
  const auto inside = (places.array() >= low.array().replicate(1, places.cols()) &&
    places.array() <= high.array().replicate(1, places.cols()))
                        .colwise()
                        .all();
  const Eigen::Index outside = places.cols() - inside.count();
  if (outside > 0)
  {
    run.note(std::to_string(outside) + " of " + std::to_string(places.cols()) +
      " points are outside of the model's extent, the box around its centers: what it says there "
      "is "
      "a guess.");
  }
}

bool hasSecondDerivatives(const FieldParameters& parameters)
{
  const bool usesKernel = parameters.scheme == Scheme::LocalRBF ||
    parameters.scheme == Scheme::Hybrid || parameters.scheme == Scheme::GlobalRBF;
  const KernelType kernel = parameters.kernel;
  return !usesKernel ||
    (kernel != KernelType::Exponential && kernel != KernelType::Linear &&
      kernel != KernelType::ThinPlate);
}

void noteUnrefined(FilterRun& run, const ModelCriticalPoints& found, const Field& model,
  const MeshTopology& topology)
{
  const auto isLeft = [&](const ModelCriticalPoint& point)
  { return !point.isRefined() && !topology.isBoundary(static_cast<Index>(point.origin)); };
  const auto left = std::count_if(found.points.begin(), found.points.end(), isLeft);
  if (found.gradientScale == 0.0)
  {
    run.note("The model is constant on the mesh: there is nothing to refine.");
  }
  else if (left > 0)
  {
    const FieldParameters& parameters = model.model().parameters;
    run.note(std::to_string(left) + " of " + std::to_string(found.points.size()) +
      " critical points remain at points of the mesh (Refined 0): " +
      (hasSecondDerivatives(parameters)
          ? "the model or the surface is not resolved by the triangles there."
          : std::string("the kernel ") + nameOf(parameters.kernel) +
            " has no second derivatives at its centers; Cubic has."));
  }
}

} // namespace

std::optional<NamedField> modelOfPort(vtkDataObject* input, const Execution& execution)
{
  if (!input)
  {
    return {};
  }
  auto* data = vtkPolyData::SafeDownCast(input);
  require(data != nullptr, "a Model, which is polydata", input->GetClassName(),
    "Connect the output Model of RBF Extend, or a file of it saved with DataMode Binary.");
  NamedModel named = readModel(data);
  return NamedField{ Field(std::move(named.model), execution), named.valueName };
}

PlaceFunction placeFunctionOf(FilterRun& run, const NamedField& model)
{
  const auto values = [&run, &model](const Points& places, const Execution& execution)
  {
    noteOutsideOf(run, model.field.model().centers, places);
    FieldValues result = model.field.evaluate(places, {}, execution);
    for (Eigen::Index i = 0; i < places.cols(); ++i)
    {
      if (result.valid[static_cast<std::size_t>(i)] == 0)
      {
        result.values[i] = std::numeric_limits<double>::quiet_NaN();
      }
    }
    return result.values;
  };
  return { values, model.name };
}

void writeRefinement(FilterRun& run, const ModelCriticalPoints& found, std::size_t candidates,
  const Field& model, const MeshTopology& topology, vtkInformationVector* outputs)
{
  const auto refined = std::count_if(found.points.begin(), found.points.end(),
    [](const ModelCriticalPoint& point) { return point.isRefined(); });
  const vtkSmartPointer<vtkDataArray> arrays[] = {
    makeInt("CandidateCount", static_cast<int>(candidates)),
    makeInt("RefinedCount", static_cast<int>(refined)),
    makeInt("MergedCount", static_cast<int>(found.merged)),
    makeInt("VanishedCount", static_cast<int>(found.vanished)),
    makeDoubles("GradientScale", Values::Constant(1, found.gradientScale)),
    makeDoubles("IndexSum", Values::Constant(1, indexSum(found.points, topology))),
  };
  for (const auto& array : arrays)
  {
    addFieldData(run, array, vtkPolyData::GetData(outputs, 0)->GetFieldData());
    vtkPolyData::GetData(outputs, 1)->GetFieldData()->AddArray(array);
  }
  noteUnrefined(run, found, model, topology);
}

} // namespace SurfaceScalars
