#include <vtkDataArray.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPointSetContour.h>
#include <vtkPointSetScalarFunction.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <cmath>
#include <cstdlib>
#include <iostream>

namespace
{

// A sunflower's points on the unit sphere: no cells.
vtkNew<vtkPolyData> sphere(int count)
{
  vtkNew<vtkPoints> points;
  for (int i = 0; i < count; ++i)
  {
    const double z = 1 - (2 * i + 1.0) / count;
    const double angle = i * vtkMath::Pi() * (3 - std::sqrt(5.0));
    const double radius = std::sqrt(1 - z * z);
    points->InsertNextPoint(radius * std::cos(angle), radius * std::sin(angle), z);
  }
  vtkNew<vtkPolyData> result;
  result->SetPoints(points);
  return result;
}

} // namespace

// The equator of a sphere is one closed curve.
int main()
{
  vtkNew<vtkPointSetScalarFunction> height;
  height->SetInputData(sphere(2000));

  vtkNew<vtkPointSetContour> contour;
  contour->SetInputConnection(height->GetOutputPort());
  contour->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Height");
  contour->SetNumberOfContourValues(1);
  contour->SetContourValues(0, 0.1);
  contour->Update();

  const vtkIdType curves = contour->GetOutput()->GetNumberOfLines();
  std::cout << "curves: " << curves << "\n";
  return curves == 1 ? EXIT_SUCCESS : EXIT_FAILURE;
}
