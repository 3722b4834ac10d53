#include "FieldTarget.h"

#include "Error.h"
#include "OutputArrays.h"

#include "vtkAlgorithm.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTypes.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <map>
#include <vector>

namespace SurfaceScalars
{
namespace
{

constexpr Eigen::Index BlockSize = 1 << 18; // targets evaluated at once, to bound the memory
constexpr const char* ValidName = "Valid";

/// The arrays of one dataset, and how values get into them.
class ResultArrays
{
public:
  ResultArrays(const TargetRequest& request, vtkIdType count)
    : values_(makeDoubles(request.resultName, count))
  {
    if (request.gradient)
    {
      this->gradients_ = makeDoubles(request.resultName + "Gradient", count, 3);
    }
    if (request.hessian)
    {
      this->hessians_ = makeDoubles(request.resultName + "Hessian", count, 6);
    }
    this->valid_->SetName(ValidName);
    this->valid_->SetNumberOfValues(count);
  }

  void set(vtkIdType begin, const FieldValues& block)
  {
    copy(block.values, begin, this->values_);
    copy(block.gradients, begin, this->gradients_);
    copy(block.hessians, begin, this->hessians_);
    std::copy(block.valid.begin(), block.valid.end(), this->valid_->GetPointer(begin));
    this->validCount_ += std::count(block.valid.begin(), block.valid.end(), 1);
  }

  vtkIdType validCount() const { return this->validCount_; }

  std::vector<vtkDataArray*> all() const
  {
    std::vector<vtkDataArray*> arrays = { this->values_, this->gradients_, this->hessians_,
      this->valid_ };
    arrays.erase(std::remove(arrays.begin(), arrays.end(), nullptr), arrays.end());
    return arrays;
  }

private:
  template <typename Numbers>
  static void copy(const Numbers& numbers, vtkIdType begin, vtkDoubleArray* array)
  {
    if (array)
    {
      std::copy_n(
        numbers.data(), numbers.size(), array->GetPointer(begin * array->GetNumberOfComponents()));
    }
  }

  vtkIdType validCount_ = 0;
  vtkSmartPointer<vtkDoubleArray> values_;
  vtkSmartPointer<vtkDoubleArray> gradients_;
  vtkSmartPointer<vtkDoubleArray> hessians_;
  vtkSmartPointer<vtkUnsignedCharArray> valid_ = vtkSmartPointer<vtkUnsignedCharArray>::New();
};

Points placesOf(vtkDataSet* target, vtkIdType begin, Eigen::Index count)
{
  Points places(3, count);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    target->GetPoint(begin + i, places.col(i).data());
  }
  return places;
}

/// Writes on one dataset after the other; collects the names that were taken.
class TargetWriter
{
public:
  TargetWriter(const Field& field, const TargetRequest& request)
    : field_(field)
    , request_(request)
  {
  }

  void write(vtkDataSet* target, const Execution& execution, vtkDataSet* output)
  {
    const vtkIdType count = target->GetNumberOfPoints();
    ResultArrays arrays(this->request_, count);
    for (vtkIdType begin = 0; begin < count; begin += BlockSize)
    {
      const auto size = std::min<vtkIdType>(BlockSize, count - begin);
      const auto fraction = [&](vtkIdType done)
      { return static_cast<double>(done) / static_cast<double>(count); };
      arrays.set(begin,
        this->field_.evaluate(placesOf(target, begin, size), this->request_.evaluation,
          execution.part(fraction(begin), fraction(begin + size))));
    }
    this->validCount_ += arrays.validCount();
    output->ShallowCopy(target);
    this->add(arrays, output->GetPointData());
  }

  vtkIdType validCount() const { return this->validCount_; }

  void warnOfTakenNames(const FilterRun& run) const
  {
    for (const auto& [name, renamed] : this->renamed_)
    {
      std::string sentence = "The result has an array '";
      sentence.append(name).append("'; the target's array of this name is now '").append(renamed);
      run.warn(sentence + "'.");
    }
  }

private:
  void add(const ResultArrays& arrays, vtkPointData* data)
  {
    for (vtkDataArray* array : arrays.all())
    {
      const std::string renamed = renameTaken(data, array->GetName());
      if (!renamed.empty())
      {
        this->renamed_[array->GetName()] = renamed;
      }
      data->AddArray(array);
    }
    data->SetActiveScalars(this->request_.resultName.c_str());
  }

