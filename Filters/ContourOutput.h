#pragma once

#include "LevelSets.h"

#include <string>

class vtkPolyData;

namespace SurfaceScalars
{

class FilterRun;

/// The name under which the iso-values are written: f's, or `<name>Input` and a warning if the
/// filter needs that name itself.
std::string isoValueName(const FilterRun& run, const std::string& valueName);

/// The curves as polylines with all arrays of the port `Contours`; a closed one ends with the id it
/// starts with.
void writeContours(const LevelSets& sets, const std::string& valueName, vtkPolyData* output);

/// The samples as vertices with all arrays of the port `Samples`.
void writeSamples(const LevelSets& sets, const std::string& valueName, vtkPolyData* output);

} // namespace SurfaceScalars
