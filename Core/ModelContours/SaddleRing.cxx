#include "SaddleRing.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace SurfaceScalars
{
namespace
{

constexpr int RingSize = 64;             // places, about
constexpr int RingCount = 4;             // at a bend
constexpr double RingRatio = 0.125;      // of the radius of one to that of the one before
constexpr std::size_t FewestSectors = 4; // around a saddle
constexpr double ClearFraction = 1e-3;   // in a plane, of the largest height on a ring
constexpr double FlatAngle = 1e-9;
constexpr double RoundingFraction = 1e-6; // of a change on a ring, up to which a slope is rounding
constexpr int MostDoublings = 60;         // from a ring to the link
constexpr double RadiusFraction = 0.02;   // of the distance to the nearest few centers
constexpr int NearCenters = 4;

/// Which of these numbers are the largest of each run of one sign, cyclic; zeros are in none.
std::vector<std::size_t> peaksOf(const std::vector<double>& heights)
{
  std::vector<std::size_t> peaks;
  const auto isAlike = [&](std::size_t a, std::size_t b)
  { return (heights[a] > 0.0) == (heights[b] > 0.0); };
  const auto larger = [&](std::size_t a, std::size_t b)
  { return std::abs(heights[a]) < std::abs(heights[b]) ? b : a; };
  for (std::size_t i = 0; i < heights.size(); ++i)
  {
    if (heights[i] == 0.0)
    {
      continue;
    }
    if (peaks.empty() || !isAlike(peaks.back(), i))
    {
      peaks.push_back(i);
    }
    peaks.back() = larger(peaks.back(), i);
  }
  if (peaks.size() > 1 && isAlike(peaks.front(), peaks.back()))
  {
    peaks.front() = larger(peaks.front(), peaks.back());
    peaks.pop_back();
  }
  return peaks;
}

double largestOf(const std::vector<double>& heights)
{
  double largest = 0.0;
  for (const double height : heights)
  {
    largest = std::max(largest, std::abs(height));
  }
  return largest;
}

} // namespace

double ringRadius(const Field& field, const Vector3d& place)
{
  Neighborhood near;
  field.cloud().nearest(place, NearCenters, near);
  return RadiusFraction * std::sqrt(near.squaredDistances.back());
}

SaddleRing::SaddleRing(
  const Vector3d& center, const Eigen::Matrix<double, 3, 2>& axes, double radius)
  : center_(center)
  , isCorner_(RingSize, false)
  , reach_(radius)
{
  for (int i = 0; i < RingSize; ++i)
  {
    const double angle = 2.0 * Pi * i / RingSize;
    const Vector3d direction = axes * Vector2d(std::cos(angle), std::sin(angle));
    this->places_.push_back({ 0, center + 2.0 * radius * direction });
  }
}

SaddleRing::SaddleRing(
  const ContourPatch& patch, Index center, const std::vector<Index>& link, const PatchStar& star)
  : center_(patch.vertices[center].place)
  , reach_(std::numeric_limits<double>::infinity())
{
  for (std::size_t i = 0; i < link.size(); ++i)
  {
    const std::array<Index, 2> side{ link[i], link[(i + 1) % link.size()] };
    const auto triangle = std::find_if(star.begin(), star.end(),
      [&](std::size_t piece)
      {
        const std::array<Index, 3>& corners = patch.pieces[piece].corners;
        return std::count(corners.begin(), corners.end(), side[0]) +
          std::count(corners.begin(), corners.end(), side[1]) ==
          2;
      });
    const Vector3d from = patch.vertices[side[0]].place - this->center_;
    const Vector3d to = patch.vertices[side[1]].place - this->center_;
    const double angle = std::atan2(from.cross(to).norm(), from.dot(to));
    const int parts = 2 + static_cast<int>(angle / (2.0 * Pi) * RingSize);
    for (int part = 0; part < parts; ++part)
    {
      const double here = angle * part / parts;
      const double before = from.norm() * std::sin(here);
      const double after = to.norm() * std::sin(angle - here);
      const double t = before / (before + after);
      this->places_.push_back(
        { patch.pieces[*triangle].triangle, this->center_ + (1.0 - t) * from + t * to });
      this->isCorner_.push_back(part == 0);
    }
    this->reach_ = std::min(this->reach_, 0.5 * from.norm());
    const Vector3d normal = patch.normal(patch.pieces[*triangle]);
    this->isPlane_ =
      this->isPlane_ && normal.cross(patch.normal(patch.pieces[star.front()])).norm() <= FlatAngle;
  }
}

Vector3d SaddleRing::directionTo(std::size_t i) const
{
  return (this->places_[i].place - this->center_).normalized();
}

double SaddleRing::distanceTo(std::size_t i, double radius) const
{
  return std::min(0.5 * (this->places_[i].place - this->center_).norm(), radius);
}

std::vector<double> SaddleRing::heights(double radius, double rounding, LevelProbe& probe) const
{
  const double middle = probe(this->center_, Derivatives::None).value;
  std::vector<double> heights;
  for (std::size_t i = 0; i < this->places_.size(); ++i)
  {
    const double distance = this->distanceTo(i, radius);
    const Vector3d place = this->center_ + distance * this->directionTo(i);
    const double difference = probe(place, Derivatives::None).value - middle;
    heights.push_back(std::abs(difference) > rounding ? difference / (distance * distance) : 0.0);
  }
  return heights;
}

SaddleView SaddleRing::view(double radius, double rounding, LevelProbe& probe) const
{
  for (int ring = 0; ring < (this->isPlane_ ? 1 : RingCount); ++ring)
  {
    const double here = radius * std::pow(RingRatio, ring);
    std::vector<double> heights = this->heights(here, rounding, probe);
    // At a bend u changes faster across than along, however clear that is.
    const double least = this->isPlane_ ? ClearFraction * largestOf(heights) : 0.0;
    std::replace_if(
      heights.begin(), heights.end(), [&](double h) { return std::abs(h) <= least; }, 0.0);
    const std::vector<std::size_t> peaks = peaksOf(heights);
    if (peaks.empty())
    {
      break; // u is constant
    }
    if (peaks.size() < FewestSectors)
    {
      continue;
    }
    SaddleView view;
    view.height = std::numeric_limits<double>::infinity();
    for (const std::size_t peak : peaks)
    {
      view.height = std::min(view.height, std::abs(heights[peak]));
    }
    for (std::size_t i = 0; i < heights.size(); ++i)
    {
      if (heights[i] != 0.0 &&
        ((this->isCorner_[i] && !this->isPlane_) ||
          std::find(peaks.begin(), peaks.end(), i) != peaks.end()))
      {
        view.marks.push_back(
          this->isPlane_ ? this->places_[i] : this->mark(i, heights[i] > 0.0, here, probe));
      }
    }
    return view;
  }
  return {};
}

bool SaddleRing::isRegular(double radius, double rounding, LevelProbe& probe) const
{
  const Vector3d gradient = probe(this->center_, Derivatives::Gradient).gradient;
  std::vector<double> slopes;
  for (std::size_t i = 0; i < this->places_.size(); ++i)
  {
    slopes.push_back(gradient.dot(this->directionTo(i)));
  }
  if (peaksOf(slopes).size() != 2)
  {
    return false;
  }
  const double here = std::min(radius, this->reach_);
  return largestOf(slopes) >
    RoundingFraction * here * largestOf(this->heights(here, rounding, probe));
}

PatchPlace SaddleRing::mark(std::size_t i, bool isAbove, double radius, LevelProbe& probe) const
{
  const double middle = probe(this->center_, Derivatives::None).value;
  const double end = (this->places_[i].place - this->center_).norm();
  double distance = this->distanceTo(i, radius);
  for (int doubling = 0; doubling < MostDoublings && distance < end; ++doubling)
  {
    const double next = 2.0 * distance < end ? 2.0 * distance : end;
    const double value =
      probe(this->center_ + next * this->directionTo(i), Derivatives::None).value;
    if ((value > middle) != isAbove)
    {
      return { this->places_[i].triangle, this->center_ + distance * this->directionTo(i) };
    }
    distance = next;
  }
  return this->places_[i];
}

} // namespace SurfaceScalars
