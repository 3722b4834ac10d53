#include "SmoothingMesh.h"

#include "Require.h"

#include <utility>

namespace SurfaceScalars
{

SmoothingMesh::SmoothingMesh(
  Points vertices, const Triangles& triangles, const Execution& execution, VertexName nameOf)
  : vertices_(std::move(vertices))
  , nameOf_(std::move(nameOf))
  , topology_(static_cast<Index>(this->vertices_.cols()), triangles, execution, this->nameOf_)
{
  require(this->vertices_.allFinite(), "finite vertices", "a coordinate that is not",
    "Remove such vertices.");
}

std::shared_ptr<const Laplacian> SmoothingMesh::laplacian(
  LaplacianWeights weights, const Execution& execution) const
{
  auto& known = this->laplacians_[weights];
  if (!known)
  {
    known = std::make_shared<const Laplacian>(
      meshLaplacian(this->vertices_, this->topology_.triangles(), weights, execution));
  }
  return known;
}

const TikhonovSmoother& SmoothingMesh::smoother(
  const SmoothingNorms& norms, const Execution& execution) const
{
  auto& smoother = this->smoothers_[{ norms.weights, norms.metric, norms.energy }];
  if (!smoother)
  {
    const auto laplacian = this->laplacian(norms.weights, execution);
    Eigen::SparseMatrix<double> metric =
      metricMatrix(norms.metric, *laplacian, this->vertices_, this->topology_.triangles());
    metric *= laplacian->mass.sum() / metric.sum();
    smoother = std::make_unique<const TikhonovSmoother>(laplacian, std::move(metric), norms.energy);
  }
  return *smoother;
}

} // namespace SurfaceScalars
