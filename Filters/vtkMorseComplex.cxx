#include "vtkMorseComplex.h"

#include "CriticalPointOutput.h"
#include "FilterRun.h"
#include "ListedPoints.h"
#include "MeshInput.h"
#include "MeshOutput.h"
#include "MorseComplex.h"
#include "PropertyChoice.h"
#include "SeparatrixOutput.h"

#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkMorseComplex);

using namespace SurfaceScalars;

namespace
{

// The shares of the whole that end with reading and topology.
constexpr double ReadShare = 0.2;
constexpr double TopologyShare = 0.4;

/// Leaves out the paths of saddles that are not among the own nodes, and nodes that are neither
/// among these nor on a path.
/// @param own by vertex
void leaveToOthers(MorseComplex& complex, const std::vector<CriticalPoint>& own)
{
  std::vector<char> isThere(static_cast<std::size_t>(complex.values.size()), 0); // vertices
  for (const CriticalPoint& node : own)
  {
    isThere[node.input] = 1;
  }
  std::vector<Separatrix>& paths = complex.separatrices;
  paths.erase(
    std::remove_if(paths.begin(), paths.end(),
      [&](const Separatrix& path) { return isThere[complex.nodes[path.source].input] == 0; }),
    paths.end());
  for (const Separatrix& path : paths)
  {
    for (const Index vertex : path.vertices)
    {
      isThere[vertex] = 1;
    }
  }
  std::vector<std::size_t> places;
  std::vector<CriticalPoint> nodes;
  for (const CriticalPoint& node : complex.nodes)
  {
    places.push_back(nodes.size());
    if (isThere[node.input] != 0)
    {
      nodes.push_back(node);
    }
  }
  complex.nodes = std::move(nodes);
  for (Separatrix& path : paths)
  {
    path.source = places[path.source];
    path.destination = places[path.destination];
  }
}

} // namespace

vtkMorseComplex::vtkMorseComplex()
{
  this->SetNumberOfOutputPorts(2);
}

vtkMorseComplex::~vtkMorseComplex() = default;

int vtkMorseComplex::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return runFilter(*this, "Morse Complex", outputs,
    [&](FilterRun& run)
    {
      checkFraction("PersistenceThreshold", this->PersistenceThreshold);
      const Execution& execution = run.execution();
      vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
      const MeshInput mesh = readMesh(run, execution.part(0.0, ReadShare), input);
      const MeshTopology topology = topologyOf(run, mesh, execution.part(ReadShare, TopologyShare));
      const double range = mesh.values.maxCoeff() - mesh.values.minCoeff();
      MorseComplex complex = morseComplex(mesh.surface.vertices, topology, mesh.values,
        this->PersistenceThreshold * range, execution.part(TopologyShare, 1.0));
      std::vector<CriticalPoint> own = complex.nodes;
      OtherVertices(input, mesh.surface.map).removeFrom(own);
      leaveToOthers(complex, own);

      writeSeparatrices(complex, mesh, run, vtkPolyData::GetData(outputs, 0));
      writeCriticalPoints(
        namedByPoints(complex.nodes, mesh.surface.map), vtkPolyData::GetData(outputs, 1));
      writeSummary(run, own, topology, outputs);
    });
}

void vtkMorseComplex::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PersistenceThreshold: " << this->PersistenceThreshold << "\n";
}
