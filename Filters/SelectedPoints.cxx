#include "SelectedPoints.h"

#include "Error.h"

#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkExtractSelection.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkSmartPointer.h"

#include <cstddef>
#include <functional>
#include <string>

namespace SurfaceScalars
{
namespace
{

constexpr const char* InsideName = "vtkInsidedness"; // 1 where selected

void checkContent(vtkSelection* selection)
{
  for (unsigned i = 0; i < selection->GetNumberOfNodes(); ++i)
  {
    const int type = selection->GetNode(i)->GetContentType();
    if (type == vtkSelectionNode::QUERY || type == vtkSelectionNode::USER)
    {
      throw InvalidInput("a Selection of points or cells",
        std::string("one of type ") + vtkSelectionNode::GetContentTypeAsString(type),
        "Select points in a view.");
    }
  }
}

/// Marks the selected points of a block, which come first there.
void mark(vtkPointSet* block, char* selected)
{
  if (vtkDataArray* inside = block->GetPointData()->GetArray(InsideName))
  {
    for (vtkIdType i = 0; i < inside->GetNumberOfTuples(); ++i)
    {
      selected[i] |= inside->GetTuple1(i) > 0.0;
    }
  }
  vtkDataArray* inside = block->GetCellData()->GetArray(InsideName);
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; inside && cell < inside->GetNumberOfTuples(); ++cell)
  {
    if (inside->GetTuple1(cell) > 0.0)
    {
      block->GetCellPoints(cell, corners);
      for (vtkIdType i = 0; i < corners->GetNumberOfIds(); ++i)
      {
        selected[corners->GetId(i)] = 1;
      }
    }
  }
}

/// Goes through the blocks of an input and what became of them; null where nothing is selected.
void forEachBlock(vtkDataObject* input, vtkDataObject* output,
  const std::function<void(vtkDataObject*, vtkDataObject*)>& visit)
{
  auto* inputs = vtkCompositeDataSet::SafeDownCast(input);
  auto* outputs = vtkCompositeDataSet::SafeDownCast(output);
  if (!inputs)
  {
    visit(input, output);
    return;
  }
  const auto block = vtkSmartPointer<vtkCompositeDataIterator>::Take(inputs->NewIterator());
  for (block->InitTraversal(); !block->IsDoneWithTraversal(); block->GoToNextItem())
  {
    visit(block->GetCurrentDataObject(), outputs ? outputs->GetDataSet(block) : nullptr);
  }
}

/// The input with an array that tells what is selected.
vtkSmartPointer<vtkDataObject> markedInput(vtkSelection* selection, vtkDataObject* input)
{
  vtkNew<vtkExtractSelection> extract;
  extract->PreserveTopologyOn();
  extract->SetInputDataObject(0, input);
  extract->SetInputDataObject(1, selection);
  extract->Update();
  return extract->GetOutputDataObject(0);
}

} // namespace

std::vector<vtkIdType> selectedPoints(vtkSelection* selection, vtkDataObject* input)
{
  checkContent(selection);
  std::vector<char> selected;
  forEachBlock(input, markedInput(selection, input),
    [&selected](vtkDataObject* block, vtkDataObject* marked)
    {
      const auto count = vtkPointSet::SafeDownCast(block)->GetNumberOfPoints();
      const std::size_t first = selected.size();
      selected.resize(first + static_cast<std::size_t>(count), 0);
      auto* points = vtkPointSet::SafeDownCast(marked);
      if (points && points->GetNumberOfPoints() == count)
      {
        mark(points, selected.data() + first);
      }
    });

  std::vector<vtkIdType> ids;
  for (std::size_t i = 0; i < selected.size(); ++i)
  {
    if (selected[i])
    {
      ids.push_back(static_cast<vtkIdType>(i));
    }
  }
  return ids;
}

} // namespace SurfaceScalars
