#include "FieldChecks.h"

#include "LocalFit.h"
#include "NumberText.h"
#include "Require.h"

#include <Eigen/Eigenvalues>

#include <cmath>
#include <string>

namespace SurfaceScalars
{
namespace
{

// Dense systems larger than this take seconds for each place.
constexpr std::size_t MostNeighbors = 2000;
constexpr double LargestValue = 1e300; // sums of terms that cancel each other are larger

void requireLength(double length, const char* name)
{
  require(std::isfinite(length) && length >= 0.0,
    std::string("a ") + name + " of 0 (automatic) or more", textOf(length), "Correct it.");
}

bool usesKernel(const FieldParameters& parameters)
{
  return parameters.scheme == Scheme::LocalRBF || parameters.scheme == Scheme::Hybrid ||
    parameters.scheme == Scheme::GlobalRBF;
}

/// On a line the samples determine no tangent plane. Told by the directions from one sample to the
/// next, not by the shape of the whole, which one stray point can stretch.
void requireSpread(const Points& points)
{
  Eigen::Matrix3d directions = Eigen::Matrix3d::Zero();
  for (Eigen::Index i = 1; i < points.cols(); ++i)
  {
    const Vector3d direction = (points.col(i) - points.col(i - 1)).stableNormalized();
    directions += direction * direction.transpose();
  }
  const Vector3d spread =
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(directions, Eigen::EigenvaluesOnly)
      .eigenvalues();
  require(spread[1] > 1e-13 * spread[2],
    "points spread over a surface for the ParameterizedMLS scheme",
    std::to_string(points.cols()) + " points on one line",
    "Choose the LocalRBF scheme or another input.");
}

} // namespace

void checkFieldParameters(const FieldParameters& parameters)
{
  const auto number = static_cast<int>(parameters.scheme);
  require(
    number > static_cast<int>(Scheme::Linear) && number <= static_cast<int>(Scheme::GlobalRBF),
    "one of the schemes ExplicitMLS, ParameterizedMLS, LocalRBF, Hybrid and GlobalRBF",
    "number " + std::to_string(number), "Choose LocalRBF if in doubt.");
  require(parameters.neighborCount >= 0, "a NeighborCount of 0 (automatic) or more",
    std::to_string(parameters.neighborCount), "Raise it.");
  requireLength(parameters.searchRadius, "SearchRadius");
  requireLength(parameters.kernelWidth, "KernelWidth");
  require(std::isfinite(parameters.regularization) && parameters.regularization >= 0.0,
    "a finite Regularization of 0 or more", textOf(parameters.regularization),
    "Use 0 to interpolate.");
  require(std::isfinite(parameters.hybridThreshold) && parameters.hybridThreshold >= 0.0,
    "a finite threshold of the Hybrid scheme of 0 or more", textOf(parameters.hybridThreshold),
    "Use 0.01 if in doubt.");
  const int degree = parameters.polynomialDegree;
  require(parameters.scheme != Scheme::ParameterizedMLS ||
      (degree >= 1 && degree <= LocalFit::MaximumDegree),
    "a polynomial degree from 1 to 4", std::to_string(degree), "Choose 2 if in doubt.");
  require(!usesKernel(parameters) || parameters.kernel != KernelType::Harmonic,
    "a kernel that is finite at its center", nameOf(parameters.kernel),
    "Choose Cubic if in doubt.");
}

void checkFieldValues(const ValuesRef& values, std::size_t pointCount)
{
  require(static_cast<std::size_t>(values.size()) == pointCount, "one value per point",
    std::to_string(values.size()) + " values for " + std::to_string(pointCount) + " points",
    "Leave points without a value out.");
  require(
    values.allFinite(), "finite values", "NaN or infinity", "Leave points without a value out.");
  const double largest = values.size() > 0 ? values.lpNorm<Eigen::Infinity>() : 0.0;
  require(largest <= LargestValue, "values of " + textOf(LargestValue) + " at most",
    textOf(largest), "Divide them by a power of ten.");
}

void checkFieldSamples(const PointCloud& cloud, const FieldParameters& parameters)
{
  if (parameters.scheme != Scheme::ParameterizedMLS)
  {
    return;
  }
  const int terms = LocalFit::termCount(parameters.polynomialDegree);
  const std::string fewest = std::to_string(terms + 1); // the sample at the rim weighs nothing
  require(static_cast<int>(cloud.pointCount()) > terms,
    "at least " + fewest + " different points with a value to fit polynomials of degree " +
      std::to_string(parameters.polynomialDegree),
    std::to_string(cloud.pointCount()),
    "Choose a larger input, a lower PolynomialDegree or the LocalRBF scheme.");
  require(parameters.neighborCount == 0 || parameters.neighborCount > terms,
    "a NeighborCount of 0 (automatic) or at least " + fewest,
    std::to_string(parameters.neighborCount), "Raise it or lower PolynomialDegree.");
  requireSpread(cloud.points());
}

void checkNeighborhood(std::size_t sampleCount)
{
  if (sampleCount > MostNeighbors) // asked for each place, so no sentence in vain
  {
    throw InvalidInput("at most " + std::to_string(MostNeighbors) + " samples in a neighborhood",
      std::to_string(sampleCount), "Lower SearchRadius or NeighborCount.");
  }
}

void checkFieldModel(const FieldModel& model)
{
  checkFieldParameters(model.parameters);
  require(model.centers.cols() > 0, "a model with centers", "none", "Make it anew.");
  require(model.centers.cols() == model.coefficients.size(), "one coefficient per center",
    std::to_string(model.coefficients.size()) + " for " + std::to_string(model.centers.cols()),
    "Make the model anew.");
  require(model.centers.allFinite() && model.coefficients.allFinite() && model.tail.allFinite() &&
      model.tailOrigin.allFinite(),
    "a model of finite numbers", "NaN or infinity", "Make it anew.");
  require(model.lowest <= model.highest, "a range of values",
    textOf(model.lowest) + " to " + textOf(model.highest), "Make the model anew.");
  require(model.parameters.scheme == Scheme::GlobalRBF || model.parameters.neighborCount > 0 ||
      model.parameters.searchRadius > 0.0,
    "a model with its number of neighbors", "0", "Make it anew.");
  require(model.parameters.neighborCount <= model.centers.cols(),
    "a model with no more neighbors than its " + std::to_string(model.centers.cols()) + " centers",
    std::to_string(model.parameters.neighborCount), "Make it anew.");
  require(model.parameters.scheme != Scheme::GlobalRBF || model.parameters.kernelWidth > 0.0,
    "a model of the GlobalRBF scheme with a positive KernelWidth",
    textOf(model.parameters.kernelWidth), "Make it anew.");
}

void checkEvaluation(const EvaluationParameters& parameters)
{
  require(std::isfinite(parameters.maximumDistance) && parameters.maximumDistance >= 0.0,
    "a MaximumDistance of 0 (unlimited) or more", textOf(parameters.maximumDistance),
    "Correct it.");
}

} // namespace SurfaceScalars
