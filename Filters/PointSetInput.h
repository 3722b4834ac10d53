#pragma once

#include "Basics.h"
#include "FilterRun.h"

#include "vtkType.h"

#include <cstddef>
#include <string>
#include <vector>

class vtkDataArray;
class vtkDataObject;
class vtkImplicitFunction;
class vtkInformation;
class vtkPointSet;
class vtkPoints;

namespace SurfaceScalars
{

/// What a point-set filter works on: points and, for each, one value of the function; all finite.
struct Samples
{
  Points points;
  Values values;
  std::string valueName; ///< the array's name

  /// Where each is among the points of all blocks; empty if none was left out.
  std::vector<vtkIdType> ids;
  vtkIdType idOf(std::size_t sample) const
  {
    return this->ids.empty() ? static_cast<vtkIdType>(sample) : this->ids[sample];
  }
};

/// Makes a port accept what pointSetsOf() can read.
void acceptPointSets(vtkInformation* port);

/**
 * The parts of an input that have points: a vtkPointSet itself, or the blocks of a composite
 * dataset.
 *
 * @throws InvalidInput if there are no points at all, or a block that is not a point set
 */
std::vector<vtkPointSet*> pointSetsOf(vtkDataObject* input);

/// Copies an array of any numeric type, component by component, to `to`.
void copyNumbers(vtkDataArray* from, double* to, const Execution& execution);

/// The places of points.
Points readPoints(vtkPoints* points, const Execution& execution);

/**
 * Reads the points of an input and the array chosen by SetInputArrayToProcess(0, ...) as one set of
 * samples.
 *
 * Blocks are merged. Ghost and hidden points (vtkGhostType) are left out silently, for another
 * block has them; samples with a coordinate or value that is NaN, infinite or absent are left out
 * and counted in one note.
 *
 * @param execution the part of run.execution() this is
 * @throws InvalidInput if nothing is left, and as pointSetsOf() and chooseScalars(); Aborted
 */
Samples readSamples(FilterRun& run, const Execution& execution, vtkDataObject* input);

/// The same with the values of an implicit function; arrays are not read.
Samples readSamples(
  FilterRun& run, const Execution& execution, vtkDataObject* input, vtkImplicitFunction& function);

} // namespace SurfaceScalars
