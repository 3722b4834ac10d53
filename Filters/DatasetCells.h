#pragma once

#include "Basics.h"
#include "Execution.h"

#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <vector>

namespace SurfaceScalars
{

/// What the cells of a dataset are.
struct CellCounts
{
  vtkIdType flat = 0;
  vtkIdType solid = 0;
  vtkIdType other = 0;      ///< vertices and lines
  vtkIdType tetrahedra = 0; ///< that the solid ones are cut into
};

/// @throws InvalidInput that names a cell which can neither be cut into triangles or tetrahedra nor
/// is a vertex or line
CellCounts countCells(vtkDataSet* input);

/// Calls visit(cell, type, corners) for each cell that is not empty. @throws Aborted
template <class Visit>
void forEachCell(vtkDataSet* input, const Execution& execution, const Visit& visit)
{
  constexpr vtkIdType step = 1 << 14; // cells between two reports
  const vtkIdType count = input->GetNumberOfCells();
  const vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < count; ++cell)
  {
    if (cell % step == 0)
    {
      execution.report(static_cast<double>(cell) / static_cast<double>(count));
    }
    const int type = input->GetCellType(cell);
    if (type != VTK_EMPTY_CELL)
    {
      input->GetCellPoints(cell, corners);
      visit(cell, type, corners);
    }
  }
}

/// The flat cells of a dataset as polydata, whose cells are parts of those and marked as they are.
struct FlatCells
{
  vtkSmartPointer<vtkPolyData> surface = vtkSmartPointer<vtkPolyData>::New();
  std::vector<vtkIdType> cells; ///< of the dataset, by cell of the surface
};

FlatCells flatCellsOf(vtkDataSet* input, const Execution& execution);

} // namespace SurfaceScalars
