#include "Error.h"
#include "FieldSchemes.h"
#include "NumberText.h"
#include "RadialBasisFit.h"

#include <algorithm>
#include <cmath>

namespace SurfaceScalars
{
namespace
{

// Dense systems larger than this take seconds for each place.
constexpr std::size_t MostNeighbors = 2000;

/// h where it is chosen, in radii of the neighborhood: wider is more accurate and closer to
/// singular. Measured on random samples of a surface, with room for pairs a thousandth of a
/// sampling step apart, which there are among a million; powers and thin plates depend on it only
/// through the unit of the regularization.
double widthInRadii(KernelType kernel)
{
  switch (kernel)
  {
    case KernelType::Gaussian:
      return 0.5;
    case KernelType::Exponential:
      return 2.0;
    case KernelType::Multiquadric:
      return 0.75;
    case KernelType::Wendland:
    case KernelType::Wu:
      return 5.0;
    default:
      return 1.0;
  }
}

class LocalRBF : public FieldApproximation
{
public:
  LocalRBF(const FieldSamples& samples, const FieldParameters& parameters)
    : samples_(samples)
    , parameters_(parameters)
    , search_(neighborhoodSearch(samples.cloud, parameters))
  {
  }

  Eigen::Index expect(const PointsRef& places) override { return this->search_.expect(places); }
  bool center(const Vector3d& place) override;
  FieldJet jet(const Vector3d& place, Derivatives derivatives) const override
  {
    return this->fit_.jet(place, derivatives);
  }

private:
  void fit(const std::vector<Index>& neighbors);
  [[noreturn]] void refuse(double width) const;

  FieldSamples samples_;
  FieldParameters parameters_;
  NearestSearch search_;
  std::vector<Index> found_;     // in the order of the cloud
  std::vector<Index> neighbors_; // that the fit is made of
  Points centers_;
  Values values_;
  RadialBasisFit fit_;
};

bool LocalRBF::center(const Vector3d& place)
{
  this->found_.clear();
  for (const NearestSearch::Found& found : this->search_.find(place))
  {
    this->found_.push_back(found.index);
  }
  std::sort(this->found_.begin(), this->found_.end());
  if (this->found_.empty() || this->found_ == this->neighbors_)
  {
    return !this->found_.empty(); // one fit serves all places that have the same neighbors
  }
  if (this->found_.size() > MostNeighbors)
  {
    throw InvalidInput("at most " + std::to_string(MostNeighbors) + " samples in a neighborhood",
      std::to_string(this->found_.size()), "Lower SearchRadius or NeighborCount.");
  }
  this->neighbors_.clear(); // until the new fit is there
  this->fit(this->found_);
  this->neighbors_ = this->found_;
  return true;
}

void LocalRBF::fit(const std::vector<Index>& neighbors)
{
  const auto count = static_cast<Eigen::Index>(neighbors.size());
  this->centers_.resize(3, count);
  this->values_.resize(count);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    const Index sample = neighbors[static_cast<std::size_t>(i)];
    this->centers_.col(i) = this->samples_.cloud.points().col(sample);
    this->values_[i] = this->samples_.values[sample];
  }
  const Vector3d middle = this->centers_.rowwise().mean();
  const double radius =
    std::sqrt((this->centers_.colwise() - middle).colwise().squaredNorm().maxCoeff());
  double width = this->parameters_.kernelWidth;
  if (!(width > 0.0))
  {
    width = radius > 0.0 ? widthInRadii(this->parameters_.kernel) * radius : 1.0;
  }
  if (!this->fit_.factor(this->centers_, RadialKernel(this->parameters_.kernel, width),
        this->parameters_.regularization))
  {
    this->refuse(width);
  }
  this->fit_.solve(this->values_);
}

void LocalRBF::refuse(double width) const
{
  throw InvalidInput("kernels whose system can be solved at machine precision",
    "a " + std::string(nameOf(this->parameters_.kernel)) + " kernel of width " + textOf(width) +
      " that makes the system of " + std::to_string(this->centers_.cols()) +
      " neighbors singular (reciprocal condition " + textOf(this->fit_.reciprocalCondition()) + ")",
    "Lower KernelWidth, raise Regularization to 1e-10 or so, or choose the Cubic Kernel.");
}

} // namespace

std::unique_ptr<FieldApproximation> makeLocalRBF(
  const FieldSamples& samples, const FieldParameters& parameters)
{
  return std::make_unique<LocalRBF>(samples, parameters);
}

} // namespace SurfaceScalars
