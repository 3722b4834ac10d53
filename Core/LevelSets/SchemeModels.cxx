#include "SchemeModels.h"

#include "FieldChoices.h"
#include "FieldSchemes.h"
#include "ImplicitSurface.h"
#include "NeighborhoodSize.h"
#include "NormalOrientation.h"
#include "Quantile.h"

#include <algorithm>
#include <cmath>

namespace SurfaceScalars
{
namespace
{

constexpr double LargestMiss = 0.05; // of an average that is still used, in sampling steps

/// F where it is given.
class GivenField : public FieldApproximation
{
public:
  explicit GivenField(const VolumeFunction& function)
    : function_(function)
  {
  }

  bool center(const Vector3d&) override { return true; }
  FieldJet jet(const Vector3d& place, Derivatives) const override
  {
    FieldJet result;
    result.value = this->function_(place, &result.gradient);
    return result;
  }

private:
  const VolumeFunction& function_;
};

bool isRadial(Scheme scheme)
{
  return scheme == Scheme::LocalRBF || scheme == Scheme::Hybrid;
}

FieldParameters fieldParameters(
  const SampledFunction& function, const FitSize& size, const ContourParameters& parameters)
{
  FieldParameters result;
  result.scheme = parameters.scheme;
  result.kernel = parameters.kernel;
  result.kernelWidth = parameters.kernelWidth;
  // What interpolates gains nothing from neighborhoods that are large because of noise.
  result.neighborCount = isRadial(parameters.scheme) ? parameters.neighborCount : size.count;
  result.searchRadius = size.radius;
  result.polynomialDegree = polynomialDegree(parameters);
  return completed(result, { function.graph, function.values }, {});
}

/// How much f changes over LargestMiss, typically. Where averages would miss f by more, curves
/// would break at the jump to the interpolants.
double hybridThreshold(const SampledFunction& function)
{
  const NeighborGraph& graph = function.graph;
  return LargestMiss *
    medianOfSome(graph.pointCount(),
      [&](std::size_t i)
      {
        const auto from = static_cast<Index>(i);
        double steepest = 0.0;
        for (const Index to : graph.neighbors(from))
        {
          const double distance = (graph.points().col(to) - graph.points().col(from)).norm();
          steepest =
            std::max(steepest, std::abs(function.values[to] - function.values[from]) / distance);
        }
        return steepest * graph.samplingStep(from);
      });
}

std::unique_ptr<FieldApproximation> makeField(
  const SampledFunction& function, const FitSize& size, const ContourParameters& parameters)
{
  if (function.volumeFunction)
  {
    return std::make_unique<GivenField>(function.volumeFunction);
  }
  const FieldSamples samples{ function.graph, function.values };
  const FieldParameters field = fieldParameters(function, size, parameters);
  switch (parameters.scheme)
  {
    case Scheme::LocalRBF:
      return makeLocalRBF(samples, field);
    case Scheme::Hybrid:
      return makeHybrid(samples, field, function.missed);
    case Scheme::ExplicitMLS:
      return makeExplicitMLS(samples, field);
    default:
      return makeParameterizedMLS(samples, field);
  }
}

std::unique_ptr<FieldApproximation> makeSurface(
  const SampledFunction& function, const FitSize& size, const ContourParameters& parameters)
{
  if (parameters.surface != SurfaceModel::RBF)
  {
    return makePolynomialSurface(function.graph, size, polynomialDegree(parameters));
  }
  // Larger neighborhoods than usual are asked for where there is noise.
  const bool isClean = !(size.radius > 0.0) && size.count <= 2 * UsualNeighborCount;
  const RadialSurfaceFit fit =
    isClean ? RadialSurfaceFit::Interpolate : RadialSurfaceFit::LeastSquares;
  return makeRadialSurface(
    { function.graph, function.normals }, size, { fit, parameters.kernel, parameters.kernelWidth });
}

} // namespace

int polynomialDegree(const ContourParameters& parameters)
{
  return parameters.scheme == Scheme::ParameterizedMLS ? parameters.polynomialDegree : 2;
}

bool usesKernel(const ContourParameters& parameters)
{
  return isRadial(parameters.scheme) || parameters.surface == SurfaceModel::RBF;
}

void prepareModels(SampledFunction& function, const FitSize& size,
  const ContourParameters& parameters, const Execution& execution)
{
  if (parameters.surface == SurfaceModel::RBF)
  {
    function.normals = estimateNormals(function.graph, size, execution.part(0.0, 0.6));
    orientNormals(function.graph, function.normals, execution.part(0.6, 0.8));
  }
  if (parameters.scheme == Scheme::Hybrid && !function.volumeFunction)
  {
    FieldParameters field = fieldParameters(function, size, parameters);
    field.hybridThreshold = hybridThreshold(function);
    function.missed =
      markMissedSamples({ function.graph, function.values }, field, execution.part(0.8, 1.0));
  }
}

std::unique_ptr<LevelSetModel> makeModel(
  const SampledFunction& function, const FitSize& size, const ContourParameters& parameters)
{
  const bool isRadialField = isRadial(parameters.scheme) && !function.volumeFunction;
  if (isRadialField || parameters.surface == SurfaceModel::RBF)
  {
    return makeImplicitModel(function.graph, size, makeField(function, size, parameters),
      makeSurface(function, size, parameters));
  }
  return parameters.scheme == Scheme::ExplicitMLS
    ? makeAverageModel(function, size, parameters.kernelWidth)
    : makePolynomialModel(function, size, polynomialDegree(parameters));
}

} // namespace SurfaceScalars
