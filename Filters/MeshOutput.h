#pragma once

#include "MeshCriticalPoints.h"
#include "ParameterCurve.h"
#include "SimplificationCurve.h"
#include "SurfaceVertices.h"

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkInformationVector;
class vtkIntArray;
class vtkPolyData;
class vtkTable;

namespace SurfaceScalars
{

class FilterRun;

/// CriticalPoint::input is a vertex in what the mathematics finds, a point of the input in what
/// filters write.
std::vector<CriticalPoint> namedByPoints(std::vector<CriticalPoint> points, const VertexMap& map);

/**
 * Adds the arrays CriticalType and Multiplicity to the points of the output: those of the critical
 * points, else 5 (regular) and 0; -1 and 0 where the map has no vertex. Arrays of these names
 * become
 * `<name>Input`, with a warning.
 *
 * @param points with points of the output as `input`
 * @param valueName f's name; f becomes the active scalars
 */
void writeTypes(const std::vector<CriticalPoint>& points, const VertexMap& map,
  const std::string& valueName, const FilterRun& run, vtkPolyData* output);

/// Field data of three numbers: minima, saddles with their multiplicity, maxima.
vtkSmartPointer<vtkIntArray> makeCounts(const std::string& name, const CriticalCounts& counts);
vtkSmartPointer<vtkIntArray> makeEulerCharacteristic(const MeshTopology& topology);

/// Adds the field data CriticalCounts, of these points, and EulerCharacteristic to the first two
/// ports of a filter. What the first has of these names becomes `<name>Input`, with a warning.
void writeSummary(const FilterRun& run, const std::vector<CriticalPoint>& points,
  const MeshTopology& topology, vtkInformationVector* outputs);

/**
 * The pairs as lines from the extremum to the saddle with the cell arrays Persistence and PairType,
 * 0 of a minimum and 1 of a maximum. Points and their arrays are those of a port `CriticalPoints`.
 */
void writePairs(const std::vector<CriticalPoint>& points, const std::vector<CriticalPair>& pairs,
  vtkPolyData* output);

/// The columns Threshold, DeltaMinima, DeltaSaddles, DeltaMaxima and the same of Persistence.
void writeSimplification(const SimplificationCurve& curve, vtkTable* output);

/// The columns Epsilon, Residual, Seminorm, GCV and Curvature.
void writeParameterCurve(const ParameterCurve& curve, vtkTable* output);

} // namespace SurfaceScalars
