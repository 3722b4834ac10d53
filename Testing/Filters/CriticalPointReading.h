#pragma once

#include "CriticalPoint.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataAlgorithm.h"

#include <vector>

namespace SurfaceScalars::FilterTest
{

/// The critical points of a port, read back; `input` is PointId.
inline std::vector<CriticalPoint> criticalPointsOf(vtkPolyDataAlgorithm* filter, int port = 1)
{
  std::vector<CriticalPoint> points;
  vtkPolyData* output = filter->GetOutput(port);
  const bool isFuzzy = output->GetPointData()->HasArray("CriticalProbability") != 0;
  const auto number = [&](const char* name, vtkIdType i)
  { return output->GetPointData()->GetArray(name)->GetTuple1(i); };
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    CriticalPoint point;
    point.position = Vector3d(output->GetPoint(i));
    point.type = static_cast<CriticalType>(static_cast<int>(number("CriticalType", i)));
    point.multiplicity = static_cast<int>(number("Multiplicity", i));
    point.value = number("ScalarValue", i);
    point.input = static_cast<std::size_t>(number("PointId", i));
    point.persistence = number("Persistence", i);
    if (isFuzzy)
    {
      point.probability = number("CriticalProbability", i);
      point.residual = number("Residual", i);
    }
    points.push_back(point);
  }
  return points;
}

} // namespace SurfaceScalars::FilterTest
