#include "vtkLevelSetDistribution.h"

#include "DomainInput.h"
#include "FieldTarget.h"
#include "FilterRun.h"
#include "GhostMarks.h"
#include "LevelSetOutput.h"
#include "PropertyChoice.h"
#include "Require.h"
#include "VolumeDomain.h"

#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkLevelSetDistribution);

using namespace SurfaceScalars;

namespace
{

constexpr int CoveragePort = 1;
constexpr int DistortionPort = 2;

// The shares of the whole that end with reading, coverage, topology and critical points.
constexpr double ReadShare = 0.1;
constexpr double CoverageShare = 0.15;
constexpr double TopologyShare = 0.25;
constexpr double CriticalShare = 0.35;

// What can be measured in some seconds: fronts take longer than searches.
constexpr double MostCrossings = 2e7;
constexpr double MostCrossingsOfFronts = 1e6;

bool isGeodesic(vtkLevelSetDistribution& filter)
{
  return filter.GetDistanceMeasure() == vtkLevelSetDistribution::GEODESIC;
}

void checkProperties(vtkLevelSetDistribution& filter)
{
  checkChoice(
    "DistanceMeasure", filter.GetDistanceMeasure(), { 0, 1 }, "0 (Hausdorff) or 1 (Geodesic)");
  checkFraction("PersistenceThreshold", filter.GetPersistenceThreshold());
  const int intervals = filter.GetMaximumIntervals();
  require(intervals == 0 || intervals >= 4, "MaximumIntervals of 4 or more, or 0",
    std::to_string(intervals), "0 chooses as many as take some seconds.");
}

/// Of triangles or tetrahedra that do not count in another piece; the others are not covered.
LevelSetCoverage coverageOf(
  vtkDataSet* input, const DomainInput& domain, double tolerance, const Execution& execution)
{
  const SimplicesRef simplices = domain.isVolume() ? SimplicesRef(domain.tetrahedra)
                                                   : SimplicesRef(domain.mesh.surface.triangles);
  const GhostMarks marks = GhostMarks::ofCells(input);
  std::vector<Eigen::Index> own;
  for (std::size_t i = 0; i < domain.cells.size(); ++i)
  {
    if (!marks.have(domain.cells[i], vtkDataSetAttributes::DUPLICATECELL))
    {
      own.push_back(static_cast<Eigen::Index>(i));
    }
  }
  require(!own.empty(), "cells that are no duplicates of another piece's",
    "none among " + std::to_string(input->GetNumberOfCells()), "Check what is upstream.");
  const Values& values = domain.mesh.values;
  if (own.size() == domain.cells.size())
  {
    return levelSetCoverage(domain.vertices(), simplices, values, tolerance, execution);
  }
  LevelSetCoverage coverage = levelSetCoverage(
    domain.vertices(), Simplices(simplices(Eigen::all, own)), values, tolerance, execution);
  std::vector<char> covered(domain.cells.size(), 0);
  for (std::size_t i = 0; i < own.size(); ++i)
  {
    covered[static_cast<std::size_t>(own[i])] = coverage.covered[i];
  }
  coverage.covered = std::move(covered);
  return coverage;
}

/// Ascending, of the critical points that reach the threshold, a fraction of f's range.
Values criticalValues(const ApproximationDomain& domain, const Values& values, double threshold,
  const Execution& execution)
{
  MeshCriticalPoints critical = domain.criticalPoints(values, execution);
  removeBelow(critical.points, critical.pairs, threshold * (values.maxCoeff() - values.minCoeff()));
  Values result(static_cast<Eigen::Index>(critical.points.size()));
  std::transform(critical.points.begin(), critical.points.end(), result.begin(),
    [](const CriticalPoint& point) { return point.value; });
  std::sort(result.begin(), result.end());
  return result;
}

/// The iso-values of the map: the optimal ones, or every second, fourth ... of them.
Values mapValues(vtkLevelSetDistribution& filter, const Simplices& edges, const Values& values,
  std::size_t optimalHalvings)
{
  const auto most = static_cast<int>(optimalHalvings);
  const int intervals = filter.GetMaximumIntervals();
  return dyadicIsoValues(values,
    intervals > 0 ? std::min(most, std::ilogb(intervals))
                  : affordableHalvings(edges, values, most,
                      isGeodesic(filter) ? MostCrossingsOfFronts : MostCrossings));
}

LevelSetDistortion distortionOf(vtkLevelSetDistribution& filter, FilterRun& run,
  DomainInput& domain, std::size_t halvings, const Execution& execution)
{
  const Execution ofTopology = execution.part(CoverageShare, TopologyShare);
  const Execution ofPoints = execution.part(TopologyShare, CriticalShare);
  const Execution ofMap = execution.part(CriticalShare, 1.0);
  const Points& vertices = domain.vertices();
  const Values& values = domain.mesh.values;
  const double threshold = filter.GetPersistenceThreshold();
  if (domain.isVolume())
  {
    const VolumeTopology volume(static_cast<Index>(vertices.cols()), std::move(domain.tetrahedra),
      ofTopology, domain.map().names());
    const Values critical =
      criticalValues(volumeDomain(vertices, volume), values, threshold, ofPoints);
    const Simplices edges = edgesOf(volume);
    return hausdorffDistortion(
      vertices, edges, values, mapValues(filter, edges, values, halvings), critical, ofMap);
  }
  const MeshTopology mesh = topologyOf(run, domain.mesh, ofTopology);
  const Values critical =
    criticalValues(surfaceDomain(vertices, mesh), values, threshold, ofPoints);
  const Simplices edges = edgesOf(mesh);
  const Values isoValues = mapValues(filter, edges, values, halvings);
  return isGeodesic(filter)
    ? geodesicDistortion(vertices, mesh, values, isoValues, critical, ofMap)
    : hausdorffDistortion(vertices, edges, values, isoValues, critical, ofMap);
}

void noteCoverage(FilterRun& run, const LevelSetCoverage& coverage)
{
  if (coverage.coverages.empty())
  {
    run.note(
      "The function is constant: no level set covers anything, and there are no iso-values.");
  }
  else if (!coverage.isStationary)
  {
    run.note("The coverage is not stationary at " + std::to_string(coverage.isoValues.size()) +
      " iso-values, where the search for more ends: most values are crowded in a small part of the "
      "range. Leave out values that are far off, or raise CoverageTolerance.");
  }
}

void noteDistortion(FilterRun& run, const LevelSetDistortion& distortion)
{
  if (distortion.distances.size() == 0 && distortion.leftOut > 0)
  {
    run.note("All " + std::to_string(distortion.leftOut) +
      " intervals of iso-values contain a critical value, so that there is no distortion to "
      "measure. Raise PersistenceThreshold if noise makes too many of them.");
  }
}

} // namespace

