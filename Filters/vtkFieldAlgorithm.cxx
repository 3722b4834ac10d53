#include "vtkFieldAlgorithm.h"

#include "Field.h"
#include "FieldMemory.h"
#include "FilterRun.h"
#include "KernelWidth.h"
#include "PointSetInput.h"
#include "PropertyChoice.h"

#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkInformation.h"

#include <string>
#include <utility>

using namespace SurfaceScalars;

namespace
{

FieldParameters parametersOf(vtkFieldAlgorithm& filter)
{
  checkChoice("Scheme", filter.GetScheme(), { 1, 2, 3, 4, 5 },
    "1 (ExplicitMLS), 2 (ParameterizedMLS), 3 (LocalRBF), 4 (Hybrid) or 5 (GlobalRBF)");
  checkChoice("Kernel", filter.GetKernel(), { 0, 1, 2, 3, 4, 5, 6, 7, 8 },
    "0 (Gaussian), 1 (Exponential), 2 (Linear), 3 (Cubic), 4 (ThinPlate), 5 (Multiquadric), 6 "
    "(InverseMultiquadric), 7 (Wendland) or 8 (Wu)");
  FieldParameters parameters;
  parameters.scheme = static_cast<Scheme>(filter.GetScheme());
  parameters.kernel = static_cast<KernelType>(filter.GetKernel());
  parameters.kernelWidth = filter.GetKernelWidth();
  parameters.neighborCount = filter.GetNeighborCount();
  parameters.searchRadius = filter.GetSearchRadius();
  parameters.polynomialDegree = filter.GetPolynomialDegree();
  parameters.regularization = filter.GetRegularization();
  parameters.hybridThreshold = filter.GetHybridThreshold();
  return parameters;
}

} // namespace

vtkFieldAlgorithm::vtkFieldAlgorithm()
  : Memory(std::make_unique<FieldMemory>())
{
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

vtkFieldAlgorithm::~vtkFieldAlgorithm() = default;

int vtkFieldAlgorithm::FillInputPortInformation(int, vtkInformation* information)
{
  acceptPointSets(information);
  return 1;
}

const Field& vtkFieldAlgorithm::FieldOf(
  Samples&& samples, FilterRun& run, const Execution& execution)
{
  const FieldParameters parameters = parametersOf(*this);
  const Field& field = this->Memory->fieldOf(std::move(samples), parameters, execution);
  const std::size_t contradictions = field.contradictionCount();
  if (contradictions > 0)
  {
    run.note("Places where samples contradict each other: " + std::to_string(contradictions) +
      ". There the mean of their values is used.");
  }
  const std::string remark = remarkOnWidth(parameters, field.cloud());
  if (!remark.empty())
  {
    run.note(remark);
  }
  return field;
}

void vtkFieldAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Scheme: " << this->Scheme << "\n";
  os << indent << "Kernel: " << this->Kernel << "\n";
  os << indent << "KernelWidth: " << this->KernelWidth << "\n";
  os << indent << "NeighborCount: " << this->NeighborCount << "\n";
  os << indent << "SearchRadius: " << this->SearchRadius << "\n";
  os << indent << "PolynomialDegree: " << this->PolynomialDegree << "\n";
  os << indent << "Regularization: " << this->Regularization << "\n";
  os << indent << "HybridThreshold: " << this->HybridThreshold << "\n";
}
