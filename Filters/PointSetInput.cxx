#include "PointSetInput.h"

#include "Error.h"
#include "ScalarChoice.h"

#include "vtkAlgorithm.h"
#include "vtkArrayDispatch.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkDataSetAttributes.h"
#include "vtkImplicitFunction.h"
#include "vtkInformation.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace SurfaceScalars
{
namespace
{

constexpr std::size_t Grain = 1 << 16; // numbers per block of a parallel copy

struct CopyNumbers
{
  template <typename Array>
  void operator()(Array* from, double* to, const Execution& execution) const
  {
    const auto numbers = vtk::DataArrayValueRange(from);
    parallelFor(static_cast<std::size_t>(numbers.size()), Grain, execution,
      [&](std::size_t begin, std::size_t end)
      {
        std::transform(numbers.begin() + static_cast<vtkIdType>(begin),
          numbers.begin() + static_cast<vtkIdType>(end), to + begin,
          [](auto number) { return static_cast<double>(number); });
      });
  }
};

/// Collects the samples of all blocks in arrays of the full size; what is left out is overwritten
/// by what follows.
class SampleCollector
{
public:
  explicit SampleCollector(const std::vector<vtkPointSet*>& blocks)
  {
    vtkIdType capacity = 0;
    for (vtkPointSet* block : blocks)
    {
      capacity += block->GetNumberOfPoints();
    }
    this->samples_.points.resize(3, capacity);
    this->samples_.values.resize(capacity);
  }

  /// @param scalars null if the block has none; ignored if there is an implicit function
  void add(vtkPointSet* block, vtkDataArray* scalars, vtkImplicitFunction* function,
    const Execution& execution)
  {
    const vtkIdType count = block->GetNumberOfPoints();
    auto values = this->samples_.values.segment(this->kept_, count);
    copyNumbers(block->GetPoints()->GetData(), this->samples_.points.col(this->kept_).data(),
      execution.part(0.0, 0.5));
    if (function)
    {
      this->evaluate(*function, count, execution.part(0.5, 1.0));
    }
    else if (scalars)
    {
      copyNumbers(scalars, values.data(), execution.part(0.5, 1.0));
    }
    else
    {
      values.setConstant(std::numeric_limits<double>::quiet_NaN());
    }
    this->compact(count, block->GetPointGhostArray());
  }

  /// Hands over what was kept; the note counts what is missing.
  Samples finish(FilterRun& run)
  {
    const vtkIdType total = this->kept_ + this->missing_;
    if (this->missing_ > 0)
    {
      run.note("Left out " + std::to_string(this->missing_) + " of " + std::to_string(total) +
        " points whose position or value is NaN, infinite or missing.");
    }
    if (this->kept_ == 0)
    {
      throw InvalidInput("points with a finite position and value",
        "none among " + std::to_string(total), "Choose another array or another input.");
    }
    if (this->kept_ < this->samples_.points.cols())
    {
      this->samples_.points.conservativeResize(3, this->kept_);
      this->samples_.values.conservativeResize(this->kept_);
    }
    return std::move(this->samples_);
  }

private:
  /// Implicit functions are not thread safe, and some do not stand NaN.
  void evaluate(vtkImplicitFunction& function, vtkIdType count, Execution execution)
  {
    execution.threadCount = 1;
    parallelFor(static_cast<std::size_t>(count), Grain, execution,
      [&](std::size_t begin, std::size_t end)
      {
        for (auto i = static_cast<Eigen::Index>(begin); i < static_cast<Eigen::Index>(end); ++i)
        {
          Vector3d place = this->samples_.points.col(this->kept_ + i);
          this->samples_.values(this->kept_ + i) = place.allFinite()
            ? function.FunctionValue(place.data())
            : std::numeric_limits<double>::quiet_NaN();
        }
      });
  }

  /// Closes the gaps that ghost and missing samples leave among the last `count`.
  void compact(vtkIdType count, vtkUnsignedCharArray* ghosts)
  {
    constexpr unsigned char elsewhere =
      vtkDataSetAttributes::DUPLICATEPOINT | vtkDataSetAttributes::HIDDENPOINT;
    Points& points = this->samples_.points;
    Values& values = this->samples_.values;
    const vtkIdType begin = this->kept_;
    for (vtkIdType i = begin; i < begin + count; ++i, ++this->read_)
    {
      if (ghosts && (ghosts->GetValue(i - begin) & elsewhere))
      {
        continue;
      }
      if (!std::isfinite(values(i)) || !points.col(i).allFinite())
      {
        ++this->missing_;
        continue;
      }
      points.col(this->kept_) = points.col(i);
      values(this->kept_) = values(i);
      this->noteId();
      ++this->kept_;
    }
  }

  /// Of the point read last, which is to be kept.
  void noteId()
  {
    std::vector<vtkIdType>& ids = this->samples_.ids;
    if (this->kept_ == this->read_)
    {
      return; // nothing was left out so far
    }
    if (ids.empty())
    {
      ids.resize(static_cast<std::size_t>(this->kept_));
      std::iota(ids.begin(), ids.end(), vtkIdType{ 0 });
    }
    ids.push_back(this->read_);
  }

  Samples samples_;
  vtkIdType read_ = 0;
  vtkIdType kept_ = 0;
  vtkIdType missing_ = 0;
};

/// @param choice null if the values come from the function
Samples collect(FilterRun& run, const Execution& execution, const std::vector<vtkPointSet*>& blocks,
  const ScalarChoice* choice, vtkImplicitFunction* function)
{
  SampleCollector collector(blocks);
  const auto parts = static_cast<double>(blocks.size());
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    const auto part = static_cast<double>(i);
    collector.add(blocks[i], choice ? choice->arrays[i] : nullptr, function,
      execution.part(part / parts, (part + 1.0) / parts));
  }
  return collector.finish(run);
}

} // namespace

