#include "ExplicitPoints.h"

#include "OutputArrays.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

namespace SurfaceScalars
{

vtkSmartPointer<vtkPointSet> withExplicitPoints(vtkDataSet* dataset)
{
  if (!dataset || vtkPointSet::SafeDownCast(dataset))
  {
    return vtkPointSet::SafeDownCast(dataset);
  }
  const vtkIdType count = dataset->GetNumberOfPoints();
  const auto places = makeDoubles("Points", count, 3);
  for (vtkIdType point = 0; point < count; ++point)
  {
    dataset->GetPoint(point, places->GetPointer(3 * point));
  }
  const vtkNew<vtkPoints> points;
  points->SetData(places);
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  result->GetPointData()->ShallowCopy(dataset->GetPointData());
  result->GetFieldData()->ShallowCopy(dataset->GetFieldData());
  return result;
}

vtkSmartPointer<vtkDataObject> withExplicitPoints(vtkDataObject* input)
{
  if (auto* dataset = vtkDataSet::SafeDownCast(input))
  {
    return withExplicitPoints(dataset);
  }
  auto* composite = vtkCompositeDataSet::SafeDownCast(input);
  if (!composite)
  {
    return input;
  }
  auto result = vtkSmartPointer<vtkCompositeDataSet>::Take(composite->NewInstance());
  result->CopyStructure(composite);
  const auto leaves = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
  {
    result->SetDataSet(leaves, withExplicitPoints(leaves->GetCurrentDataObject()));
  }
  return result;
}

} // namespace SurfaceScalars
