#pragma once

#include "FunctionDesign.h"
#include "SurfaceVertices.h"

#include <string>

class vtkInformationVector;

namespace SurfaceScalars
{

class FilterRun;

/// Says in a note which requests are not critical in the result.
void noteMissing(FilterRun& run, const DesignedFunction& designed, const PlaceName& nameOf);

/// A mesh whose vertices are points of the output.
struct OutputMesh
{
  const MeshTopology& topology;
  const VertexMap& map;
};

/**
 * Adds the values as active scalars to the mesh on the first port, its critical points with the
 * array Prescribed to the second, and to both the field data CriticalCounts, EulerCharacteristic,
 * Missing, Added and Epsilon. What the mesh has of these names becomes `<name>Input`, with a
 * warning.
 *
 * @param name of the values
 */
void writeDesign(const FilterRun& run, const DesignedFunction& designed, const OutputMesh& mesh,
  const std::string& name, vtkInformationVector* outputs);

} // namespace SurfaceScalars
