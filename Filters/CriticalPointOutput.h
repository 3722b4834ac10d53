#pragma once

#include "CriticalPoint.h"
#include "FuzzyCriticalPoints.h"
#include "ModelCriticalPoints.h"
#include "SurfaceVertices.h"

#include <string>
#include <vector>

class vtkPolyData;

namespace SurfaceScalars
{

class FilterRun;

/**
 * Adds the arrays CriticalProbability, Gradient, Normals and CriticalType to the points of the
 * output; where the map has no vertex they are NaN and -1. Arrays of these names become
 * `<name>Input`, with a warning.
 *
 * @param valueName f's name; f becomes the active scalars
 * @param execution the part of run.execution() this is
 * @throws Aborted
 */
void writeSampleCriticality(const SampleCriticality& samples, const VertexMap& map,
  const std::string& valueName, const FilterRun& run, const Execution& execution,
  vtkPolyData* output);

/// The critical points as vertices with the arrays CriticalType, Multiplicity, ScalarValue, PointId
/// (their `input`) and Persistence.
void writeCriticalPoints(const std::vector<CriticalPoint>& points, vtkPolyData* output);

/// The same with CriticalProbability and Residual.
void writeFuzzyCriticalPoints(const std::vector<CriticalPoint>& points, vtkPolyData* output);

/// The same with Residual, Iterations and Refined (0 or 1).
void writeModelCriticalPoints(const std::vector<ModelCriticalPoint>& points, vtkPolyData* output);

} // namespace SurfaceScalars
