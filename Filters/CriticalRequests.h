#pragma once

#include "FunctionDesign.h"
#include "SurfaceVertices.h"

#include "vtkType.h"

#include <cstddef>
#include <string>
#include <vector>

class vtkDataObject;

namespace SurfaceScalars
{

class FilterRun;

/// Critical points that a function is to have.
struct CriticalRequests
{
  std::vector<CriticalRequest> requests; ///< those given as points, then those of a template
  std::vector<vtkIdType> points;         ///< of the former: which of CriticalPoints
  Points places;                         ///< and where
};

/**
 * Reads points with the arrays CriticalType (0 minimum, 1 saddle, 3 maximum), and, if there are
 * such, Multiplicity of saddles and ScalarValue, NaN where it is to be chosen. Of a composite
 * dataset all blocks are read, the ids of their points one after the other. A note counts the
 * uncertain, regular and excluded points, which ask for nothing.
 *
 * @param input what pointSetsOf() can read; null or without points: none are asked for
 * @returns requests whose vertices are not yet known
 * @throws InvalidInput that names a point: for other types, a multiplicity that is no positive
 * whole number, a place or value that is not finite; without CriticalType
 */
CriticalRequests readRequests(FilterRun& run, vtkDataObject* input);

/// Sets the vertices of requests given as points. @throws as nearestVertices()
void snapRequests(
  CriticalRequests& asked, const MeshedSurface& surface, const MeshTopology& mesh, double distance);

/// Adds those of a template that keep their star to themselves: next to a request given as a point,
/// or to a neighbor of one, they are left out and counted in a note.
void addTemplate(FilterRun& run, const MeshTopology& mesh,
  const std::vector<CriticalRequest>& ofTemplate, CriticalRequests& asked);

/// What requests are called: by the points they were given as, or that they are at.
PlaceName namesOf(const CriticalRequests& asked, const VertexMap& map);

} // namespace SurfaceScalars
