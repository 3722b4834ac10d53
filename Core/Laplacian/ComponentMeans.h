#pragma once

#include "Laplacian.h"

#include <vector>

namespace SurfaceScalars
{

/// The functions that are constant on each connected component: those that a Laplacian takes to 0.
class ComponentMeans
{
public:
  explicit ComponentMeans(const Laplacian& laplacian); ///< weighted by the mass
  ComponentMeans(const Laplacian& laplacian, Values weights);

  Eigen::Index count() const { return this->totals_.size(); } ///< of components

  /// At each vertex the weighted mean over its component: the projection onto these
  /// functions, exact for them.
  Values of(const ValuesRef& function) const;

  /// 1 on a component, 0 elsewhere, divided such that its weighted norm is 1.
  Values unit(Eigen::Index component) const;

private:
  /// At each vertex the value of its component.
  Values spread(const Values& ofComponents) const;

  std::vector<int> components_; ///< numbered in the order of their first vertices
  std::vector<Eigen::Index> firsts_;
  Values weights_;
  Values totals_; ///< of the components
};

} // namespace SurfaceScalars
