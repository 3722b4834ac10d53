#include "LevelSetOutput.h"

#include "OutputArrays.h"

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkTable.h"

namespace SurfaceScalars
{

void writeCovered(const FilterRun& run, const std::vector<char>& covered,
  const std::vector<vtkIdType>& cells, vtkDataSet* output)
{
  const auto array = makeInts("Covered", output->GetNumberOfCells());
  array->Fill(0);
  for (std::size_t i = 0; i < covered.size(); ++i)
  {
    if (covered[i] != 0)
    {
      array->SetValue(cells[i], 1);
    }
  }
  makeRoom(run, output->GetCellData(), "Covered");
  output->GetCellData()->AddArray(array);
}

void writeFigures(const FilterRun& run, const LevelSetCoverage& coverage,
  const LevelSetDistortion& distortion, vtkFieldData* data)
{
  const auto leftOut = static_cast<int>(distortion.leftOut);
  addFieldData(run, makeDoubles("GlobalCoverage", Values::Constant(1, coverage.global())), data);
  addFieldData(run, makeDoubles("OptimalIsoValues", coverage.isoValues), data);
  addFieldData(run,
    makeInt("DistortionIntervals", static_cast<int>(distortion.distances.size()) + leftOut), data);
  addFieldData(run, makeInt("LeftOutIntervals", leftOut), data);
}

void writeCoverage(const std::vector<double>& coverages, vtkTable* output)
{
  std::vector<int> counts;
  for (std::size_t k = 1; k <= coverages.size(); ++k)
  {
    counts.push_back((1 << k) - 1);
  }
  output->AddColumn(makeInts("IsoValueCount", counts));
  output->AddColumn(makeDoubles("Coverage",
    Eigen::Map<const Values>(coverages.data(), static_cast<Eigen::Index>(coverages.size()))));
}

void writeDistortion(const LevelSetDistortion& distortion, vtkTable* output)
{
  output->AddColumn(makeDoubles("IsoValue", distortion.isoValues));
  output->AddColumn(makeDoubles("NextIsoValue", distortion.nextIsoValues));
  output->AddColumn(makeDoubles("Distortion", distortion.distances));
}

} // namespace SurfaceScalars