void acceptPointSets(vtkInformation* port)
{
  port->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  port->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  port->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
}

std::vector<vtkPointSet*> pointSetsOf(vtkDataObject* input)
{
  std::vector<vtkPointSet*> blocks;
  const auto add = [&blocks](vtkDataObject* block)
  {
    auto* points = vtkPointSet::SafeDownCast(block);
    if (!points)
    {
      throw InvalidInput("points", std::string("a block of type ") + block->GetClassName(),
        "Extract the blocks that are point sets (Extract Block).");
    }
    if (points->GetNumberOfPoints() > 0)
    {
      blocks.push_back(points);
    }
  };
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(input))
  {
    const auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      add(iterator->GetCurrentDataObject());
    }
  }
  else if (input)
  {
    add(input);
  }
  if (blocks.empty())
  {
    throw InvalidInput("points", "none", "Check what is upstream.");
  }
  return blocks;
}

void copyNumbers(vtkDataArray* from, double* to, const Execution& execution)
{
  const CopyNumbers copy;
  if (!vtkArrayDispatch::Dispatch::Execute(from, copy, to, execution))
  {
    copy(from, to, execution); // a type VTK was built without fast access for
  }
}

Points readPoints(vtkPoints* points, const Execution& execution)
{
  Points read(3, points->GetNumberOfPoints());
  copyNumbers(points->GetData(), read.data(), execution);
  return read;
}

Samples readSamples(FilterRun& run, const Execution& execution, vtkDataObject* input)
{
  const std::vector<vtkPointSet*> blocks = pointSetsOf(input);
  const ScalarChoice choice = chooseScalars(run.filter(), blocks);
  Samples samples = collect(run, execution, blocks, &choice, nullptr);
  samples.valueName = choice.name;
  return samples;
}

Samples readSamples(
  FilterRun& run, const Execution& execution, vtkDataObject* input, vtkImplicitFunction& function)
{
  Samples samples = collect(run, execution, pointSetsOf(input), nullptr, &function);
  samples.valueName = "CutFunctionValue";
  return samples;
}

} // namespace SurfaceScalars
