// Whether designed functions have the critical points that are asked for, and which others, as
// tables in Markdown; fails if one that must be there is not.
//
//   surface-scalars-design-truth [reduced] [requests] [places] [tradeoff] [meshes FOLDER]
//
// requests: random points on meshes of genus 0 to 3; places: where functions have their critical
// points anyway, on the elephants of a folder as well; tradeoff: least squares by epsilon.

#include "Arguments.h"
#include "DesignRequests.h"
#include "LaplacianFunctions.h"
#include "MarkdownReport.h"
#include "MeshExamples.h"

#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>

using namespace SurfaceScalars;
using namespace SurfaceScalars::Truth;

namespace
{

constexpr unsigned CleanedUp = 5; // of the random requests, as crowded ones take long

struct Way
{
  std::string name;
  DesignParameters parameters;
};

Way meshBased(const std::string& name, SmoothingEnergy energy, DataMetric metric)
{
  Way way{ name, {} };
  way.parameters.energy = energy;
  way.parameters.metric = metric;
  return way;
}

Way meshless(const std::string& name, KernelType kernel)
{
  Way way{ name, {} };
  way.parameters.approach = DesignApproach::Meshless;
  way.parameters.kernel = kernel;
  return way;
}

Way leastSquares(const std::string& name, double epsilon)
{
  Way way{ name, {} };
  way.parameters.constraints = DesignConstraints::LeastSquares;
  way.parameters.epsilonChoice = epsilon > 0.0 ? EpsilonChoice::Manual : EpsilonChoice::LCurve;
  way.parameters.epsilon = epsilon > 0.0 ? epsilon : 1.0;
  return way;
}

std::vector<Way> allWays()
{
  return { meshBased("biharmonic", SmoothingEnergy::Biharmonic, DataMetric::Identity),
    meshBased("biharmonic, mass matrix", SmoothingEnergy::Biharmonic, DataMetric::MassMatrix),
    meshBased("harmonic", SmoothingEnergy::Harmonic, DataMetric::Identity),
    meshless("cubic", KernelType::Cubic), meshless("Gaussian", KernelType::Gaussian),
    meshless("1 / r, offset centers", KernelType::Harmonic),
    leastSquares("least squares, L-curve", 0.0) };
}

bool mustKeep(const Way& way)
{
  return way.parameters.constraints == DesignConstraints::Interpolating;
}

/// Of critical points asked for and found.
struct Tally
{
  int asked = 0;
  int kept = 0;
  int added = 0;
  int byWalking = 0; ///< of those asked for, by a walk around each vertex

