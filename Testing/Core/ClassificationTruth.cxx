// Whether critical points of sums of radial functions are found off the vertices of meshes, as
// tables in Markdown; fails if one is lost, doubled or not as sharp as promised.
//
//   surface-scalars-classification-truth [reduced] [surfaces] [guesses] [meshes FOLDER]
//
// surfaces: meshes of known surfaces, finer and finer; guesses: Table 3 and Figs. 12 and 13 of the
// design paper; meshes: scans and models in OFF format.

#include "Arguments.h"
#include "ClassificationGuesses.h"
#include "CriticalScore.h"
#include "MarkdownReport.h"
#include "ModelCases.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

using namespace SurfaceScalars;
using namespace SurfaceScalars::Truth;

namespace
{

struct MeshSeries
{
  ClosedSurface surface;
  std::vector<Mesh> meshes; ///< finer and finer
};

std::vector<MeshSeries> allSeries(bool isReduced)
{
  std::vector<MeshSeries> series{ { unitSphere(), {} }, { closedTorus(), {} },
    { doubleTorus(), {} }, { tripleTorus(), {} } };
  for (int level = 0; level < (isReduced ? 2 : 4); ++level)
  {
    const int factor = 1 << level;
    series[0].meshes.push_back(sphereMesh(3 + level));
    series[1].meshes.push_back(torusMesh(40 * factor, true));
    series[2].meshes.push_back(asMesh(implicitMesh(doubleTorus().implicit, 1.3, 32 * factor)));
    series[3].meshes.push_back(asMesh(implicitMesh(tripleTorus().implicit, 1.8, 40 * factor)));
  }
  return series;
}

struct KernelChoice
{
  KernelType kernel;
  double width; ///< 0 = automatic
};

void reportSurfaces(MarkdownReport& report, bool isReduced)
{
  for (const MeshSeries& series : allSeries(isReduced))
  {
    for (const KernelChoice& choice :
      { KernelChoice{ KernelType::Cubic, 0.0 }, KernelChoice{ KernelType::Gaussian, 0.5 } })
    {
      const Field u = fewCenters(series.surface, 150, choice.kernel, choice.width, 3);
      const std::vector<CriticalPoint> exact = criticalPoints(series.surface, asFunction(u));
      report.head(series.surface.name + ", " + nameOf(choice.kernel) +
          ", 150 centers: " + std::to_string(exact.size()) + " critical points",
        { "vertices", "candidates", "found", "right", "merged", "vanished", "left at vertices",
          "index sum", "steps", "gradient / scale", "largest error / edge", "order", "kept" });
      double lastError = 0.0;
      double lastEdge = 0.0;
      for (const Mesh& mesh : series.meshes)
      {
        const MeshTopology topology = topologyOf(mesh);
        const ModelRun run(mesh.vertices, topology, u);
        const std::vector<CriticalPoint> found = run.refined();
        const CriticalScore score = scoreCriticalPoints(found, exact, unambiguousRadius(exact));
        const double edge = meanEdge(mesh.vertices, mesh.triangles);
        const double error = score.errorMaximum;
        const bool isKept = score.rightCount == score.exactCount &&
          score.foundCount == score.exactCount && run.mostSteps() <= 10 &&
          run.largestResidual() <= 1e-10 && run.sum == series.surface.eulerCharacteristic;
        report.row({ std::to_string(topology.vertexCount()),
          std::to_string(run.candidates.points.size()), std::to_string(score.foundCount),
          ofAll(score.rightCount, score.exactCount), std::to_string(run.result.merged),
          std::to_string(run.result.vanished),
          std::to_string(run.result.points.size() - found.size()), number("%g", run.sum),
          std::to_string(run.mostSteps()), number("%.1e", run.largestResidual()),
          number("%.1e", error / edge),
          lastError > 0.0 ? number("%.1f", std::log(lastError / error) / std::log(lastEdge / edge))
                          : "",
          report.kept(isKept) });
        lastError = error;
        lastEdge = edge;
      }
    }
  }
}

/// Through some values of a wave at random vertices of a mesh.
Field waveThroughVertices(const Mesh& mesh)
{
  Random random(3);
  const auto count = std::min<Eigen::Index>(300, mesh.vertices.cols());
  Points centers(3, count);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    centers.col(i) = mesh.vertices.col(
      static_cast<Eigen::Index>(random.uniform() * static_cast<double>(mesh.vertices.cols())));
  }
  const auto wave = [](const Vector3d& p)
  { return std::sin(6.0 * p.x() + 1.0) * std::cos(5.0 * p.y()) + 0.5 * std::sin(7.0 * p.z()); };
  FieldParameters parameters;
  parameters.scheme = Scheme::GlobalRBF;
  return Field::fit(centers, valuesOf(wave, centers), parameters);
}

