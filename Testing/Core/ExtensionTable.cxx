// Prints how accurate fields are between their samples, as tables in Markdown for Documentation.
// The exit code tells whether the schemes converge as theory says.

#include "Arguments.h"
#include "Field.h"
#include "Functions.h"
#include "MarkdownReport.h"
#include "Sampling.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace SurfaceScalars;
using namespace SurfaceScalars::Truth;

namespace
{

const SpaceFunction Function = saddleWithLogarithm();
constexpr int TargetCount = 5000;
constexpr unsigned TargetSeed = 99;

MarkdownReport report;

double range(const Values& values)
{
  return values.maxCoeff() - values.minCoeff();
}

double rootMeanSquare(const Values& values)
{
  return std::sqrt(values.squaredNorm() / static_cast<double>(values.size()));
}

/// f~ - f at places, as a fraction of f's range.
Values errorsAt(const Points& places, const Field& field, const Values& samples)
{
  return (field.evaluate(places, {}).values - valuesOf(Function, places)) / range(samples);
}

struct Contestant
{
  std::string name;
  FieldParameters parameters;
  double order;    ///< of the root mean square error in the sampling step, by theory
  int mostSamples; ///< it can have in reasonable time
};

std::vector<Contestant> contestants()
{
  const auto make = [](const char* name, Scheme scheme, double order, int most = 1 << 30)
  {
    Contestant contestant{ name, {}, order, most };
    contestant.parameters.scheme = scheme;
    return contestant;
  };
  std::vector<Contestant> all;
  all.push_back(make("ExplicitMLS", Scheme::ExplicitMLS, 1.0));
  for (const int degree : { 1, 2, 3, 4 })
  {
    all.push_back(make("ParameterizedMLS", Scheme::ParameterizedMLS, degree + 1.0));
    all.back().name += ", degree " + std::to_string(degree);
    all.back().parameters.polynomialDegree = degree;
  }
  all.push_back(make("LocalRBF, cubic", Scheme::LocalRBF, 2.0));
  all.push_back(make("Hybrid", Scheme::Hybrid, 0.0)); // one or the other: no order, but a bound
  all.push_back(make("GlobalRBF, cubic", Scheme::GlobalRBF, 2.0, 3200));
  return all;
}

/// The slope of log(error) against log(step), by least squares over what is not yet rounding.
double observedOrder(const std::vector<int>& counts, const std::vector<double>& errors)
{
  double n = 0.0, sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
  for (std::size_t i = 0; i < errors.size(); ++i)
  {
    if (counts[i] < 1000 || errors[i] < 1e-13)
    {
      continue; // with fewer samples a neighborhood is as large as the tube of the torus
    }
    const double x = -0.5 * std::log(counts[i]); // of the sampling step
    const double y = std::log(errors[i]);
    n += 1.0;
    sx += x;
    sy += y;
    sxx += x * x;
    sxy += x * y;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

// Root mean square errors between the samples fall with the sampling step at least as fast as
// theory says: with the order of the polynomials that a scheme reproduces, plus one.
void printConvergence()
{
  const std::vector<int> counts{ 100, 316, 1000, 3162, 10000, 31623, 100000 };
  std::vector<std::string> head{ "scheme" };
  for (const int count : counts)
  {
    head.push_back(std::to_string(count));
  }
  head.insert(head.end(), { "order", "theory", "kept" });
  report.head("Root mean square error between the samples, as a fraction of f's range", head);
  const Points targets = randomTorus(TargetCount, Torus::Closed, TargetSeed);
  for (const Contestant& contestant : contestants())
  {
    std::vector<double> errors;
    std::vector<std::string> row{ contestant.name };
    for (const int count : counts)
    {
      if (count > contestant.mostSamples)
      {
        row.emplace_back();
        continue;
      }
      const Points points = randomTorus(count, Torus::Closed, 1);
      const Values values = valuesOf(Function, points);
      const Field field = Field::fit(points, values, contestant.parameters);
      errors.push_back(rootMeanSquare(errorsAt(targets, field, values)));
      row.push_back(number("%.1e", errors.back()));
    }
    if (contestant.order > 0.0)
    {
      const double order = observedOrder(counts, errors);
      row.insert(row.end(),
        { number("%.1f", order), number("%.0f", contestant.order),
          report.kept(order > contestant.order - 0.25) });
    }
    else
    {
      const double bound = contestant.parameters.hybridThreshold;
      const bool below =
        std::all_of(errors.begin() + 2, errors.end(), [=](double error) { return error <= bound; });
      row.insert(row.end(), { "", "below " + number("%g", bound), report.kept(below) });
    }
    report.row(row);
  }
}

// The point-set paper's Table 1: f sampled on a noisy torus, (6) evaluated at the samples. Its
// noise and lengths have no usable unit, so that here noise is a fraction of the diagonal.
void printNoisyTorus()
{
  report.head("Table 1 of the paper: largest error of (6) at the samples of a noisy torus",
    { "points", "paper", "no noise", "0.1% noise", "0.5% noise", "1% noise",
      "ParameterizedMLS, 1% noise" });
  const std::vector<std::pair<int, double>> paper{ { 50000, 7.36e-2 }, { 90000, 6.65e-2 },
    { 116000, 5.98e-2 }, { 145000, 5.02e-2 }, { 160000, 2.54e-2 }, { 994000, 2.69e-2 } };
  for (const auto& [count, theirs] : paper)
  {
    std::vector<std::string> row{ std::to_string(count), number("%.2e", theirs) };
    const auto largest = [&, count = count](double noise, Scheme scheme)
    {
      Points points = randomTorus(count, Torus::Closed, 1);
      addNoise(points, noise * torusDiagonal(), 2);
      const Values values = valuesOf(Function, points);
      FieldParameters parameters;
      parameters.scheme = scheme;
      parameters.neighborCount = 16;
      const Field field = Field::fit(points, values, parameters);
      return number("%.2e", (field.evaluate(points, {}).values - values).lpNorm<Eigen::Infinity>());
    };
    for (const double noise : { 0.0, 0.001, 0.005, 0.01 })
    {
      row.push_back(largest(noise, Scheme::ExplicitMLS));
    }
    row.push_back(largest(0.01, Scheme::ParameterizedMLS));
    report.row(row);
  }
}

} // namespace

// Without arguments all tables; otherwise those named: convergence, noise.
int main(int argc, char** argv)
{
  const Arguments arguments(argc, argv, { "convergence", "noise" });
  if (arguments.wants("convergence"))
  {
    printConvergence();
  }
  if (arguments.wants("noise"))
  {
    printNoisyTorus();
  }
  return report.exitCode();
}
