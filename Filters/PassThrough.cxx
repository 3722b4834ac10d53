#include "PassThrough.h"

#include "OutputArrays.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"

namespace SurfaceScalars
{
namespace
{

void passBlock(vtkPointSet* block, vtkPolyData* output)
{
  if (vtkPolyData::SafeDownCast(block))
  {
    output->ShallowCopy(block);
    return;
  }
  output->SetPoints(block->GetPoints());
  output->SetVerts(makeVertices(block->GetNumberOfPoints()));
  output->GetPointData()->ShallowCopy(block->GetPointData());
  output->GetFieldData()->ShallowCopy(block->GetFieldData());
}

} // namespace

void passThrough(const std::vector<vtkPointSet*>& blocks, vtkPolyData* output)
{
  if (blocks.size() == 1)
  {
    passBlock(blocks.front(), output);
    return;
  }
  vtkNew<vtkAppendPolyData> append;
  for (vtkPointSet* block : blocks)
  {
    vtkNew<vtkPolyData> part;
    passBlock(block, part);
    append->AddInputData(part);
  }
  append->Update();
  output->ShallowCopy(append->GetOutput());
}

} // namespace SurfaceScalars
