#include "SampleChecks.h"

#include "LocalFit.h"
#include "Require.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <string>

namespace SurfaceScalars
{

void checkSampleValues(const ValuesRef& values, const NeighborGraph& graph)
{
  require(
    values.allFinite(), "finite values", "NaN or infinity", "Leave points without a value out.");
  require(values.size() == graph.pointCount(), "one value per point",
    std::to_string(values.size()) + " values for " + std::to_string(graph.pointCount()) + " points",
    "Leave points without a value out.");
}

void checkPointCount(const NeighborGraph& graph, int degree, int neighborCount)
{
  const int terms = LocalFit::termCount(degree);
  const int fewest = terms + 1; // the point in the middle, and the sample at the rim weighs nothing
  require(static_cast<int>(graph.pointCount()) >= fewest,
    "at least " + std::to_string(fewest) + " different points with a value to fit a surface",
    std::to_string(graph.pointCount()), "Choose a larger input or a lower PolynomialDegree.");
  require(neighborCount == 0 || neighborCount >= fewest,
    "a NeighborCount of 0 (automatic) or at least " + std::to_string(fewest),
    std::to_string(neighborCount), "Raise it or lower PolynomialDegree.");
}

void checkSpread(const NeighborGraph& graph)
{
  const Index stride = std::max<Index>(1, graph.pointCount() / 1000);
  Eigen::Matrix3d directions = Eigen::Matrix3d::Zero();
  Vector3d spread = Vector3d::Zero();
  for (Index i = 0; i < graph.pointCount(); i += stride)
  {
    for (const Index neighbor : graph.neighbors(i))
    {
      const Vector3d direction =
        (graph.points().col(neighbor) - graph.points().col(i)).stableNormalized();
      directions += direction * direction.transpose();
    }
    spread = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(directions, Eigen::EigenvaluesOnly)
               .eigenvalues();
    if (spread[1] > 1e-2 * spread[2])
    {
      return; // mostly at the first point: no number of further directions could undo that
    }
  }
  require(spread[1] > 1e-13 * spread[2], "points spread over a surface",
    std::to_string(graph.pointCount()) + " points on one line", "Choose another input.");
}

} // namespace SurfaceScalars
