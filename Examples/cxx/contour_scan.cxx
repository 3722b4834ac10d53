// Contours the height of a scan: points without a mesh come in as text, curves go out as a .vtp
// file.
//
// usage: contour_scan SCAN.xyz CONTOURS.vtp [COUNT]
//
// Each line of SCAN.xyz begins with x y z; the rest of the line is not read. COUNT heights (20) are
// spread evenly between the lowest and the highest y.

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataObject.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPointSetContour.h>
#include <vtkPointSetScalarFunction.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>

namespace
{

bool read(const std::string& path, vtkPolyData* scan)
{
  std::ifstream file(path);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  std::string line;
  while (std::getline(file, line))
  {
    double x, y, z;
    if (std::istringstream(line) >> x >> y >> z)
    {
      points->InsertNextPoint(x, y, z);
    }
  }
  scan->SetPoints(points);
  return points->GetNumberOfPoints() > 0;
}

} // namespace

int main(int argc, char* argv[])
{
  if (argc < 3)
  {
    std::cerr << "usage: contour_scan SCAN.xyz CONTOURS.vtp [COUNT]\n";
    return EXIT_FAILURE;
  }
  const int count = argc > 3 ? std::atoi(argv[3]) : 20;

  vtkNew<vtkPolyData> scan;
  if (!read(argv[1], scan))
  {
    std::cerr << argv[1] << ": no points found\n";
    return EXIT_FAILURE;
  }

  vtkNew<vtkPointSetScalarFunction> height;
  height->SetInputData(scan);
  height->SetFunction(vtkPointSetScalarFunction::HEIGHT);
  height->SetDirection(0, 1, 0);
  height->Update();
  double range[2];
  height->GetOutput()->GetPointData()->GetArray("Height")->GetRange(range);

  vtkNew<vtkPointSetContour> contour;
  contour->SetInputConnection(height->GetOutputPort());
  contour->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Height");
  contour->SetNumberOfContourValues(count);
  for (int i = 0; i < count; ++i)
  {
    contour->SetContourValues(i, range[0] + (i + 0.5) / count * (range[1] - range[0]));
  }
  contour->Update();

  vtkPolyData* curves = contour->GetOutput();
  vtkDataArray* closed = curves->GetCellData()->GetArray("Closed");
  if (!closed)
  {
    return EXIT_FAILURE; // the filter has said why
  }
  vtkIdType closedCount = 0;
  for (vtkIdType i = 0; i < closed->GetNumberOfTuples(); ++i)
  {
    closedCount += closed->GetComponent(i, 0) != 0;
  }

  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(curves);
  writer->SetFileName(argv[2]);
  writer->SetDataModeToBinary(); // every ParaView reads it: Documentation/troubleshooting.md
  if (!writer->Write())
  {
    return EXIT_FAILURE;
  }
  std::cout << scan->GetNumberOfPoints() << " points, " << count << " heights, "
            << curves->GetNumberOfLines() << " curves, " << closedCount << " of them closed\n";
  return EXIT_SUCCESS;
}
