#pragma once

#include "Field.h"
#include "MeshInput.h"
#include "ModelCriticalPoints.h"

#include <optional>
#include <string>

class vtkDataObject;
class vtkInformationVector;

namespace SurfaceScalars
{

/// A model that takes the place of a point array.
struct NamedField
{
  Field field;
  std::string name; ///< of its values
};

/// The model of an input port, none if nothing is there.
/// @throws InvalidInput for anything but a model
std::optional<NamedField> modelOfPort(vtkDataObject* input, const Execution& execution);

/// Its values at places. Those outside of the box around the centers, widened by a twentieth of its
/// diagonal, are counted in a note.
PlaceFunction placeFunctionOf(FilterRun& run, const NamedField& model);

/// Adds the field data CandidateCount, RefinedCount, MergedCount, VanishedCount, GradientScale and
/// IndexSum to the first two ports of a filter, and says in a note what could not be refined and
/// why.
void writeRefinement(FilterRun& run, const ModelCriticalPoints& found, std::size_t candidates,
  const Field& model, const MeshTopology& topology, vtkInformationVector* outputs);

} // namespace SurfaceScalars