vtkLevelSetDistribution::vtkLevelSetDistribution()
{
  this->SetNumberOfOutputPorts(DistortionPort + 1);
}

vtkLevelSetDistribution::~vtkLevelSetDistribution() = default;

int vtkLevelSetDistribution::FillOutputPortInformation(int port, vtkInformation* information)
{
  information->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkDataSet" : "vtkTable");
  return 1;
}

int vtkLevelSetDistribution::RequestDataObject(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  giveTypes(*this, vtkDataObject::GetData(inputs[0]), "vtkPolyData", outputs);
  return 1;
}

int vtkLevelSetDistribution::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  askForAll(inputs[0]->GetInformationObject(0));
  return 1;
}

int vtkLevelSetDistribution::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return runFilter(*this, "Level Set Distribution", outputs,
    [&](FilterRun& run)
    {
      checkProperties(*this);
      vtkDataSet* input = vtkDataSet::GetData(inputs[0]);
      const Execution& execution = run.execution();
      DomainInput domain = readDomain(run, execution.part(0.0, ReadShare), input);
      require(!domain.isVolume() || !isGeodesic(*this), "DistanceMeasure Hausdorff for a volume",
        "Geodesic", "Distances within a volume are not offered: choose Hausdorff.");
      const LevelSetCoverage coverage = coverageOf(
        input, domain, this->CoverageTolerance, execution.part(ReadShare, CoverageShare));
      noteCoverage(run, coverage);
      LevelSetDistortion distortion;
      if (!coverage.coverages.empty())
      {
        distortion = distortionOf(*this, run, domain, coverage.coverages.size(), execution);
        noteDistortion(run, distortion);
      }

      vtkDataSet* output = vtkDataSet::GetData(outputs, 0);
      output->ShallowCopy(input);
      output->GetPointData()->SetActiveScalars(domain.mesh.valueName.c_str());
      writeCovered(run, coverage.covered, domain.cells, output);
      writeFigures(run, coverage, distortion, output->GetFieldData());
      writeCoverage(coverage.coverages, vtkTable::GetData(outputs, CoveragePort));
      writeDistortion(distortion, vtkTable::GetData(outputs, DistortionPort));
    });
}

void vtkLevelSetDistribution::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CoverageTolerance: " << this->CoverageTolerance << "\n";
  os << indent << "DistanceMeasure: " << this->DistanceMeasure << "\n";
  os << indent << "PersistenceThreshold: " << this->PersistenceThreshold << "\n";
  os << indent << "MaximumIntervals: " << this->MaximumIntervals << "\n";
}
