#include "DatasetCells.h"

#include "ExplicitPoints.h"
#include "GhostMarks.h"
#include "Require.h"
#include "SolidCells.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellTypes.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkUnsignedCharArray.h"

#include <string>

namespace SurfaceScalars
{
namespace
{

bool isFlat(int type)
{
  return type == VTK_TRIANGLE || type == VTK_TRIANGLE_STRIP || type == VTK_POLYGON ||
    type == VTK_PIXEL || type == VTK_QUAD;
}

void addFlatCell(int type, vtkIdList* corners, vtkCellArray* polygons)
{
  const vtkIdType* ids = corners->GetPointer(0);
  if (type == VTK_PIXEL)
  {
    polygons->InsertNextCell({ ids[0], ids[1], ids[3] });
    polygons->InsertNextCell({ ids[0], ids[3], ids[2] });
  }
  else if (type == VTK_TRIANGLE_STRIP)
  {
    for (vtkIdType i = 0; i + 2 < corners->GetNumberOfIds(); ++i)
    {
      polygons->InsertNextCell({ ids[i], ids[i + 1 + i % 2], ids[i + 2 - i % 2] });
    }
  }
  else
  {
    polygons->InsertNextCell(corners);
  }
}

} // namespace

CellCounts countCells(vtkDataSet* input)
{
  CellCounts counts;
  for (vtkIdType cell = 0; cell < input->GetNumberOfCells(); ++cell)
  {
    const int type = input->GetCellType(cell);
    const int tetrahedra = tetrahedronCount(type);
    counts.tetrahedra += tetrahedra;
    if (tetrahedra > 0)
    {
      ++counts.solid;
    }
    else if (isFlat(type))
    {
      ++counts.flat;
    }
    else if (type != VTK_EMPTY_CELL) // which is what is hidden in a grid
    {
      require(
        type == VTK_VERTEX || type == VTK_POLY_VERTEX || type == VTK_LINE || type == VTK_POLY_LINE,
        "cells that are triangles, quads, polygons, tetrahedra, voxels, hexahedra, wedges or "
        "pyramids",
        "a " + std::string(vtkCellTypes::GetClassNameFromTypeId(type)) + ", cell " +
          std::to_string(cell),
        "Apply Tetrahedralize first.");
      ++counts.other;
    }
  }
  return counts;
}

FlatCells flatCellsOf(vtkDataSet* input, const Execution& execution)
{
  FlatCells flat;
  const vtkSmartPointer<vtkPointSet> points = withExplicitPoints(input);
  const vtkNew<vtkCellArray> polygons;
  forEachCell(input, execution,
    [&](vtkIdType cell, int type, vtkIdList* corners)
    {
      if (isFlat(type))
      {
        addFlatCell(type, corners, polygons);
        flat.cells.resize(static_cast<std::size_t>(polygons->GetNumberOfCells()), cell);
      }
    });
  flat.surface->SetPoints(points->GetPoints());
  flat.surface->SetPolys(polygons);
  const GhostMarks marks = GhostMarks::ofCells(input);
  const vtkNew<vtkUnsignedCharArray> ofParts;
  ofParts->SetName(vtkDataSetAttributes::GhostArrayName());
  for (const vtkIdType cell : flat.cells)
  {
    ofParts->InsertNextValue(marks.of(cell));
  }
  flat.surface->GetCellData()->AddArray(ofParts);
  flat.surface->GetPointData()->ShallowCopy(input->GetPointData());
  return flat;
}

} // namespace SurfaceScalars
