#include "vtkMorseComplex.h"

#include "CriticalPointOutput.h"
#include "FilterRun.h"
#include "MeshInput.h"
#include "MeshOutput.h"
#include "MorseComplex.h"
#include "PropertyChoice.h"
#include "SeparatrixOutput.h"

#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkMorseComplex);

using namespace SurfaceScalars;

namespace
{

// The shares of the whole that end with reading and topology.
constexpr double ReadShare = 0.2;
constexpr double TopologyShare = 0.4;

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
      const MeshInput mesh =
        readMesh(run, execution.part(0.0, ReadShare), vtkPolyData::GetData(inputs[0]));
      const MeshTopology topology = topologyOf(run, mesh, execution.part(ReadShare, TopologyShare));
      const double range = mesh.values.maxCoeff() - mesh.values.minCoeff();
      const MorseComplex complex = morseComplex(mesh.surface.vertices, topology, mesh.values,
        this->PersistenceThreshold * range, execution.part(TopologyShare, 1.0));

      writeSeparatrices(complex, mesh, run, vtkPolyData::GetData(outputs, 0));
      writeCriticalPoints(
        namedByPoints(complex.nodes, mesh.surface.map), vtkPolyData::GetData(outputs, 1));
      writeSummary(run, complex.nodes, topology, outputs);
    });
}

void vtkMorseComplex::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PersistenceThreshold: " << this->PersistenceThreshold << "\n";
}
