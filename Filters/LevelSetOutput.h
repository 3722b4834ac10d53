#pragma once

#include "LevelSetCoverage.h"
#include "LevelSetDistortion.h"

#include "vtkType.h"

#include <vector>

class vtkDataSet;
class vtkFieldData;
class vtkTable;

namespace SurfaceScalars
{

class FilterRun;

/// Adds the cell array Covered, 1 for cells with a simplex that is covered, else 0. An array of
/// this name becomes `CoveredInput`, with a warning.
/// @param cells of the output, by simplex
void writeCovered(const FilterRun& run, const std::vector<char>& covered,
  const std::vector<vtkIdType>& cells, vtkDataSet* output);

/// Adds the field data GlobalCoverage, OptimalIsoValues, DistortionIntervals and LeftOutIntervals.
void writeFigures(const FilterRun& run, const LevelSetCoverage& coverage,
  const LevelSetDistortion& distortion, vtkFieldData* data);

/// The columns IsoValueCount and Coverage. @param coverages c_1, c_2, ...
void writeCoverage(const std::vector<double>& coverages, vtkTable* output);

/// The columns IsoValue, NextIsoValue and Distortion.
void writeDistortion(const LevelSetDistortion& distortion, vtkTable* output);

} // namespace SurfaceScalars
