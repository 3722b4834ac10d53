#include "ComponentMeans.h"

#include <algorithm>
#include <cmath>

namespace SurfaceScalars
{

ComponentMeans::ComponentMeans(const Laplacian& laplacian)
  : components_(connectedComponents(laplacian.stiffness))
  , mass_(laplacian.mass)
  , masses_(Values::Zero(1 + *std::max_element(components_.begin(), components_.end())))
{
  for (std::size_t i = 0; i < this->components_.size(); ++i)
  {
    this->masses_[this->components_[i]] += this->mass_[static_cast<Eigen::Index>(i)];
  }
}

Values ComponentMeans::of(const ValuesRef& function) const
{
  Values sums = Values::Zero(this->count());
  for (std::size_t i = 0; i < this->components_.size(); ++i)
  {
    const auto vertex = static_cast<Eigen::Index>(i);
    sums[this->components_[i]] += this->mass_[vertex] * function[vertex];
  }
  return this->spread(sums.cwiseQuotient(this->masses_));
}

Values ComponentMeans::unit(Eigen::Index component) const
{
  Values result = Values::Zero(this->count());
  result[component] = 1.0 / std::sqrt(this->masses_[component]);
  return this->spread(result);
}

Values ComponentMeans::spread(const Values& ofComponents) const
{
  Values result(this->mass_.size());
  for (std::size_t i = 0; i < this->components_.size(); ++i)
  {
    result[static_cast<Eigen::Index>(i)] = ofComponents[this->components_[i]];
  }
  return result;
}

} // namespace SurfaceScalars
