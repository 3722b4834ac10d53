#include "CriticalTable.h"

#include "CriticalScore.h"
#include "Functions.h"
#include "FuzzyCriticalPoints.h"
#include "TriangleMesh.h"

#include <algorithm>
#include <filesystem>

namespace SurfaceScalars::Truth
{
namespace
{

constexpr double Probable = 0.1; ///< the probability from which a sample is in the fuzzy set

SpaceFunction along(const char* name, const Vector3d& direction)
{
  return { name, [=](const Vector3d& p) { return direction.dot(p); },
    [=](const Vector3d&) { return direction; } };
}

/// Functions on a mesh that lies around the origin with a diagonal of 2.
std::vector<SpaceFunction> functionsOfSpace()
{
  return { along("x", Vector3d::UnitX()), along("y", Vector3d::UnitY()),
    along("z", Vector3d::UnitZ()), tiltedHeight(), saddleWithLogarithm(),
    { "distance from the center", [](const Vector3d& p) { return p.norm(); },
      [](const Vector3d& p) -> Vector3d { return p.normalized(); } } };
}

bool hasPartner(const CriticalPoint& point, const std::vector<CriticalPoint>& others, double radius)
{
  return std::any_of(others.begin(), others.end(),
    [&](const CriticalPoint& other)
    { return other.type == point.type && (other.position - point.position).norm() <= radius; });
}

/// What of the critical vertices of a mesh is found again.
struct Containment
{
  int meshCount = 0;
  int inFuzzySet = 0; ///< a sample within two steps is probably critical
  int sameType = 0;   ///< a critical point of the same type is within three steps
  int foundCount = 0; ///< critical points, with a type

  void add(const Containment& other)
  {
    this->meshCount += other.meshCount;
    this->inFuzzySet += other.inFuzzySet;
    this->sameType += other.sameType;
    this->foundCount += other.foundCount;
  }
};

Containment compare(const NeighborGraph& graph, const FuzzyCriticalPoints& found,
  const std::vector<CriticalPoint>& ofMesh, double persistence)
{
  Containment result;
  result.foundCount = static_cast<int>(std::count_if(found.points.begin(), found.points.end(),
    [=](const CriticalPoint& point)
    { return point.type != CriticalType::Uncertain && point.persistence > persistence; }));
  Neighborhood near;
  for (const CriticalPoint& vertex : ofMesh)
  {
    if (vertex.persistence <= persistence)
    {
      continue;
    }
    ++result.meshCount;
    const Index at = graph.pointOfInput(vertex.input);
    const double step = graph.samplingStep(at);
    graph.within(graph.points().col(at), 2.0 * step, near);
    result.inFuzzySet += std::any_of(near.indices.begin(), near.indices.end(),
      [&](Index i) { return found.samples.probability[i] > Probable; });
    result.sameType += hasPartner(vertex, found.points, 3.0 * step) ? 1 : 0;
  }
  return result;
}

/// On the error stream: what only the mesh or only its vertices have.
void printDifferences(const NeighborGraph& graph, const std::vector<CriticalPoint>& ofMesh,
  const std::vector<CriticalPoint>& found, double range)
{
  const auto print = [&](const char* origin, const std::vector<CriticalPoint>& points,
                       const std::vector<CriticalPoint>& others)
  {
    for (const CriticalPoint& point : points)
    {
      const double step = graph.samplingStep(graph.pointOfInput(point.input));
      if (!hasPartner(point, others, 3.0 * step))
      {
        std::fprintf(stderr,
          "  only %s: type %d m %d at %.4f %.4f %.4f, step %.4f, persistence %.5f, probability "
          "%.3f\n",
          origin, static_cast<int>(point.type), point.multiplicity, point.position.x(),
          point.position.y(), point.position.z(), step, point.persistence / range,
          point.probability);
      }
    }
  };
  print("in the mesh", ofMesh, found);
  print("in the cloud", found, ofMesh);
}

struct MeshFile
{
  const char* name;
  bool isPromised; ///< dense enough for the index sum to be right
};

const std::vector<MeshFile> MeshFiles{ { "knot1", true }, { "elephant", false },
  { "refined_elephant", true }, { "bunny00", false }, { "armadillo", false }, { "camel", false },
  { "man", false }, { "femur", false } };

const std::vector<double> Thresholds{ 0.0, 0.01, 0.05 };

/// What all functions together say about a mesh.
struct MeshReport
{
  std::vector<std::string> indexSums;
  std::vector<Containment> containments = std::vector<Containment>(Thresholds.size());
};

MeshReport examine(MarkdownReport& report, const MeshFile& file, const TriangleMesh& mesh)
{
  const int euler = mesh.eulerCharacteristic();
  const NeighborGraph graph(mesh.points, NeighborQuery());
  MeshReport result{ { file.name, std::to_string(mesh.points.cols()), std::to_string(euler) } };
  bool allRight = true;
  for (const SpaceFunction& function : functionsOfSpace())
  {
    const Values values = valuesOf(function, mesh.points);
    const double range = values.maxCoeff() - values.minCoeff();
    const auto ofMesh = meshCriticalPoints(mesh, values);
    const FuzzyCriticalPoints found = findCriticalPoints(graph, graph.average(values), {});
    std::fprintf(stderr, "%s, %s: index sum %d of %d\n", file.name, function.name.c_str(),
      found.indexSum, euler);
    printDifferences(graph, ofMesh, found.points, range);
    allRight = allRight && found.indexSum == euler;
    result.indexSums.push_back(
      std::to_string(found.indexSum) + " (k " + std::to_string(found.neighborCount) + ")");
    for (std::size_t i = 0; i < Thresholds.size(); ++i)
    {
      result.containments[i].add(compare(graph, found, ofMesh, Thresholds[i] * range));
    }
  }
  result.indexSums.push_back(file.isPromised ? report.kept(allRight) : "");
  return result;
}

} // namespace

void reportMeshes(MarkdownReport& report, const std::string& folder)
{
  std::vector<std::string> head{ "mesh", "vertices", "χ" };
  for (const SpaceFunction& function : functionsOfSpace())
  {
    head.push_back(function.name);
  }
  head.emplace_back("kept");
  report.head("Index sums of closed meshes, from their vertices alone", head);
  std::vector<std::vector<std::string>> rows;
  for (const MeshFile& file : MeshFiles)
  {
    const std::string fileName = folder + "/" + file.name + ".off";
    if (!std::filesystem::exists(fileName))
    {
      continue;
    }
    const MeshReport result = examine(report, file, readCentered(fileName));
    report.row(result.indexSums);
    for (std::size_t i = 0; i < Thresholds.size(); ++i)
    {
      const Containment& all = result.containments[i];
      rows.push_back({ file.name, "> " + number("%g%%", 100.0 * Thresholds[i]),
        std::to_string(all.meshCount), ofAll(all.inFuzzySet, all.meshCount),
        ofAll(all.sameType, all.meshCount), std::to_string(all.foundCount) });
    }
  }
  report.head("Critical vertices of the meshes among what is found at their vertices alone",
    { "mesh", "persistence", "critical vertices", "in the fuzzy set", "found with their type",
      "found in all" });
  for (const std::vector<std::string>& row : rows)
  {
    report.row(row);
  }
}

} // namespace SurfaceScalars::Truth