  const Field& field_;
  const TargetRequest& request_;
  std::map<std::string, std::string> renamed_;
  vtkIdType validCount_ = 0;
};

/// Corresponding datasets of target and output.
struct Part
{
  vtkDataSet* target;
  vtkSmartPointer<vtkDataSet> output;
};

/// The leaves of a composite target, each with a new one in `output`.
std::vector<Part> partsOf(vtkCompositeDataSet* target, vtkCompositeDataSet* output)
{
  std::vector<Part> parts;
  output->CopyStructure(target);
  const auto leaves = vtkSmartPointer<vtkCompositeDataIterator>::Take(target->NewIterator());
  for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
  {
    auto* leaf = vtkDataSet::SafeDownCast(leaves->GetCurrentDataObject());
    if (!leaf)
    {
      throw InvalidInput("a Target of datasets",
        std::string("a block of type ") + leaves->GetCurrentDataObject()->GetClassName(),
        "Extract the blocks that have points (Extract Block).");
    }
    const auto copy = vtkSmartPointer<vtkDataSet>::Take(leaf->NewInstance());
    output->SetDataSet(leaves, copy);
    parts.push_back({ leaf, copy });
  }
  output->GetFieldData()->ShallowCopy(target->GetFieldData());
  return parts;
}

std::vector<Part> partsOf(vtkDataObject* target, vtkDataObject* output)
{
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(target))
  {
    return partsOf(composite, vtkCompositeDataSet::SafeDownCast(output));
  }
  return { { vtkDataSet::SafeDownCast(target), vtkDataSet::SafeDownCast(output) } };
}

} // namespace

void acceptTargets(vtkInformation* port)
{
  port->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  port->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  port->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
}

void giveTypes(
  vtkAlgorithm& filter, vtkDataObject* model, const char* otherwise, vtkInformationVector* outputs)
{
  const bool isTarget = vtkDataSet::SafeDownCast(model) || vtkCompositeDataSet::SafeDownCast(model);
  for (int port = 0; port < filter.GetNumberOfOutputPorts(); ++port)
  {
    const std::string type = port != 0
      ? filter.GetOutputPortInformation(port)->Get(vtkDataObject::DATA_TYPE_NAME())
      : (isTarget ? model->GetClassName() : otherwise);
    const vtkDataObject* present = vtkDataObject::GetData(outputs, port);
    if (!present || type != present->GetClassName())
    {
      outputs->GetInformationObject(port)->Set(vtkDataObject::DATA_OBJECT(),
        vtkSmartPointer<vtkDataObject>::Take(vtkDataObjectTypes::NewDataObject(type.c_str())));
    }
  }
}

void askForAll(vtkInformation* input)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  if (input->Has(Pipeline::WHOLE_EXTENT()))
  {
    input->Set(Pipeline::UPDATE_EXTENT(), input->Get(Pipeline::WHOLE_EXTENT()), 6);
  }
}

void describeAsTarget(vtkInformation* target, vtkInformation* output)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  output->CopyEntry(target, Pipeline::WHOLE_EXTENT());
  output->CopyEntry(target, vtkDataObject::ORIGIN());
  output->CopyEntry(target, vtkDataObject::SPACING());
  output->CopyEntry(target, vtkDataObject::DIRECTION());
  if (!output->Has(Pipeline::TIME_RANGE()))
  {
    output->CopyEntry(target, Pipeline::TIME_STEPS());
    output->CopyEntry(target, Pipeline::TIME_RANGE());
  }
}

void writeOnTarget(const Field& field, const TargetRequest& request, vtkDataObject* target,
  FilterRun& run, const Execution& execution, vtkDataObject* output)
{
  TargetRequest named = request;
  named.resultName = freeName(run, request.resultName, { ValidName });
  const std::vector<Part> parts = partsOf(target, output);
  vtkIdType total = 0;
  for (const Part& part : parts)
  {
    total += part.target->GetNumberOfPoints();
  }
  if (total == 0)
  {
    run.warn("The target has no points: there is nothing to compute.");
  }

  TargetWriter writer(field, named);
  double done = 0.0;
  for (const Part& part : parts)
  {
    const double share = total == 0
      ? 0.0
      : static_cast<double>(part.target->GetNumberOfPoints()) / static_cast<double>(total);
    writer.write(part.target, execution.part(done, done + share), part.output);
    done += share;
  }
  writer.warnOfTakenNames(run);
  if (total > 0 && writer.validCount() == 0)
  {
    run.warn("No target has a value: all have NullValue and Valid 0. Raise MaximumDistance or "
             "SearchRadius, or check that target and samples lie at the same place.");
  }
}

} // namespace SurfaceScalars
