#pragma once

#include "LaplacianFunctions.h"
#include "SurfaceVertices.h"

#include <vector>

class vtkDataObject;
class vtkPointSetScalarFunction;
class vtkSelection;

namespace SurfaceScalars
{

/// What points can be chosen from, and by what.
struct PointChoice
{
  vtkPointSetScalarFunction& filter; ///< its SourceType and what goes with it
  vtkDataObject* input;
  vtkSelection* selection; ///< null if there is none
  const Points& points;    ///< of all blocks
};

/// The vertices from which distance or heat spreads, each once.
/// @throws InvalidInput if there are none, or for points that do not exist or have no vertex
std::vector<Index> chosenSources(const PointChoice& choice, const VertexMap& map);

/**
 * The vertices whose values are given, each once. ConstraintValues follow the order of the points;
 * without any, they rise evenly from 0 to 1, except for those chosen by id.
 *
 * @throws InvalidInput as chosenSources(); for another number of values, values that are not
 * finite, or two values at one place
 */
std::vector<ValueConstraint> chosenConstraints(const PointChoice& choice, const VertexMap& map);

} // namespace SurfaceScalars
