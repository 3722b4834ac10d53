#include "CriticalTable.h"

#include "FuzzyCriticalPoints.h"
#include "NeighborGraph.h"
#include "Sampling.h"
#include "Surfaces.h"
#include "TriangleMesh.h"

#include <filesystem>

namespace SurfaceScalars::Truth
{
namespace
{

constexpr int FunctionCount = 20;

/// Heights and quadratic functions in turn, of random directions and coefficients.
std::vector<Values> drawFunctions(const Points& points, unsigned seed)
{
  Random random(seed);
  const auto draw = [&]() { return random.normal(); };
  std::vector<Values> functions;
  for (int i = 0; i < FunctionCount; ++i)
  {
    const Vector3d linear = Vector3d::NullaryExpr(draw);
    Eigen::Matrix3d quadratic = Eigen::Matrix3d::Zero();
    if (i % 2 == 1)
    {
      quadratic = Eigen::Matrix3d::NullaryExpr(draw);
    }
    functions.push_back(
      valuesOf([&](const Vector3d& p) { return linear.dot(p) + p.dot(quadratic * p); }, points));
  }
  return functions;
}

struct ClosedCloud
{
  std::string name;
  Points points;
  int eulerCharacteristic;
  int fewestRight; ///< promised; 0 = nothing
};

void reportCloud(MarkdownReport& report, const ClosedCloud& cloud, unsigned seed)
{
  const NeighborGraph graph(cloud.points, NeighborQuery());
  int right = 0;
  std::string wrong;
  for (const Values& values : drawFunctions(cloud.points, seed))
  {
    const int sum = findCriticalPoints(graph, graph.average(values), {}).indexSum;
    right += sum == cloud.eulerCharacteristic ? 1 : 0;
    wrong += sum == cloud.eulerCharacteristic ? "" : " " + std::to_string(sum);
  }
  report.row({ cloud.name, std::to_string(cloud.points.cols()),
    std::to_string(cloud.eulerCharacteristic), ofAll(right, FunctionCount), wrong,
    cloud.fewestRight > 0 ? report.kept(right >= cloud.fewestRight) : "" });
}

} // namespace

void reportDrawn(MarkdownReport& report, const std::string& folder, unsigned seed)
{
  report.head("Index sums of " + std::to_string(FunctionCount) + " functions drawn at random",
    { "samples", "points", "χ", "right", "wrong sums", "kept" });
  for (const ClosedSurface& surface : { unitSphere(), closedTorus(), doubleTorus(), tripleTorus() })
  {
    for (const int count : { 20000, 50000 })
    {
      const bool isPromised = surface.eulerCharacteristic == -2 && count >= 50000;
      reportCloud(report,
        { surface.name, surface.sample(count, seed), surface.eulerCharacteristic,
          isPromised ? FunctionCount : 0 },
        seed);
    }
  }
  for (const char* name : { "refined_elephant", "bunny00", "bear", "knot1", "knot2" })
  {
    const std::string fileName = folder + "/" + name + ".off";
    if (std::filesystem::exists(fileName))
    {
      const TriangleMesh mesh = readCentered(fileName);
      const bool isPromised = name == std::string("refined_elephant");
      reportCloud(report,
        { name, mesh.points, mesh.eulerCharacteristic(), isPromised ? FunctionCount - 1 : 0 },
        seed);
    }
  }
}

} // namespace SurfaceScalars::Truth
