#pragma once

#include "Laplacian.h"

#include <vector>

namespace SurfaceScalars
{

/// The functions that are constant on each connected component: those that a Laplacian takes to 0.
class ComponentMeans
{
public:
  explicit ComponentMeans(const Laplacian& laplacian);

  Eigen::Index count() const { return this->masses_.size(); } ///< of components

  /// At each vertex the mean over its component, weighted by the mass: the projection onto these
  /// functions.
  Values of(const ValuesRef& function) const;

  /// 1 on a component, 0 elsewhere, divided such that its norm in the mass is 1.
  Values unit(Eigen::Index component) const;

private:
  /// At each vertex the value of its component.
  Values spread(const Values& ofComponents) const;

  std::vector<int> components_;
  Values mass_;
  Values masses_; ///< of the components
};

} // namespace SurfaceScalars
