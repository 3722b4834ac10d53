#include "ComponentMeans.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace SurfaceScalars
{

ComponentMeans::ComponentMeans(const Laplacian& laplacian)
  : ComponentMeans(laplacian, laplacian.mass)
{
}

ComponentMeans::ComponentMeans(const Laplacian& laplacian, Values weights)
  : components_(connectedComponents(laplacian.stiffness))
  , weights_(std::move(weights))
  , totals_(Values::Zero(1 + *std::max_element(components_.begin(), components_.end())))
{
  for (std::size_t i = 0; i < this->components_.size(); ++i)
  {
    const auto vertex = static_cast<Eigen::Index>(i);
    this->totals_[this->components_[i]] += this->weights_[vertex];
    if (this->components_[i] == static_cast<int>(this->firsts_.size()))
    {
      this->firsts_.push_back(vertex);
    }
  }
}

Values ComponentMeans::of(const ValuesRef& function) const
{
  const Values firsts = function(this->firsts_); // about which sums of constants are exact
  Values sums = Values::Zero(this->count());
  for (std::size_t i = 0; i < this->components_.size(); ++i)
  {
    const auto vertex = static_cast<Eigen::Index>(i);
    sums[this->components_[i]] +=
      this->weights_[vertex] * (function[vertex] - firsts[this->components_[i]]);
  }
  return this->spread(firsts + sums.cwiseQuotient(this->totals_));
}

Values ComponentMeans::unit(Eigen::Index component) const
{
  Values result = Values::Zero(this->count());
  result[component] = 1.0 / std::sqrt(this->totals_[component]);
  return this->spread(result);
}

Values ComponentMeans::spread(const Values& ofComponents) const
{
  Values result(this->weights_.size());
  for (std::size_t i = 0; i < this->components_.size(); ++i)
  {
    result[static_cast<Eigen::Index>(i)] = ofComponents[this->components_[i]];
  }
  return result;
}

} // namespace SurfaceScalars
