#include "PlateauLevel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace SurfaceScalars
{
namespace
{

// Of the level and of the largest term: what is between is a level of its own.
constexpr double RoundingFraction = 16.0 * std::numeric_limits<double>::epsilon();

/// The centers whose coefficients have a sign.
Points centersOf(const Field& terms, double sign)
{
  const Points& centers = terms.cloud().points();
  Points result(3, centers.cols());
  Eigen::Index count = 0;
  for (Eigen::Index i = 0; i < centers.cols(); ++i)
  {
    if (sign * terms.model().coefficients[i] > 0.0)
    {
      result.col(count++) = centers.col(i);
    }
  }
  return result.leftCols(count);
}

} // namespace

class RimApproximation : public FieldApproximation
{
public:
  explicit RimApproximation(const PlateauLevel& plateau)
    : plateau_(plateau)
    , terms_(plateau.terms_.approximation())
  {
  }

  bool center(const Vector3d& place) override { return this->terms_->center(place); }
  FieldJet jet(const Vector3d& place, Derivatives derivatives) const override;

private:
  const PlateauLevel& plateau_;
  std::unique_ptr<FieldApproximation> terms_;
  mutable Neighborhood nearest_;
};

FieldJet RimApproximation::jet(const Vector3d& place, Derivatives derivatives) const
{
  if (!this->plateau_.isFree(this->plateau_.positiveTree_, { place, 0.0 }, 0))
  {
    return this->terms_->jet(place, derivatives);
  }
  const double scale = this->plateau_.scale_;
  this->plateau_.negativeTree_.nearest(place, 1, this->nearest_);
  const Vector3d offset = place - this->plateau_.negative_.col(this->nearest_.indices.front());
  const double distance = offset.norm();
  FieldJet result{ scale * (distance - this->plateau_.kernel_.support()), Vector3d::Zero(),
    Eigen::Matrix3d::Zero() };
  if (distance > 0.0)
  {
    const Vector3d direction = offset / distance;
    result.gradient = scale * direction;
    result.hessian =
      scale / distance * (Eigen::Matrix3d::Identity() - direction * direction.transpose());
  }
  return result;
}

PlateauLevel::PlateauLevel(Field terms)
  : terms_(std::move(terms))
  , kernel_(terms_.model().parameters.kernel, terms_.model().parameters.kernelWidth)
  , scale_(terms_.model().coefficients.lpNorm<Eigen::Infinity>() / kernel_.support())
  , positive_(centersOf(terms_, 1.0))
  , negative_(centersOf(terms_, -1.0))
  , positiveTree_(positive_)
  , negativeTree_(negative_)
{
}

std::unique_ptr<PlateauLevel> PlateauLevel::find(
  const Field& field, const Points& vertices, double level)
{
  FieldModel model = field.model();
  if (model.parameters.scheme != Scheme::GlobalRBF ||
    !std::isfinite(RadialKernel(model.parameters.kernel, 1.0).support()))
  {
    return {};
  }
  const Vector3d shift = field.cloud().origin() - model.tailOrigin;
  const auto polynomial =
    (model.tail.tail<3>().transpose() * (vertices.colwise() + shift)).array() + model.tail[0];
  const double largestTerm = model.coefficients.lpNorm<Eigen::Infinity>() *
    RadialKernel(model.parameters.kernel, model.parameters.kernelWidth).value(0.0);
  const double rounding = RoundingFraction * std::max(std::abs(level), largestTerm);
  if (!((polynomial - level).abs().maxCoeff() <= rounding))
  {
    return {};
  }
  model.tail.setZero();
  return std::unique_ptr<PlateauLevel>(new PlateauLevel(Field(std::move(model))));
}

std::unique_ptr<FieldApproximation> PlateauLevel::approximation() const
{
  return std::make_unique<RimApproximation>(*this);
}

/// Whether the supports of at most so many of the centers reach into a ball.
bool PlateauLevel::isFree(const PointTree& centers, const Ball& ball, std::size_t most) const
{
  std::vector<Index> found;
  return centers.gather(ball.center, ball.radius + this->kernel_.support(), most, found);
}

bool PlateauLevel::isClear(const Ball& ball) const
{
  Neighborhood near;
  this->terms_.cloud().within(ball.center, ball.radius + this->kernel_.support(), near);
  double lowest = 0.0;
  double highest = 0.0;
  for (std::size_t i = 0; i < near.indices.size(); ++i)
  {
    const double distance = std::sqrt(near.squaredDistances[i]);
    const double alpha = this->terms_.model().coefficients[near.indices[i]];
    const double most = alpha * this->kernel_.value(std::max(0.0, distance - ball.radius));
    const double least = alpha * this->kernel_.value(distance + ball.radius);
    lowest += std::min(least, most);
    highest += std::max(least, most);
  }
  return lowest >= 0.0 || highest < 0.0;
}

bool PlateauLevel::isSum(const Ball& ball) const
{
  return ball.radius < this->kernel_.support() &&
    !this->isFree(this->positiveTree_, { ball.center, -ball.radius }, 0);
}

bool PlateauLevel::isRim(const Ball& ball) const
{
  return this->isFree(this->positiveTree_, ball, 0) && this->isFree(this->negativeTree_, ball, 1);
}

} // namespace SurfaceScalars
