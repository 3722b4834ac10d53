// What meshless approximation promises, and Tables 2 and 4 of the design paper, as tables in
// Markdown; fails if a promise is not kept.
//
//   surface-scalars-approximation-truth [reduced] [selection] [noise] [saving] [meshes FOLDER]
//
// selection: centers by choice against as many others, on the meshes of a folder as well; noise:
// Table 2; saving: Table 4.

#include "ApproximationTruth.h"
#include "Arguments.h"
#include "GeodesicDistance.h"
#include "LaplacianFunctions.h"
#include "MarkdownReport.h"
#include "MeshExamples.h"
#include "MeshlessApproximation.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

using namespace SurfaceScalars;
using namespace SurfaceScalars::Truth;

namespace
{

// Of f's range: where farthest points miss f by more, or by more than half of what half as many
// miss it by, it has details between centers.
constexpr double ResolvedError = 0.03;
constexpr Eigen::Index MostForEigenfunctions = 50000; // vertices: others would take minutes

struct NamedSurface
{
  std::string name;
  Mesh mesh;
};

struct NamedFunction
{
  std::string name;
  Values values;
  double persistence; ///< threshold
};

double rangeOf(const Values& values)
{
  return values.maxCoeff() - values.minCoeff();
}

std::string percent(double share)
{
  return number("%.2f%%", 100.0 * share);
}

std::vector<NamedSurface> surfaces(const std::string& folder, bool isReduced)
{
  std::vector<NamedSurface> result{ { "irregular torus", torusMesh(isReduced ? 80 : 490, true) },
    { "sphere", sphereMesh(isReduced ? 5 : 7) } };
  for (const char* name : { "elephant", "knot1", "bunny00", "refined_elephant" })
  {
    const std::filesystem::path file = std::filesystem::path(folder) / (std::string(name) + ".off");
    if (!folder.empty() && std::filesystem::exists(file))
    {
      const TriangleMesh mesh = readCentered(file);
      result.push_back({ name, { mesh.points, trianglesOf(mesh) } });
    }
  }
  return result;
}

Values waves(const Points& points, double frequency)
{
  return (
    (frequency * points.row(0)).array().sin() * (0.8 * frequency * points.row(1)).array().cos() +
    0.3 * points.row(2).array())
    .transpose();
}

/// Few critical points.
Values slope(const Points& points)
{
  const Vector3d direction(0.35, 0.9, 0.17);
  return (direction.transpose() * points).transpose() +
    0.1 * (2.0 * points.row(0)).array().sin().matrix().transpose();
}

/// Octaves of waves in random directions, each of half the height and twice the frequency.
Values terrain(const Points& points)
{
  Random random(3);
  Values result = Values::Zero(points.cols());
  for (int octave = 0; octave < 5; ++octave)
  {
    for (int i = 0; i < 4; ++i)
    {
      const Vector3d direction =
        Vector3d(random.normal(), random.normal(), random.normal()).normalized();
      const double frequency = 3.0 * std::pow(2.0, octave);
      const double phase = random.uniform(0.0, 2.0 * Pi);
      result += std::pow(0.5, octave) *
        ((frequency * direction.transpose() * points).array() + phase).sin().matrix().transpose();
    }
  }
  return result;
}

/// From the first vertex: not smooth where ways around meet.
Values distances(const Points& points)
{
  const NeighborGraph graph(points, NeighborQuery());
  const Values ofPoints = geodesicDistance(graph, { graph.pointOfInput(0) });
  Values result(points.cols());
  for (Eigen::Index i = 0; i < points.cols(); ++i)
  {
    result[i] = ofPoints[graph.pointOfInput(static_cast<std::size_t>(i))];
  }
  return result;
}

std::vector<NamedFunction> functions(const Mesh& mesh)
{
  std::vector<NamedFunction> result{ { "slope", slope(mesh.vertices), 0.01 },
    { "waves", waves(mesh.vertices, 4.0), 0.01 }, { "distance", distances(mesh.vertices), 0.05 },
    { "terrain", terrain(mesh.vertices), 0.2 } };
  if (mesh.vertices.cols() <= MostForEigenfunctions)
  {
    const Laplacian laplacian =
      meshLaplacian(mesh.vertices, mesh.triangles, LaplacianWeights::Cotangent);
    result.push_back(
      { "eigenfunction 12", laplacianEigenfunctions(laplacian, 13).functions.col(12), 0.01 });
  }
  return result;
}

/// The fraction with which there are `factor` times as many centers as vertices in stars.
double fractionOf(Eigen::Index starCount, double factor, Eigen::Index vertexCount)
{
  return (factor - 1.0) * static_cast<double>(starCount) / static_cast<double>(vertexCount);
}

void reportComparison(MarkdownReport& report, const NamedFunction& function, const Points& points,
  const ApproximationDomain& domain, ApproximationParameters parameters)
{
  const MeshlessApproximation through = approximateMeshless(domain, function.values, parameters);
  parameters.levelSetConstraints = LevelSetConstraints::Minimax;
  const MeshlessApproximation minimax = approximateMeshless(domain, function.values, parameters);
  parameters.levelSetConstraints = LevelSetConstraints::Interpolating;
  parameters.centerSelection = CenterSelection::LevelSets;
  const MeshlessApproximation paper = approximateMeshless(domain, function.values, parameters);

  const Eigen::Index count = minimax.model.centers.cols();
  const double range = rangeOf(function.values);
  const double even = farthestPointError(points, function.values, count);
  const double ofEven = minimax.largestError / even;
  const double ofPaper = minimax.largestError / paper.largestError;
  const bool isResolved = even <= ResolvedError * range &&
    even <= 0.5 * farthestPointError(points, function.values, count / 2);
  const bool isPromised = ofEven <= 0.5 && (ofPaper <= 0.25 || !isResolved);
  const auto all = static_cast<int>(minimax.persistent.size());
  const int kept = all - static_cast<int>(minimax.lost.size());
  report.row(
    { function.name, std::to_string(all), std::to_string(minimax.starCount), std::to_string(count),
      number("%.1e", through.largestError / range), number("%.1e", minimax.largestError / range),
      number("%.1e", even / range), number("%.1e", paper.largestError / range),
      number("%.2f", ofEven), number(ofPaper <= 0.25 ? "%.2f" : "**%.2f**", ofPaper),
      ofAll(kept, all), std::to_string(minimax.critical.points.size() - minimax.persistent.size()),
      report.kept(isPromised && kept == all && through.lost.empty() && paper.lost.empty()) });
}

void reportSelection(MarkdownReport& report, const std::string& folder, bool isReduced)
{
  constexpr double LargestFraction = 0.3;
  constexpr double MostCenters = 2500.0; // others would take minutes
  for (const NamedSurface& surface : surfaces(folder, isReduced))
  {
    const Points& points = surface.mesh.vertices;
    const MeshTopology topology(static_cast<Index>(points.cols()), surface.mesh.triangles);
    const ApproximationDomain domain = surfaceDomain(points, topology);
    report.head(surface.name + ", " + std::to_string(points.cols()) + " vertices",
      { "f", "points", "stars", "centers", "interpolating", "minimax", "farthest points", "paper's",
        "of farthest", "of paper's", "kept", "added", "promise" });
    for (const NamedFunction& function : functions(surface.mesh))
    {
      ApproximationParameters parameters;
      parameters.persistenceThreshold = function.persistence;
      parameters.sampleFraction = 1e-6;
      const Eigen::Index stars = approximateMeshless(domain, function.values, parameters).starCount;
      for (const double factor : { 4.0, 8.0, 16.0 })
      {
        parameters.sampleFraction = fractionOf(stars, factor, points.cols());
        if (parameters.sampleFraction <= LargestFraction &&
          factor * static_cast<double>(stars) <= MostCenters)
        {
          reportComparison(report, function, points, domain, parameters);
        }
      }
    }
  }
}

std::string countsText(const CriticalCounts& counts)
{
  return std::to_string(counts.minima) + ", " + std::to_string(counts.maxima) + ", " +
    std::to_string(counts.saddles);
}

double largestMiss(const FieldModel& model, const Points& places, const Values& values)
{
  return (Field(model).evaluate(places, {}).values - values).lpNorm<Eigen::Infinity>();
}

struct Way
{
  std::string name;
  CenterSelection selection;
  LevelSetConstraints constraints;
};

/// Table 2: noise, and what becomes of it.
void reportNoise(MarkdownReport& report, bool isReduced)
{
  const Mesh mesh = torusMesh(isReduced ? 80 : 245, true);
  const MeshTopology topology(static_cast<Index>(mesh.vertices.cols()), mesh.triangles);
  const ApproximationDomain domain = surfaceDomain(mesh.vertices, topology);
  const Values clean = waves(mesh.vertices, 2.0);
  const double range = rangeOf(clean);
  const std::vector<Way> ways{ { "(i) level sets, interpolating", CenterSelection::LevelSets,
                                 LevelSetConstraints::Interpolating },
    { "(ii) level sets, least squares", CenterSelection::LevelSets,
      LevelSetConstraints::LeastSquares },
    { "(iii) vertices, least squares", CenterSelection::Greedy, LevelSetConstraints::LeastSquares },
    { "greedy, interpolating", CenterSelection::Greedy, LevelSetConstraints::Interpolating } };
  for (const double level : { 0.0, 0.01, 0.1 })
  {
    Values noisy = clean;
    addNoise(noisy, level * range, 1);
    ApproximationParameters parameters;
    parameters.sampleFraction = 0.05;
    parameters.persistenceThreshold = std::clamp(8.0 * level * range / rangeOf(noisy), 0.01, 0.7);
    report.head(percent(level) + " noise, PersistenceThreshold " +
        number("%.2f", parameters.persistenceThreshold) + ": f has m, M, s = " +
        countsText(countsOf(domain.criticalPoints(noisy, {}).points)) + " without threshold",
      { "case", "m, M, s", "persistent of f", "kept", "error at vertices", "at stars",
        "on level sets", "of f without noise, root mean square", "all kept" });
    FieldModel levelSets;
    for (const Way& way : ways)
    {
      parameters.centerSelection = way.selection;
      parameters.levelSetConstraints = way.constraints;
      const MeshlessApproximation result = approximateMeshless(domain, noisy, parameters);
      if (levelSets.centers.cols() == 0)
      {
        levelSets = result.model; // interpolates
      }
      const Points samples =
        levelSets.centers.rightCols(levelSets.centers.cols() - result.starCount);
      const Points stars = result.model.centers.leftCols(result.starCount);
      const auto all = static_cast<int>(result.persistent.size());
      const int kept = all - static_cast<int>(result.lost.size());
      report.row({ way.name, countsText(countsOf(result.critical.points)),
        countsText(countsOf(result.persistent)), ofAll(kept, all),
        number("%.1e", result.largestError / range),
        number("%.1e",
          largestMiss(result.model, stars, Field(levelSets).evaluate(stars, {}).values) / range),
        number("%.1e",
          largestMiss(result.model, samples, Field(levelSets).evaluate(samples, {}).values) /
            range),
        number("%.1e",
          (result.values - clean).norm() / std::sqrt(static_cast<double>(clean.size())) / range),
        report.kept(kept == all) });
    }
  }
}

/// Table 4: what is saved, by numbers of centers and in bytes.
void reportSaving(MarkdownReport& report, bool isReduced)
{
  struct Row
  {
    const char* figure;
    int around; ///< of the torus
    Eigen::Index paperVertices;
    Eigen::Index paperCenters;
    const char* paperError;
    const char* paperSaving;
  };
  report.head("Table 4, waves on an irregular torus",
    { "paper", "n", "centers", "error", "saving as printed", "1 - centers / n", "our n",
      "our centers", "our error", "model, bytes", "f as double, bytes", "saved",
      "f as float, saved" });
  for (const Row& row : { Row{ "Fig. 10", 548, 150000, 1251, "1e-4", "99.99%" },
         Row{ "Fig. 11(a)", 126, 8000, 934, "1e-5", "99.88%" },
         Row{ "Fig. 11(b)", 134, 9000, 589, "1e-5", "99.93%" },
         Row{ "Fig. 11(c)", 155, 12000, 446, "1e-6", "99.96%" } })
  {
    if (isReduced && row.paperVertices > 20000)
    {
      continue;
    }
    const Mesh mesh = torusMesh(row.around, true);
    const MeshTopology topology(static_cast<Index>(mesh.vertices.cols()), mesh.triangles);
    const ApproximationDomain domain = surfaceDomain(mesh.vertices, topology);
    const Values values = waves(mesh.vertices, 2.0);
    ApproximationParameters parameters;
    parameters.persistenceThreshold = 0.01;
    parameters.sampleFraction = 1e-6;
    const Eigen::Index stars = approximateMeshless(domain, values, parameters).starCount;
    parameters.sampleFraction =
      static_cast<double>(row.paperCenters - stars) / static_cast<double>(mesh.vertices.cols());
    const MeshlessApproximation result = approximateMeshless(domain, values, parameters);
    const auto bytes = static_cast<double>(bytesOf(result.model));
    const auto asDouble = static_cast<double>(8 * values.size());
    report.row({ row.figure, std::to_string(row.paperVertices), std::to_string(row.paperCenters),
      row.paperError, row.paperSaving,
      percent(1.0 - static_cast<double>(row.paperCenters) / static_cast<double>(row.paperVertices)),
      std::to_string(values.size()), std::to_string(result.model.centers.cols()),
      number("%.1e", result.largestError / rangeOf(values)), std::to_string(bytesOf(result.model)),
      std::to_string(8 * values.size()), percent(1.0 - bytes / asDouble),
      percent(1.0 - 2.0 * bytes / asDouble) });
  }
}

} // namespace

int main(int argc, char** argv)
{
  const Arguments arguments(argc, argv, { "selection", "noise", "saving" }, { "meshes" });
  MarkdownReport report;
  if (arguments.wants("selection"))
  {
    reportSelection(report, arguments.valueOf("meshes"), arguments.isReduced());
  }
  if (arguments.wants("noise"))
  {
    reportNoise(report, arguments.isReduced());
  }
  if (arguments.wants("saving"))
  {
    reportSaving(report, arguments.isReduced());
  }
  return report.exitCode();
}
