#include "ImplicitSurface.h"

#include "Error.h"
#include "RadialBasisFit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace SurfaceScalars
{
namespace
{

// Fractions of the neighborhood's radius.
constexpr double OffsetFraction = 1.0 / 3.0;
constexpr double SmallestOffset = 0.02; // less says nothing about the normal
constexpr double SmallestGap = 1e-3;    // between centers: closer ones make the system singular

constexpr std::size_t MostSamples = 192; // in one fit: more bring time, little precision
constexpr std::size_t MostCenters = 12;  // of a least-squares fit: fewer than samples smooth

/// Every n-th of the indices, so that at most `most` are left. Indices are along a Morton curve:
/// sorted, they are spread evenly.
std::vector<Index> thinned(std::vector<Index> indices, std::size_t most)
{
  if (indices.size() <= most)
  {
    return indices;
  }
  std::sort(indices.begin(), indices.end());
  for (std::size_t i = 0; i < most; ++i)
  {
    indices[i] = indices[i * indices.size() / most];
  }
  indices.resize(most);
  return indices;
}

class RadialSurface : public FieldApproximation
{
public:
  RadialSurface(
    const OrientedSamples& samples, const FitSize& size, const RadialSurfaceParameters& parameters)
    : samples_(samples)
    , size_(size)
    , parameters_(parameters)
  {
  }

  bool center(const Vector3d& place) override;
  FieldJet jet(const Vector3d& place, Derivatives derivatives) const override
  {
    return this->fit_.jet(place, derivatives);
  }

private:
  void gather(const Vector3d& place);
  double largestOffset(Index point, double side) const;
  void collectConditions();
  void addCondition(const Vector3d& place, double value);
  bool isInTheWay(Index other, Index point) const;
  RadialKernel kernel() const;
  bool interpolate();
  bool approximate(const Vector3d& place);

  OrientedSamples samples_;
  FitSize size_;
  RadialSurfaceParameters parameters_;
  Neighborhood around_;
  std::vector<Index> others_; ///< the neighborhood and what is close to it
  Points otherPlaces_;
  std::vector<Index> fitted_; ///< the neighborhood
  double radius_ = 0.0;       ///< of the neighborhood
  Points places_;             ///< where g is known, the first count_ columns
  Values values_;
  Eigen::Index count_ = 0;
  RadialBasisFit fit_;
};

void RadialSurface::gather(const Vector3d& place)
{
  // Three times as many samples reach farther than two offsets beyond the neighborhood.
  const auto wanted = static_cast<std::size_t>(this->size_.count);
  this->samples_.cloud.nearest(place, 3 * this->size_.count, this->around_);
  const auto& squared = this->around_.squaredDistances;
  std::size_t used = std::min(wanted, squared.size());
  this->radius_ = std::sqrt(squared[used - 1]);
  if (this->size_.radius > this->radius_)
  {
    this->radius_ = this->size_.radius;
    this->samples_.cloud.within(place, (1.0 + 2.0 * OffsetFraction) * this->radius_, this->around_);
    used = static_cast<std::size_t>(
      std::upper_bound(squared.begin(), squared.end(), this->radius_ * this->radius_) -
      squared.begin());
  }
  this->others_ = thinned(this->around_.indices, MostSamples);
  this->otherPlaces_ = this->samples_.cloud.points()(Eigen::all, this->others_);
  this->fitted_ = thinned({ this->around_.indices.begin(),
                            this->around_.indices.begin() + static_cast<std::ptrdiff_t>(used) },
    MostSamples);
}

/// Whether a sample limits the offsets of a point. Where there is noise, those of the same sheet do
/// not.
bool RadialSurface::isInTheWay(Index other, Index point) const
{
  return this->parameters_.fit == RadialSurfaceFit::Interpolate ||
    this->samples_.normals.col(other).dot(this->samples_.normals.col(point)) < 0.0;
}

/// The radius of the largest ball that touches the surface at a point from one side and holds no
/// other sample, at most the usual offset: its center is not closer to another part of the surface.
double RadialSurface::largestOffset(Index point, double side) const
{
  const Vector3d place = this->samples_.cloud.points().col(point);
  const Vector3d normal = side * this->samples_.normals.col(point);
  double result = OffsetFraction * this->radius_;
  for (Eigen::Index i = 0; i < this->otherPlaces_.cols(); ++i)
  {
    const Vector3d offset = this->otherPlaces_.col(i) - place;
    const double squared = offset.squaredNorm();
    if (squared < 4.0 * result * result &&
      this->isInTheWay(this->others_[static_cast<std::size_t>(i)], point))
    {
      const double height = 2.0 * normal.dot(offset);
      result = height * result > squared ? squared / height : result;
    }
  }
  return result;
}

void RadialSurface::addCondition(const Vector3d& place, double value)
{
  const double gap = SmallestGap * this->radius_;
  if (this->count_ > 0 && this->parameters_.fit == RadialSurfaceFit::Interpolate &&
    (this->places_.leftCols(this->count_).colwise() - place).colwise().squaredNorm().minCoeff() <
      gap * gap)
  {
    return;
  }
  this->places_.col(this->count_) = place;
  this->values_[this->count_++] = value;
}

void RadialSurface::collectConditions()
{
  const auto most = static_cast<Eigen::Index>(3 * this->fitted_.size());
  this->places_.resize(3, most);
  this->values_.resize(most);
  this->count_ = 0;
  for (const Index point : this->fitted_)
  {
    this->addCondition(this->samples_.cloud.points().col(point), 0.0);
  }
  for (const Index point : this->fitted_)
  {
    for (const double side : { 1.0, -1.0 })
    {
      const double offset = this->largestOffset(point, side);
      if (offset > SmallestOffset * this->radius_ && !this->samples_.normals.col(point).isZero())
      {
        this->addCondition(this->samples_.cloud.points().col(point) +
            side * offset * this->samples_.normals.col(point),
          side * offset);
      }
    }
  }
  this->places_.conservativeResize(3, this->count_);
  this->values_.conservativeResize(this->count_);
}

RadialKernel RadialSurface::kernel() const
{
  const double width = this->parameters_.kernelWidth;
  return { this->parameters_.kernel, width > 0.0 ? width : this->radius_ };
}

bool RadialSurface::interpolate()
{
  const RadialKernel kernel = this->kernel();
  if (this->fit_.factor(this->places_, kernel, 0.0))
  {
    this->fit_.solve(this->values_);
    return true;
  }
  if (!kernel.dependsOnWidth())
  {
    return false;
  }
  std::ostringstream found;
  found << "a width of " << kernel.width()
        << " that makes it singular (1 / condition = " << this->fit_.reciprocalCondition() << ")";
  throw InvalidInput("a system of the radial surface that can be solved", found.str(),
    "Lower KernelWidth or choose the kernel Cubic, which has none.");
}

bool RadialSurface::approximate(const Vector3d& place)
{
  const std::vector<Index> chosen = thinned(this->fitted_, MostCenters);
  Points centers(3, static_cast<Eigen::Index>(chosen.size()));
  for (std::size_t i = 0; i < chosen.size(); ++i)
  {
    centers.col(static_cast<Eigen::Index>(i)) = this->samples_.cloud.points().col(chosen[i]);
  }
  // Samples join and leave without weight, so that g does not jump as the neighborhood changes.
  const double reach = (1.0 + OffsetFraction) * this->radius_;
  const Values weights = (1.0 -
    (this->places_.colwise() - place).colwise().squaredNorm().transpose().array() / (reach * reach))
                           .max(0.0);
  return this->fit_.approximate(centers, this->kernel(), this->places_, this->values_, weights);
}

bool RadialSurface::center(const Vector3d& place)
{
  this->gather(place);
  if (!(this->radius_ > 0.0))
  {
    return false;
  }
  this->collectConditions();
  const bool isFlat = this->values_.isZero(0.0); // no normals: nothing says where g is not 0
  return !isFlat &&
    (this->parameters_.fit == RadialSurfaceFit::Interpolate ? this->interpolate()
                                                            : this->approximate(place));
}

} // namespace

std::unique_ptr<FieldApproximation> makeRadialSurface(
  const OrientedSamples& samples, const FitSize& size, const RadialSurfaceParameters& parameters)
{
  return std::make_unique<RadialSurface>(samples, size, parameters);
}

} // namespace SurfaceScalars
