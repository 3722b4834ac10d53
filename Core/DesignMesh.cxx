#include "DesignMesh.h"

#include "GreensFunctions.h"
#include "Require.h"

#include <utility>

namespace SurfaceScalars
{

DesignMesh::DesignMesh(
  Points vertices, const Triangles& triangles, const Execution& execution, VertexName nameOf)
  : vertices_(std::move(vertices))
  , nameOf_(std::move(nameOf))
  , topology_(static_cast<Index>(this->vertices_.cols()), triangles, execution, this->nameOf_)
{
  require(this->vertices_.allFinite(), "finite vertices", "a coordinate that is not",
    "Remove such vertices.");
}

DesignMesh::~DesignMesh() = default;

std::shared_ptr<const Laplacian> DesignMesh::laplacian(const Execution& execution) const
{
  if (!this->laplacian_)
  {
    this->laplacian_ = std::make_shared<const Laplacian>(meshLaplacian(
      this->vertices_, this->topology_.triangles(), LaplacianWeights::Cotangent, execution));
  }
  return this->laplacian_;
}

GreensFunctions& DesignMesh::greensFunctions(
  SmoothingEnergy energy, DataMetric metric, const Execution& execution) const
{
  const auto laplacian = this->laplacian(execution.part(0.0, 0.1));
  if (!this->poisson_)
  {
    this->poisson_ = std::make_shared<const PoissonSolver>(laplacian, execution.part(0.1, 1.0));
  }
  const bool isConsistent =
    energy == SmoothingEnergy::Biharmonic && metric == DataMetric::MassMatrix;
  auto& functions = this->functions_[isConsistent ? 2 : static_cast<std::size_t>(energy)];
  if (!functions)
  {
    functions = std::make_unique<GreensFunctions>(this->poisson_, energy,
      this->metric(isConsistent ? DataMetric::MassMatrix : DataMetric::LumpedMass, execution));
  }
  return *functions;
}

Eigen::SparseMatrix<double> DesignMesh::metric(DataMetric metric, const Execution& execution) const
{
  return metricMatrix(
    metric, *this->laplacian(execution), this->vertices_, this->topology_.triangles());
}

double DesignMesh::area(const Execution& execution) const
{
  return this->laplacian(execution)->mass.sum();
}

} // namespace SurfaceScalars
