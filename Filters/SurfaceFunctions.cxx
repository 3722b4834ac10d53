#include "SurfaceFunctions.h"

#include "GeodesicDistance.h"
#include "NumberText.h"
#include "PropertyChoice.h"
#include "Require.h"

#include "vtkPointSetScalarFunction.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace SurfaceScalars
{
namespace
{

using Filter = vtkPointSetScalarFunction;

constexpr int UsualNeighborCount = 16;
constexpr vtkIdType LastEigenIndex = 299; // all up to it are found at once, in time and memory

// The shares of the whole that end with the graph or mesh and with the Laplacian.
constexpr double SurfaceShare = 0.2;
constexpr double LaplacianShare = 0.3;

void checkNotNegative(const std::string& property, double value, const std::string& zero)
{
  require(value >= 0.0 && std::isfinite(value), "a " + property + " of at least 0", textOf(value),
    "0 " + zero + ".");
}

NeighborQuery neighborQuery(Filter& filter)
{
  checkNotNegative(
    "NeighborCount", filter.GetNeighborCount(), "takes " + std::to_string(UsualNeighborCount));
  checkNotNegative("SearchRadius", filter.GetSearchRadius(), "leaves it to NeighborCount");
  NeighborQuery query;
  query.count = filter.GetNeighborCount() > 0 ? filter.GetNeighborCount() : UsualNeighborCount;
  query.radius = filter.GetSearchRadius();
  return query;
}

/// A Laplacian and which of its rows is which point.
struct SurfaceLaplacian
{
  Laplacian laplacian;
  VertexMap map;
};

bool needTriangles(LaplacianWeights weights)
{
  return weights == LaplacianWeights::Cotangent ||
    weights == LaplacianWeights::NormalizedCotangent || weights == LaplacianWeights::MeanValue;
}

SurfaceLaplacian surfaceLaplacian(
  const PointChoice& choice, vtkPolyData* surface, FilterRun& run, const Execution& execution)
{
  Filter& filter = choice.filter;
  const auto weights = static_cast<LaplacianWeights>(filter.GetWeights());
  const Execution surfacePart = execution.part(0.0, SurfaceShare);
  const Execution laplacianPart = execution.part(SurfaceShare, LaplacianShare);
  if (!needTriangles(weights))
  {
    checkNotNegative("KernelWidth", filter.GetKernelWidth(), "chooses it from the sampling");
    SampledSurface sampled = sampledSurface(choice.points, neighborQuery(filter), surfacePart);
    return { pointSetLaplacian(sampled.graph, weights, filter.GetKernelWidth(), laplacianPart),
      std::move(sampled.map) };
  }
  MeshedSurface mesh = meshedSurface(choice.points, surface, surfacePart);
  const Eigen::Index finite = choice.points.array().isFinite().colwise().all().count();
  noteOutside(run, mesh.map, choice.points.cols() - finite);
  return { meshLaplacian(mesh.vertices, mesh.triangles, weights, laplacianPart),
    std::move(mesh.map) };
}

SurfaceFunction geodesic(const PointChoice& choice, FilterRun& run, const Execution& execution)
{
  const SampledSurface sampled =
    sampledSurface(choice.points, neighborQuery(choice.filter), execution.part(0.0, SurfaceShare));
  const std::vector<Index> sources = chosenSources(choice, sampled.map);
  Values distance = geodesicDistance(sampled.graph, sources, execution.part(SurfaceShare, 1.0));
  SurfaceFunction result;
  result.values = sampled.map.atPoints(distance);
  const Eigen::Index unreached = result.values.array().isInf().count();
  if (unreached > 0)
  {
    const double none = std::numeric_limits<double>::quiet_NaN();
    result.values = result.values.array().isInf().select(none, result.values);
    run.note(std::to_string(unreached) + " of " + std::to_string(result.values.size()) +
      " points cannot be reached from the sources and get NaN; raise NeighborCount if the "
      "surface is in one piece.");
  }
  return result;
}

SurfaceFunction harmonic(
  const PointChoice& choice, const SurfaceLaplacian& surface, const Execution& execution)
{
  const std::vector<ValueConstraint> constraints = chosenConstraints(choice, surface.map);
  return { surface.map.atPoints(
    harmonicFunction(surface.laplacian, constraints, execution, surface.map.names())) };
}

SurfaceFunction eigenfunction(
  const PointChoice& choice, const SurfaceLaplacian& surface, const Execution& execution)
{
  const int index = choice.filter.GetEigenIndex();
  const auto last =
    std::min(LastEigenIndex, static_cast<vtkIdType>(surface.map.pointOfVertex.size()) - 2);
  require(index >= 0 && index <= last, "an EigenIndex from 0 to " + std::to_string(last),
    std::to_string(index), "0 is the constant function.");
  const Eigenfunctions found = laplacianEigenfunctions(surface.laplacian, index + 1, execution);
  return { surface.map.atPoints(found.functions.col(index)), found.eigenvalues(index) };
}

/// The square of a tenth of the diagonal: heat then has spread that far.
double automaticTime(const PointChoice& choice, const VertexMap& map)
{
  const Points vertices = choice.points(Eigen::all, map.pointOfVertex);
  const double diagonal = (vertices.rowwise().maxCoeff() - vertices.rowwise().minCoeff()).norm();
  return 0.01 * diagonal * diagonal;
}

/// A unit of heat at each source.
SurfaceFunction diffusion(
  const PointChoice& choice, const SurfaceLaplacian& surface, const Execution& execution)
{
  const double given = choice.filter.GetDiffusionTime();
  checkNotNegative("DiffusionTime", given, "takes the square of a tenth of the diagonal");
  Values heat = Values::Zero(surface.laplacian.mass.size());
  for (const Index source : chosenSources(choice, surface.map))
  {
    heat(source) = 1.0 / surface.laplacian.mass(source);
  }
  require(given > 0.0 || choice.filter.GetWeights() != Filter::NORMALIZED_COTANGENT,
    "a DiffusionTime above 0 for NormalizedCotangent", "0",
    "Without areas it has no unit: in a time of 100 heat passes about ten edges.");
  const double time = given > 0.0 ? given : automaticTime(choice, surface.map);
  return { surface.map.atPoints(diffuse(surface.laplacian, heat, time, execution)) };
}

} // namespace

SurfaceFunction surfaceFunction(
  const PointChoice& choice, vtkPolyData* surface, FilterRun& run, const Execution& execution)
{
  Filter& filter = choice.filter;
  checkChoice(
    "SourceType", filter.GetSourceType(), { 0, 1, 2 }, "0 (Ids), 1 (Selection) or 2 (Point)");
  checkChoice("Weights", filter.GetWeights(), { 0, 1, 2, 3, 4, 5 },
    "from 0 (Gaussian) to 5 (MeanValue), such as 2 (LocalScale)");
  if (filter.GetFunction() == Filter::GEODESIC)
  {
    return geodesic(choice, run, execution);
  }
  const SurfaceLaplacian operation = surfaceLaplacian(choice, surface, run, execution);
  const Execution solution = execution.part(LaplacianShare, 1.0);
  switch (filter.GetFunction())
  {
    case Filter::HARMONIC:
      return harmonic(choice, operation, solution);
    case Filter::LAPLACIAN_EIGENFUNCTION:
      return eigenfunction(choice, operation, solution);
    default:
      return diffusion(choice, operation, solution);
  }
}

} // namespace SurfaceScalars
