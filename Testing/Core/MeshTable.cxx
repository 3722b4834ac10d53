// Euler's formula and the types of vertices on meshes, as a table in Markdown; fails if a count is
// wrong.
//
//   surface-scalars-mesh-truth [meshes FOLDER]
//
// on every mesh in OFF format of the folder and on generated ones of genus 0 to 30, with boundary
// and with a twist. Meshes that are refused are listed with the reason.

#include "Arguments.h"
#include "LinkWalk.h"
#include "MarkdownReport.h"
#include "MeshCriticalPoints.h"
#include "MeshFunctions.h"

#include <algorithm>
#include <exception>
#include <filesystem>

using namespace SurfaceScalars;
using namespace SurfaceScalars::Truth;

namespace
{

/// Twice the sum of the indices, those of boundary vertices half.
std::int64_t doubleIndexSum(const MeshTopology& mesh, const VertexTypes& types)
{
  std::int64_t sum = 0;
  for (Index vertex = 0; vertex < mesh.vertexCount(); ++vertex)
  {
    sum += std::int64_t(mesh.isBoundary(vertex) ? 1 : 2) *
      indexOf(types.types[vertex], static_cast<int>(types.multiplicities[vertex]));
  }
  return sum;
}

bool agrees(const VertexTypes& types, const std::vector<VertexType>& walked)
{
  for (std::size_t i = 0; i < walked.size(); ++i)
  {
    const VertexType found{ types.types[i], static_cast<int>(types.multiplicities[i]) };
    if (!(found == walked[i]))
    {
      return false;
    }
  }
  return true;
}

/// Whether removing pairs leaves the sum of the indices at every hundredth of f's range.
bool keepsSum(const MeshCriticalPoints& critical, double range)
{
  const auto sum = [](const std::vector<CriticalPoint>& points)
  {
    std::int64_t result = 0;
    for (const CriticalPoint& point : points)
    {
      result += indexOf(point);
    }
    return result;
  };
  for (int step = 0; step <= 100; ++step)
  {
    std::vector<CriticalPoint> kept = critical.points;
    removeBelow(kept, critical.pairs, range * (step / 100.0));
    if (sum(kept) != sum(critical.points))
    {
      return false;
    }
  }
  return true;
}

std::string textOf(const CriticalCounts& counts)
{
  return std::to_string(counts.minima) + " / " + std::to_string(counts.saddles) + " / " +
    std::to_string(counts.maxima);
}

void reportMesh(MarkdownReport& report, const std::string& name, const TriangleMesh& mesh)
{
  const MeshTopology topology = topologyOf(mesh);
  const std::int64_t characteristic = topology.eulerCharacteristic();
  const std::vector<OrderedLink> links = orderedLinks(mesh);
  std::vector<std::string> cells{ name, std::to_string(topology.vertexCount()),
    std::to_string(topology.componentCount()),
    topology.isClosed() ? std::to_string(topology.componentCount() - characteristic / 2) : "open",
    std::to_string(characteristic) };
  bool euler = characteristic == mesh.eulerCharacteristic();
  bool walk = true;
  bool pairs = true;
  for (const auto& [function, values] : meshFunctions(mesh, 1))
  {
    const VertexTypes types = classifyVertices(topology, values);
    cells.push_back(textOf(types.counts));
    euler = euler && doubleIndexSum(topology, types) == 2 * characteristic;
    walk = walk && agrees(types, typesByWalking(links, values));
    pairs = pairs &&
      (!topology.isClosed() ||
        keepsSum(meshCriticalPoints(mesh.points, topology, values),
          values.maxCoeff() - values.minCoeff()));
  }
  cells.insert(cells.end(), { report.kept(euler), report.kept(walk), report.kept(pairs) });
  report.row(cells);
}

void reportGenerated(MarkdownReport& report)
{
  for (const int holes : { 0, 1, 2, 3, 10, 30 })
  {
    reportMesh(report, "plate with holes", plateWithHoles(holes, 3));
  }
  reportMesh(report, "sphere", subdividedSphere(6));
  reportMesh(report, "torus", gridMesh(Grid::Torus, 300, 100));
  reportMesh(report, "patch", gridMesh(Grid::Patch, 200, 200));
  reportMesh(report, "cylinder", gridMesh(Grid::Cylinder, 300, 100));
  reportMesh(report, "Möbius strip", gridMesh(Grid::Moebius, 300, 100));
}

std::vector<std::filesystem::path> filesOf(const std::string& folder)
{
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
  {
    if (entry.path().extension() == ".off")
    {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

struct Refusal
{
  std::string name;
  std::string reason;
};

std::vector<Refusal> reportFolder(MarkdownReport& report, const std::string& folder)
{
  std::vector<Refusal> refusals;
  for (const std::filesystem::path& file : filesOf(folder))
  {
    try
    {
      reportMesh(report, file.stem().string(), readOff(file.string()));
    }
    catch (const std::runtime_error& error)
    {
      refusals.push_back({ file.stem().string(), error.what() });
    }
  }
  return refusals;
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    const Arguments arguments(argc, argv, {}, { "meshes" });
    MarkdownReport report;
    report.head("Minima, saddles and maxima of meshes",
      { "mesh", "vertices", "components", "genus", "χ", "smooth", "noisy", "random", "steps",
        "constant", "m − s + M = χ", "as walked", "pairs keep χ" });
    reportGenerated(report);
    if (arguments.has("meshes"))
    {
      const std::vector<Refusal> refusals = reportFolder(report, arguments.valueOf("meshes"));
      report.head("Refused", { "mesh", "reason" });
      for (const Refusal& refusal : refusals)
      {
        report.row({ refusal.name, refusal.reason });
      }
    }
    return report.exitCode();
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "%s\n", error.what());
    return EXIT_FAILURE;
  }
}
