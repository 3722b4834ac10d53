#pragma once

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

/// Marks of vtkGhostType.
namespace SurfaceScalars::FilterTest
{

/// Marks the points or cells for which a condition on their id holds, and no others.
template <class Condition>
void mark(
  vtkDataSetAttributes* attributes, vtkIdType count, unsigned char ghost, const Condition& isMarked)
{
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  for (vtkIdType id = 0; id < count; ++id)
  {
    ghosts->InsertNextValue(isMarked(id) ? ghost : 0);
  }
  attributes->AddArray(ghosts);
}

template <class Condition>
void markPoints(vtkDataSet* input, unsigned char ghost, const Condition& isMarked)
{
  mark(input->GetPointData(), input->GetNumberOfPoints(), ghost, isMarked);
}

/// Of a cell the condition sees the cell.
template <class Condition>
void markCells(vtkDataSet* input, unsigned char ghost, const Condition& isMarked)
{
  mark(input->GetCellData(), input->GetNumberOfCells(), ghost,
    [&](vtkIdType cell) { return isMarked(input->GetCell(cell)); });
}

} // namespace SurfaceScalars::FilterTest
