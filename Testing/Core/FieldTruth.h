#pragma once

#include "Field.h"
#include "Functions.h"
#include "Sampling.h"

#include <string>
#include <vector>

namespace SurfaceScalars::Truth
{

/// Samples of a function.
struct FieldInput
{
  Points points;
  Values values;
};

inline FieldInput torusInput(int count, unsigned seed)
{
  const Points points = randomTorus(count, Torus::Closed, seed);
  return { points, valuesOf(saddleWithLogarithm(), points) };
}

/// In a cube around the origin.
inline Points randomPlaces(int count, double halfWidth, unsigned seed)
{
  Random random(seed);
  Points places(3, count);
  for (Eigen::Index i = 0; i < places.size(); ++i)
  {
    places.data()[i] = random.uniform(-halfWidth, halfWidth);
  }
  return places;
}

inline FieldParameters parametersOf(Scheme scheme, KernelType kernel = KernelType::Cubic)
{
  FieldParameters parameters;
  parameters.scheme = scheme;
  parameters.kernel = kernel;
  return parameters;
}

/// Those that can interpolate.
inline std::vector<KernelType> interpolatingKernels()
{
  return { KernelType::Gaussian, KernelType::Exponential, KernelType::Linear, KernelType::Cubic,
    KernelType::ThinPlate, KernelType::Multiquadric, KernelType::InverseMultiquadric,
    KernelType::Wendland, KernelType::Wu };
}

/// Every local scheme, LocalRBF with every kernel, with k neighbors and with a radius.
inline std::vector<FieldParameters> localSchemes()
{
  std::vector<FieldParameters> schemes{ parametersOf(Scheme::ExplicitMLS),
    parametersOf(Scheme::ParameterizedMLS), parametersOf(Scheme::Hybrid) };
  for (const KernelType kernel : interpolatingKernels())
  {
    schemes.push_back(parametersOf(Scheme::LocalRBF, kernel));
  }
  for (const Scheme scheme : { Scheme::ExplicitMLS, Scheme::ParameterizedMLS, Scheme::LocalRBF })
  {
    schemes.push_back(parametersOf(scheme));
    schemes.back().searchRadius = 0.3;
  }
  return schemes;
}

inline std::string describe(const FieldParameters& parameters)
{
  return "scheme " + std::to_string(static_cast<int>(parameters.scheme)) + ", kernel " +
    nameOf(parameters.kernel) + ", radius " + std::to_string(parameters.searchRadius);
}

inline EvaluationParameters withHessian()
{
  EvaluationParameters parameters;
  parameters.derivatives = Derivatives::Hessian;
  return parameters;
}

} // namespace SurfaceScalars::Truth
