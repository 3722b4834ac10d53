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
  auto& smoother = this->smoothers_[keyOf(norms)];
  if (!smoother)
  {
    const auto laplacian = this->laplacian(norms.weights, execution);
    Eigen::SparseMatrix<double> metric =
      metricMatrix(norms.metric, *laplacian, this->vertices_, this->topology_.triangles());
    metric *= laplacian->mass.sum() / metric.sum();
    smoother = std::make_unique<const TikhonovSmoother>(laplacian, metric, norms.energy);
  }
  return *smoother;
}

const ParameterCurve& SmoothingMesh::curve(const SmoothingNorms& norms, const ValuesRef& values,
  EpsilonChoice choice, const Execution& execution) const
{
  const SmootherKey key = keyOf(norms);
  if (!this->curve_ || this->curve_->norms != key || this->curve_->choice != choice ||
    this->curve_->values.size() != values.size() || this->curve_->values != values)
  {
    ParameterCurve curve = parameterCurve(
      this->smoother(norms, execution), values, execution, choice, &this->shares_[key]);
    this->curve_ = KnownCurve{ key, values, choice, std::move(curve) };
  }
  return this->curve_->curve;
}

} // namespace SurfaceScalars