  void add(const DesignedFunction& result, const TriangleMesh& mesh,
    const std::vector<CriticalRequest>& requests)
  {
    const auto met = static_cast<int>(requests.size() - result.missing.size());
    this->asked += static_cast<int>(requests.size());
    this->kept += met;
    this->added += static_cast<int>(result.critical.points.size()) - met;
    this->byWalking += static_cast<int>(metByWalking(mesh, result.values, requests));
  }
};

/// How many more points Euler's formula needs at least: extrema of a kind that is not asked for,
/// and what the sum of the indices lacks.
int necessary(const std::vector<CriticalRequest>& requests, int eulerCharacteristic)
{
  int sum = 0;
  int minima = 0;
  int maxima = 0;
  for (const CriticalRequest& request : requests)
  {
    sum += indexOf(request.type, request.multiplicity);
    minima += request.type == CriticalType::Minimum;
    maxima += request.type == CriticalType::Maximum;
  }
  const int extrema = (minima == 0) + (maxima == 0);
  const int lacking = eulerCharacteristic - sum; // positive: extrema
  return lacking >= extrema ? lacking : 2 * extrema - lacking;
}

DesignedFunction designed(const DesignMesh& mesh, const std::vector<CriticalRequest>& requests,
  const Way& way, bool cleanUp)
{
  DesignParameters parameters = way.parameters;
  parameters.cleanUp = cleanUp;
  return designFunction(mesh, requests, parameters);
}

struct MeshToDesignOn
{
  std::string name;
  TriangleMesh mesh;
};

TriangleMesh irregularTorus(int around)
{
  const Mesh torus = torusMesh(around, true);
  TriangleMesh result{ torus.vertices, {} };
  for (const auto corners : torus.triangles.colwise())
  {
    result.triangles.push_back(
      { static_cast<int>(corners[0]), static_cast<int>(corners[1]), static_cast<int>(corners[2]) });
  }
  return result;
}

std::vector<MeshToDesignOn> meshesOfGenus0To3(bool isReduced)
{
  const int level = isReduced ? 3 : 4;
  return { { "sphere", subdividedSphere(level + 1) },
    { "irregular torus", irregularTorus(isReduced ? 50 : 100) },
    { "plate with 2 holes", plateWithHoles(2, level) },
    { "plate with 3 holes", plateWithHoles(3, level) } };
}

/// The numbers of a tally before and after clean-up.
std::vector<std::string> cells(
  MarkdownReport& report, const Way& way, const Tally& tally, const Tally& cleaned)
{
  const bool isKept = tally.kept == tally.asked && tally.byWalking == tally.kept &&
    cleaned.kept == cleaned.asked && cleaned.byWalking == cleaned.kept;
  return { way.name, ofAll(tally.kept, tally.asked), std::to_string(tally.added),
    ofAll(cleaned.kept, cleaned.asked), std::to_string(cleaned.added),
    mustKeep(way) ? report.kept(isKept) : "" };
}

const std::vector<std::string> columns{ "function", "kept", "added", "kept, cleaned up",
  "added, cleaned up", "all kept" };

void reportRequests(MarkdownReport& report, bool isReduced)
{
  const unsigned count = isReduced ? 5 : 50;
  for (const MeshToDesignOn& one : meshesOfGenus0To3(isReduced))
  {
    const MeshTopology topology = topologyOf(one.mesh);
    int needed = 0;
    for (unsigned seed = 1; seed <= count; ++seed)
    {
      needed += necessary(randomRequests(topology, seed), one.mesh.eulerCharacteristic());
    }
    report.head(one.name + ", " + std::to_string(topology.vertexCount()) + " vertices, " +
        std::to_string(count) + " requests: Euler's formula needs at least " +
        std::to_string(needed) + " points more",
      columns);
    for (const Way& way : allWays())
    {
      Tally tally;
      Tally cleaned;
      for (unsigned seed = 1; seed <= count; ++seed)
      {
        const std::vector<CriticalRequest> requests = randomRequests(topology, seed);
        const TriangleMesh mesh = refinedFor(one.mesh, requests);
        const DesignMesh design(mesh.points, trianglesOf(mesh));
        tally.add(designed(design, requests, way, false), mesh, requests);
        if (seed <= CleanedUp)
        {
          cleaned.add(designed(design, requests, way, true), mesh, requests);
        }
      }
      report.row(cells(report, way, tally, cleaned));
    }
  }
}

/// One minimum, one maximum and the saddles of the harmonic function between them, without values.
std::vector<CriticalRequest> naturalRequests(
  const DesignMesh& mesh, const Laplacian& laplacian, unsigned seed)
{
  Random random(seed);
  const Vector3d direction(
    random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
  const Values height = mesh.vertices().transpose() * direction;
  Eigen::Index lowest = 0;
  Eigen::Index highest = 0;
  height.minCoeff(&lowest);
  height.maxCoeff(&highest);
  const Values harmonic = harmonicFunction(
    laplacian, { { static_cast<Index>(lowest), 0.0 }, { static_cast<Index>(highest), 1.0 } });
  std::vector<CriticalRequest> requests =
    requestsOf(mesh.vertices(), mesh.topology(), harmonic, 1e-6);
  for (CriticalRequest& request : requests)
  {
    request.value.reset();
    request.star.clear();
  }
  return requests;
}

void reportPlaces(MarkdownReport& report, const std::string& folder, bool isReduced)
{
  std::vector<MeshToDesignOn> meshes = meshesOfGenus0To3(isReduced);
  for (const char* name : { "elephant.off", "refined_elephant.off" })
  {
    const std::filesystem::path file = std::filesystem::path(folder) / name;
    if (!folder.empty() && std::filesystem::exists(file))
    {
      meshes.push_back({ name, readOff(file) });
    }
  }
  for (const MeshToDesignOn& one : meshes)
  {
    const DesignMesh mesh(one.mesh.points, trianglesOf(one.mesh));
    const Laplacian laplacian =
      meshLaplacian(mesh.vertices(), mesh.topology().triangles(), LaplacianWeights::Cotangent);
    report.head(one.name + ", " + std::to_string(mesh.topology().vertexCount()) +
        " vertices: critical points of 6 harmonic functions",
      columns);
    for (const Way& way : allWays())
    {
      Tally tally;
      Tally cleaned;
      for (unsigned seed = 1; seed <= 6; ++seed)
      {
        const std::vector<CriticalRequest> requests = naturalRequests(mesh, laplacian, seed);
        tally.add(designed(mesh, requests, way, false), one.mesh, requests);
        cleaned.add(designed(mesh, requests, way, true), one.mesh, requests);
      }
      report.row(cells(report, way, tally, cleaned));
    }
  }
}

/// What least squares trades: closeness for smoothness and for points that were not asked for.
void reportTradeoff(const MarkdownReport& report, bool isReduced)
{
  const unsigned count = isReduced ? 5 : 50;
  const TriangleMesh coarse = irregularTorus(isReduced ? 50 : 100);
  const MeshTopology topology = topologyOf(coarse);
  report.head("irregular torus, " + std::to_string(topology.vertexCount()) + " vertices, " +
      std::to_string(count) + " random requests: least squares",
    { "epsilon", "kept", "added", "kept, cleaned up", "added, cleaned up" });
  for (const double epsilon : { 1e4, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13 })
  {
    const Way way = leastSquares(number("%.0e", epsilon), epsilon);
    Tally tally;
    Tally cleaned;
    for (unsigned seed = 1; seed <= count; ++seed)
    {
      const std::vector<CriticalRequest> requests = randomRequests(topology, seed);
      const TriangleMesh mesh = refinedFor(coarse, requests);
      const DesignMesh design(mesh.points, trianglesOf(mesh));
      tally.add(designed(design, requests, way, false), mesh, requests);
      if (seed <= CleanedUp)
      {
        cleaned.add(designed(design, requests, way, true), mesh, requests);
      }
    }
    report.row({ way.name, ofAll(tally.kept, tally.asked), std::to_string(tally.added),
      ofAll(cleaned.kept, cleaned.asked), std::to_string(cleaned.added) });
  }
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments(argc, argv, { "requests", "places", "tradeoff" }, { "meshes" });
  MarkdownReport report;
  if (arguments.wants("requests"))
  {
    reportRequests(report, arguments.isReduced());
  }
  if (arguments.wants("places"))
  {
    reportPlaces(report, arguments.valueOf("meshes"), arguments.isReduced());
  }
  if (arguments.wants("tradeoff"))
  {
    reportTradeoff(report, arguments.isReduced());
  }
  return report.exitCode();
}