std::vector<std::filesystem::path> meshesOf(const std::string& folder)
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

/// What becomes of the candidates of a mesh, or of all.
struct Ends
{
  static constexpr RefinementEnd LeftInside[] = { RefinementEnd::NoDerivative,
    RefinementEnd::NotPredicted, RefinementEnd::Taken, RefinementEnd::OutOfSteps,
    RefinementEnd::NotFound };
  // Candidates, refined, merged, vanished, on the boundary, left inside by cause.
  std::vector<std::size_t> counts = std::vector<std::size_t>(5 + std::size(LeftInside));
  int mostSteps = 0;
  double largestResidual = 0.0;

  void add(const ModelRun& run)
  {
    std::vector<std::size_t> ofRun{ run.candidates.points.size(),
      run.countOf(RefinementEnd::Refined), run.result.merged, run.result.vanished,
      run.countOf(RefinementEnd::OnBoundary) };
    for (const RefinementEnd end : LeftInside)
    {
      ofRun.push_back(run.countOf(end));
    }
    std::transform(ofRun.begin(), ofRun.end(), this->counts.begin(), this->counts.begin(),
      std::plus<std::size_t>());
    this->mostSteps = std::max(this->mostSteps, run.mostSteps());
    this->largestResidual = std::max(this->largestResidual, run.largestResidual());
  }

  void report(const MarkdownReport& table, const std::string& name, const std::string& vertices,
    const std::string& sums, const std::string& kept) const
  {
    std::vector<std::string> row{ name, vertices };
    for (const std::size_t count : this->counts)
    {
      row.push_back(std::to_string(count));
    }
    row.insert(row.end(),
      { sums, std::to_string(this->mostSteps), number("%.1e", this->largestResidual), kept });
    table.row(row);
  }
};

void reportMeshes(MarkdownReport& report, const std::string& folder)
{
  report.head("meshes of a folder, u from 300 values at vertices",
    { "mesh", "vertices", "candidates", "refined", "merged", "vanished", "on the boundary",
      "no derivative", "not predicted", "taken", "out of steps", "not found",
      "index sum, Euler characteristic", "most steps", "gradient / scale", "kept" });
  Ends all;
  for (const std::filesystem::path& file : meshesOf(folder))
  {
    try
    {
      const Mesh mesh = asMesh(readCentered(file));
      const MeshTopology topology = topologyOf(mesh);
      const ModelRun run(mesh.vertices, topology, waveThroughVertices(mesh));
      const auto characteristic = static_cast<double>(topology.eulerCharacteristic());
      const bool isKept =
        run.sum == characteristic && run.largestResidual() <= 1e-10 && run.mostSteps() <= 10;
      Ends ends;
      ends.add(run);
      all.add(run);
      ends.report(report, file.stem().string(), std::to_string(topology.vertexCount()),
        number("%g", run.sum) + ", " + number("%g", characteristic), report.kept(isKept));
    }
    catch (const std::exception& error)
    {
      std::fprintf(stderr, "%s: %s\n", file.filename().c_str(), error.what());
    }
  }
  all.report(report, "all", "", "", "");
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments(argc, argv, { "surfaces", "guesses", "meshes" }, { "meshes" });
  MarkdownReport report;
  if (arguments.wants("surfaces"))
  {
    reportSurfaces(report, arguments.isReduced());
  }
  if (arguments.wants("guesses"))
  {
    reportGuesses(report, arguments.isReduced());
  }
  if (arguments.has("meshes"))
  {
    reportMeshes(report, arguments.valueOf("meshes"));
  }
  return report.exitCode();
}
