// Prints how accurate Tikhonov's smoothing and the choice of epsilon are, as tables in Markdown for
// Documentation. The exit code tells whether the bounds hold.

#include "Arguments.h"
#include "LaplacianFunctions.h"
#include "MarkdownReport.h"
#include "Meshes.h"
#include "SmoothingRun.h"

#include <algorithm>
#include <cmath>
#include <complex>

using namespace SurfaceScalars;
using namespace SurfaceScalars::Truth;

namespace
{

constexpr int Degree = 6; // of the spherical harmonic
constexpr double MostOff = 0.01;
constexpr double MostOfBest = 1.25;

/// Of the harmonic of degree 6 that waves around the equator, with the epsilon of half of it; the
/// unit sphere enlarged.
double gainOf(TriangleMesh mesh, double enlarged)
{
  Values harmonic(mesh.points.cols());
  for (Eigen::Index i = 0; i < harmonic.size(); ++i)
  {
    harmonic[i] = std::pow(std::complex(mesh.points(0, i), mesh.points(1, i)), Degree).real();
  }
  mesh.points *= enlarged;
  const SmoothingMesh smoothingMesh(mesh.points, trianglesOf(mesh));
  SmoothingNorms norms;
  norms.metric = DataMetric::LumpedMass;
  const TikhonovSmoother& smoother = smoothingMesh.smoother(norms);
  const double epsilon = std::pow(Degree * (Degree + 1) * 4.0 * Pi, 2);
  const Values smooth = smoother.smooth(harmonic, epsilon);
  return smoother.product(harmonic, smooth) / smoother.product(harmonic, harmonic);
}

void printGains(MarkdownReport& report)
{
  report.head("Gain", { "vertices", "gain at l = 6", "lengths times 1000", "within 1%" });
  for (const int segments : { 50, 100, 200 })
  {
    const TriangleMesh sphere = octahedralSphere(segments);
    const double gain = gainOf(sphere, 1.0);
    const double enlarged = gainOf(sphere, 1000.0);
    report.row(
      { std::to_string(sphere.points.cols()), number("%.5f", gain), number("%.5f", enlarged),
        report.kept(std::abs(gain - 0.5) <= 0.5 * MostOff && std::abs(gain - enlarged) <= 1e-6) });
  }
}

/// Those of degree l are l (l + 1), 2 l + 1 times.
void printEigenvalues(MarkdownReport& report)
{
  const TriangleMesh sphere = octahedralSphere(100);
  report.head(
    "Eigenvalues of the unit sphere, " + std::to_string(sphere.points.cols()) + " vertices",
    { "l", "l (l + 1)", "least", "greatest", "within 1%" });
  const Laplacian laplacian =
    meshLaplacian(sphere.points, trianglesOf(sphere), LaplacianWeights::Cotangent);
  const Values eigenvalues =
    laplacianEigenfunctions(laplacian, (Degree + 1) * (Degree + 1)).eigenvalues;
  for (int degree = 1; degree <= Degree; ++degree)
  {
    const auto ofDegree = eigenvalues.segment(degree * degree, 2 * degree + 1);
    const double exact = degree * (degree + 1);
    report.row({ std::to_string(degree), number("%g", exact), number("%.4f", ofDegree.minCoeff()),
      number("%.4f", ofDegree.maxCoeff()),
      report.kept(((ofDegree.array() - exact).abs() <= MostOff * exact).all()) });
  }
}

/// The error with the epsilon of cross-validation and with the best of epsilons up to a thousand
/// times smaller and larger.
void printCrossValidation(MarkdownReport& report, const std::vector<SmoothingCase>& cases)
{
  report.head("Cross-validation",
    { "mesh", "noise", "error", "best epsilon's", "ratio", "best epsilon / chosen",
      "at most 1.25" });
  for (const SmoothingCase& smoothingCase : cases)
  {
    const SmoothingMesh mesh(smoothingCase.mesh.points, trianglesOf(smoothingCase.mesh));
    const TikhonovSmoother& smoother = mesh.smoother({});
    for (const double noise : { 0.01, 0.05, 0.1 })
    {
      const Values noisy = smoothingCase.noisy(noise, 1);
      const auto errorOf = [&](double epsilon)
      {
        const Values errors = smoother.smooth(noisy, epsilon) - smoothingCase.clean;
        return errors.norm() / std::sqrt(static_cast<double>(errors.size())) / smoothingCase.range;
      };
      const double chosen =
        chooseEpsilon(mesh.curve({}, noisy, EpsilonChoice::GCV), EpsilonChoice::GCV);
      const double error = errorOf(chosen);
      double least = error;
      double best = 1.0;
      for (int power = -10; power <= 10; ++power)
      {
        const double factor = std::exp2(power);
        const double other = errorOf(factor * chosen);
        best = other < least ? factor : best;
        least = std::min(least, other);
      }
      report.row({ smoothingCase.name, number("%g%%", 100.0 * noise), number("%.5f", error),
        number("%.5f", least), number("%.3f", error / least), number("%g", best),
        report.kept(error <= MostOfBest * least) });
    }
  }
}

} // namespace

// usage: surface-scalars-smoothing-accuracy [meshes FOLDER]
int main(int argc, char** argv)
{
  const Arguments arguments(argc, argv, {}, { "meshes" });
  MarkdownReport report;
  printGains(report);
  printEigenvalues(report);
  printCrossValidation(report, smoothingCases(arguments.valueOf("meshes")));
  return report.exitCode();
}
