#include "DesignMesh.h"

#include "GreensFunctions.h"

#include <utility>

namespace SurfaceScalars
{

DesignMesh::DesignMesh(
  Points vertices, const Triangles& triangles, const Execution& execution, VertexName nameOf)
  : mesh_(std::move(vertices), triangles, execution, std::move(nameOf))
{
}

DesignMesh::~DesignMesh() = default;

std::shared_ptr<const Laplacian> DesignMesh::laplacian(const Execution& execution) const
{
  return this->mesh_.laplacian(LaplacianWeights::Cotangent, execution);
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
    metric, *this->laplacian(execution), this->vertices(), this->topology().triangles());
}

double DesignMesh::area(const Execution& execution) const
{
  return this->laplacian(execution)->mass.sum();
}

} // namespace SurfaceScalars
