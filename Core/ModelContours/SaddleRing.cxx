#include "SaddleRing.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace SurfaceScalars
{
namespace
{

constexpr int RingSize = 64;           // places, about
constexpr double ClearFraction = 1e-3; // of the largest height on a ring

} // namespace

SaddleRing::SaddleRing(
  const Vector3d& center, const Eigen::Matrix<double, 3, 2>& axes, double radius)
  : center_(center)
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
    }
  }
}

std::vector<Sector> SaddleRing::sectors(double radius, double rounding, LevelProbe& probe) const
{
  const double middle = probe(this->center_, Derivatives::None).value;
  std::vector<double> heights;
  double largest = 0.0;
  for (const PatchPlace& onLink : this->places_)
  {
    const Vector3d offset = onLink.place - this->center_;
    const double distance = std::min(0.5 * offset.norm(), radius);
    const double difference =
      probe(this->center_ + distance * offset.normalized(), Derivatives::None).value - middle;
    heights.push_back(std::abs(difference) > rounding ? difference / (distance * distance) : 0.0);
    largest = std::max(largest, std::abs(heights.back()));
  }
  std::vector<Sector> sectors;
  for (std::size_t i = 0; i < heights.size(); ++i)
  {
    const double height = std::abs(heights[i]);
    const bool isAbove = heights[i] > 0.0;
    if (height <= ClearFraction * largest)
    {
      continue;
    }
    if (sectors.empty() || sectors.back().isAbove != isAbove)
    {
      sectors.push_back({ isAbove, height, this->places_[i] });
    }
    else if (height > sectors.back().height)
    {
      sectors.back() = { isAbove, height, this->places_[i] };
    }
  }
  if (sectors.size() > 1 && sectors.front().isAbove == sectors.back().isAbove)
  {
    if (sectors.back().height > sectors.front().height)
    {
      sectors.front() = sectors.back();
    }
    sectors.pop_back();
  }
  return sectors;
}

} // namespace SurfaceScalars
