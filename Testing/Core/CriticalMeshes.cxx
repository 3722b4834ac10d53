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

TriangleMesh readCentered(const std::string& fileName)
{
  TriangleMesh mesh = readOff(fileName);
  const Vector3d low = mesh.points.rowwise().minCoeff();
  const Vector3d high = mesh.points.rowwise().maxCoeff();
  mesh.points = (mesh.points.colwise() - 0.5 * (low + high)) * (2.0 / (high - low).norm());
  return mesh;
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
  int indexSum = 0;   ///< of these
};

Containment compare(const NeighborGraph& graph, const FuzzyCriticalPoints& found,
  const std::vector<CriticalPoint>& ofMesh, double persistence)
{
  Containment result;
  for (const CriticalPoint& point : found.points)
  {
    if (point.type != CriticalType::Uncertain && point.persistence > persistence)
    {
      ++result.foundCount;
      result.indexSum += indexOf(point);
    }
  }
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

} // namespace

void reportMeshes(MarkdownReport& report, const std::string& folder)
{
  report.head("Critical points of meshes and of their vertices alone",
    { "mesh", "vertices", "χ", "function", "index sum", "kept", "k", "probable samples",
      "persistence > 0: in the fuzzy set", "same type", "found", "> 1%: in the fuzzy set",
      "same type", "found", "> 5%: in the fuzzy set", "same type", "found" });
  for (const char* name :
    { "knot1", "elephant", "refined_elephant", "bunny00", "armadillo", "camel", "man", "femur" })
  {
    const std::string fileName = folder + "/" + name + ".off";
    if (!std::filesystem::exists(fileName))
    {
      continue;
    }
    const TriangleMesh mesh = readCentered(fileName);
    const NeighborGraph graph(mesh.points, NeighborQuery());
    for (const SpaceFunction& function : functionsOfSpace())
    {
      const Values values = valuesOf(function, mesh.points);
      const double range = values.maxCoeff() - values.minCoeff();
      const auto ofMesh = meshCriticalPoints(mesh, values);
      const FuzzyCriticalPoints found = findCriticalPoints(graph, graph.average(values), {});
      const int euler = mesh.eulerCharacteristic();
      std::fprintf(
        stderr, "%s, %s: index sum %d of %d\n", name, function.name.c_str(), found.indexSum, euler);
      printDifferences(graph, ofMesh, found.points, range);
      std::vector<std::string> row{ name, std::to_string(mesh.points.cols()), std::to_string(euler),
        function.name, std::to_string(found.indexSum), report.kept(found.indexSum == euler),
        std::to_string(found.neighborCount),
        std::to_string((found.samples.probability.array() > Probable).count()) };
      for (const double threshold : { 0.0, 0.01, 0.05 })
      {
        const Containment result = compare(graph, found, ofMesh, threshold * range);
        row.insert(row.end(),
          { ofAll(result.inFuzzySet, result.meshCount), ofAll(result.sameType, result.meshCount),
            std::to_string(result.foundCount) + ", sum " + std::to_string(result.indexSum) });
      }
      report.row(row);
    }
  }
}

} // namespace SurfaceScalars::Truth
