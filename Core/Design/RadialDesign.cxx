#include "RadialDesign.h"

#include "Error.h"
#include "LinearTerms.h"
#include "LinkNormal.h"
#include "Orientation.h"
#include "Places.h"
#include "RadialRefusal.h"
#include "Require.h"
#include "RidgeSystem.h"

#include <Eigen/LU>

#include <limits>
#include <string>

namespace SurfaceScalars
{
namespace
{

constexpr double OffsetInEdges = 2.0; // of the centers of 1 / r
constexpr std::size_t Grain = 256;    // vertices per block of a parallel loop
constexpr double LeastRidge = 1e-12;  // regularization with which a width is chosen

/// The vertices of constraints.
Points centersOf(const Points& vertices, const std::vector<ValueConstraint>& constraints)
{
  return placesOf(constraints,
    [&](const ValueConstraint& constraint) { return vertices.col(constraint.vertex); });
}

Values valuesOf(const std::vector<ValueConstraint>& constraints)
{
  Values result(constraints.size());
  for (std::size_t i = 0; i < constraints.size(); ++i)
  {
    result[static_cast<Eigen::Index>(i)] = constraints[i].value;
  }
  return result;
}

/// Away from the origin, or upwards, whichever way triangles run.
Vector3d normalAt(const DesignMesh& mesh, Index vertex, const Vector3d& origin)
{
  const Vector3d normal = linkNormal(mesh.vertices(), mesh.topology(), vertex).normalized();
  const Vector3d place = mesh.vertices().col(vertex);
  return isOutwards(place - origin, normal) ? normal : Vector3d(-normal);
}

Points offsetCenters(const DesignMesh& mesh, const std::vector<ValueConstraint>& constraints)
{
  const Points& vertices = mesh.vertices();
  const Vector3d origin = vertices.rowwise().mean();
  return placesOf(constraints,
    [&](const ValueConstraint& constraint) -> Vector3d
    {
      const Vector3d place = vertices.col(constraint.vertex);
      const VertexRange link = mesh.topology().link(constraint.vertex);
      double length = 0.0;
      for (const Index neighbor : link)
      {
        length += (vertices.col(neighbor) - place).norm() / link.size();
      }
      return place + OffsetInEdges * length * normalAt(mesh, constraint.vertex, origin);
    });
}

/// sum a_j / |p - c_j| with this sum at the constraints.
Values harmonicThrough(const DesignMesh& mesh, const std::vector<ValueConstraint>& constraints,
  const Execution& execution)
{
  const Points centers = offsetCenters(mesh, constraints);
  const auto rowAt = [&](const Vector3d& place) -> Eigen::RowVectorXd
  { return (centers.colwise() - place).colwise().norm().cwiseInverse(); };
  const Points places = centersOf(mesh.vertices(), constraints);
  Eigen::MatrixXd matrix(centers.cols(), centers.cols());
  for (Eigen::Index i = 0; i < places.cols(); ++i)
  {
    matrix.row(i) = rowAt(places.col(i));
  }
  const Eigen::PartialPivLU<Eigen::MatrixXd> factors(matrix);
  const Values coefficients = factors.solve(valuesOf(constraints));
  const double precision =
    static_cast<double>(centers.cols()) * std::numeric_limits<double>::epsilon();
  if (!matrix.allFinite() || !(factors.rcond() > precision) || !coefficients.allFinite())
  {
    refuseSystem("a singular one", { KernelType::Harmonic, 1.0 }, 1.0 / factors.rcond());
  }
  Values result(mesh.vertices().cols());
  parallelFor(static_cast<std::size_t>(result.size()), Grain, execution,
    [&](std::size_t begin, std::size_t end)
    {
      for (auto i = static_cast<Eigen::Index>(begin); i < static_cast<Eigen::Index>(end); ++i)
      {
        result[i] = rowAt(mesh.vertices().col(i)).dot(coefficients);
      }
    });
  require(result.allFinite(), "vertices beside the offset centers of the Harmonic kernel",
    "one at a center", "Choose the Cubic Kernel.");
  return result;
}

} // namespace

Field RadialDesign::field(const std::vector<ValueConstraint>& constraints, double regularization,
  const Execution& execution) const
{
  FieldParameters parameters;
  parameters.scheme = Scheme::GlobalRBF;
  parameters.kernel = this->kernel_;
  parameters.kernelWidth = this->kernelWidth_;
  parameters.regularization = regularization;
  try
  {
    return Field::fit(
      centersOf(this->mesh_.vertices(), constraints), valuesOf(constraints), parameters, execution);
  }
  catch (const InvalidInput&) // what it advises is not to be chosen here
  {
    throw InvalidInput(std::string("a system of ") + nameOf(this->kernel_) +
        " kernels that can be solved at machine precision",
      "a singular one of " + std::to_string(constraints.size()) + " vertices",
      "Choose the Cubic Kernel, a smaller KernelWidth, or points farther apart.");
  }
}

Values RadialDesign::through(
  const std::vector<ValueConstraint>& constraints, const Execution& execution) const
{
  Values result = this->kernel_ == KernelType::Harmonic
    ? harmonicThrough(this->mesh_, constraints, execution)
    : this->evaluated(constraints, 0.0, execution);
  for (const auto& [vertex, value] : constraints)
  {
    result[vertex] = value;
  }
  return result;
}

Values RadialDesign::near(
  const std::vector<ValueConstraint>& constraints, double epsilon, const Execution& execution) const
{
  return this->evaluated(constraints, 1.0 / epsilon, execution);
}

Values RadialDesign::evaluated(const std::vector<ValueConstraint>& constraints,
  double regularization, const Execution& execution) const
{
  const Field field = this->field(constraints, regularization, execution.part(0.0, 0.5));
  return field.evaluate(this->mesh_.vertices(), {}, execution.part(0.5, 1.0)).values;
}

ParameterCurve RadialDesign::curve(
  const std::vector<ValueConstraint>& constraints, const Execution& execution) const
{
  const double width =
    this->field(constraints, LeastRidge, execution.part(0.0, 0.5)).model().parameters.kernelWidth;
  const RadialKernel kernel(this->kernel_, width);
  const Points centers = centersOf(this->mesh_.vertices(), constraints);
  const Eigen::Index count = centers.cols();
  const Eigen::MatrixXd energies = Eigen::MatrixXd::NullaryExpr(count, count,
    [&](Eigen::Index i, Eigen::Index j)
    { return kernel.sign() * kernel.value((centers.col(i) - centers.col(j)).norm()); });
  return ridgeSystem(energies, LinearTerms(centers).at(centers),
    Eigen::MatrixXd::Identity(count, count), valuesOf(constraints), execution.part(0.5, 1.0))
    .curve(1.0);
}

} // namespace SurfaceScalars
