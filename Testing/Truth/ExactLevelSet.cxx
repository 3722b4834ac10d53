#include "ExactLevelSet.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace SurfaceScalars::Truth
{
namespace
{

/// Crossed grid edges, joined through the cells into curves; two links per crossing inside, one on
/// the boundary.
class Crossings
{
public:
  explicit Crossings(std::size_t edges)
    : number_(edges, -1)
  {
  }

  /// @returns whether the edge is met for the first time
  bool add(std::size_t edge)
  {
    if (this->number_[edge] >= 0)
    {
      return false;
    }
    this->number_[edge] = static_cast<int>(this->parent_.size());
    this->parent_.push_back(this->number_[edge]);
    this->links_.push_back(0);
    return true;
  }

  void link(std::size_t edge, std::size_t other)
  {
    const int a = this->number_[edge];
    const int b = this->number_[other];
    ++this->links_[a];
    ++this->links_[b];
    this->parent_[this->root(a)] = this->root(b);
  }

  void count(ExactLevelSet& result)
  {
    std::vector<int> ends(this->parent_.size(), 0);
    for (int i = 0; i < static_cast<int>(this->parent_.size()); ++i)
    {
      ends[this->root(i)] += 2 - this->links_[i];
    }
    for (int i = 0; i < static_cast<int>(this->parent_.size()); ++i)
    {
      if (this->root(i) == i)
      {
        ++(ends[i] == 0 ? result.closedCount : result.openCount);
      }
    }
  }

private:
  int root(int i)
  {
    while (this->parent_[i] != i)
    {
      i = this->parent_[i] = this->parent_[this->parent_[i]];
    }
    return i;
  }

  std::vector<int> number_;
  std::vector<int> parent_;
  std::vector<int> links_;
};

} // namespace

LevelSetFamily::LevelSetFamily(SpaceFunction function, Torus torus, int axialCells)
  : function_(std::move(function))
  , torus_(torus)
  , axialCells_(axialCells)
  , tubeCells_(axialCells / 2)
{
  const int rows = torus == Torus::Closed ? axialCells : axialCells + 1;
  this->values_.reserve(static_cast<std::size_t>(rows) * this->tubeCells_);
  for (int i = 0; i < rows; ++i)
  {
    for (int j = 0; j < this->tubeCells_; ++j)
    {
      this->values_.push_back(this->function_.value(torusPoint(this->angles(i, j))));
    }
  }
}

Vector2d LevelSetFamily::angles(double i, double j) const
{
  const AngleRange axial = axialAngles(this->torus_);
  return { axial.begin + (axial.end - axial.begin) * i / this->axialCells_,
    2.0 * Pi * j / this->tubeCells_ };
}

std::size_t LevelSetFamily::node(int i, int j) const
{
  const int row = this->torus_ == Torus::Closed ? i % this->axialCells_ : i;
  return static_cast<std::size_t>(row) * this->tubeCells_ + j % this->tubeCells_;
}

bool LevelSetFamily::isAbove(int i, int j, double isoValue) const
{
  return this->values_[this->node(i, j)] >= isoValue;
}

Vector3d LevelSetFamily::crossing(const Vector2d& from, const Vector2d& to, double isoValue) const
{
  Vector2d low = from;
  Vector2d high = to;
  const bool lowIsAbove = this->function_.value(torusPoint(from)) >= isoValue;
  for (int halving = 0; halving < 48; ++halving)
  {
    const Vector2d middle = 0.5 * (low + high);
    const bool middleIsAbove = this->function_.value(torusPoint(middle)) >= isoValue;
    (middleIsAbove == lowIsAbove ? low : high) = middle;
  }
  return torusPoint(low);
}

ExactLevelSet LevelSetFamily::at(double isoValue) const
{
  ExactLevelSet result;
  result.isoValue = isoValue;
  Crossings crossings(2 * this->values_.size());

  for (int i = 0; i < this->axialCells_; ++i)
  {
    for (int j = 0; j < this->tubeCells_; ++j)
    {
      // Corners around the cell; side s joins corner s to the next. Sides along u have even
      // numbers, along v odd ones.
      const std::array<std::array<int, 2>, 4> corner{ { { i, j }, { i + 1, j }, { i + 1, j + 1 },
        { i, j + 1 } } };
      const std::array<std::size_t, 4> side{ 2 * this->node(i, j), 2 * this->node(i + 1, j) + 1,
        2 * this->node(i, j + 1), 2 * this->node(i, j) + 1 };

      std::array<bool, 4> above{};
      for (int c = 0; c < 4; ++c)
      {
        above[c] = this->isAbove(corner[c][0], corner[c][1], isoValue);
      }
      std::vector<int> crossed;
      for (int s = 0; s < 4; ++s)
      {
        const int next = (s + 1) % 4;
        if (above[s] == above[next])
        {
          continue;
        }
        crossed.push_back(s);
        if (crossings.add(side[s]))
        {
          result.points.push_back(this->crossing(this->angles(corner[s][0], corner[s][1]),
            this->angles(corner[next][0], corner[next][1]), isoValue));
        }
      }
      if (crossed.size() == 2)
      {
        crossings.link(side[crossed[0]], side[crossed[1]]);
      }
      else if (crossed.size() == 4)
      {
        const bool centerIsAbove =
          this->function_.value(torusPoint(this->angles(i + 0.5, j + 0.5))) >= isoValue;
        // Corner 0 belongs to the center: the curves cut off corners 1 and 3, otherwise 0 and 2.
        const int first = centerIsAbove == above[0] ? 0 : 3;
        crossings.link(side[first], side[(first + 1) % 4]);
        crossings.link(side[(first + 2) % 4], side[(first + 3) % 4]);
      }
    }
  }
  crossings.count(result);
  return result;
}

bool projectOntoLevelSet(const SpaceFunction& function, double isoValue, Vector3d& place)
{
  const Vector3d wanted = place;
  for (int i = 0; i < 100; ++i)
  {
    const Vector3d normal = torusNormal(torusAngles(place));
    const Vector3d gradient = function.gradient(place);
    Eigen::Matrix<double, 2, 3> jacobian;
    jacobian << gradient.transpose(), normal.transpose();
    const Vector2d defect(function.value(place) - isoValue, torusDistance(place));
    const Vector3d toCurve =
      -jacobian.transpose() * ((jacobian * jacobian.transpose()).inverse() * defect);

    // Along the curve towards the foot of the perpendicular: the plane through `wanted` normal to
    // the tangent.
    const Vector3d tangent = gradient.cross(normal).normalized();
    Vector3d step = toCurve + tangent.dot(wanted - place) * tangent;
    const double length = step.norm();
    if (!(length < 1e3))
    {
      return false;
    }
    place += length > 0.1 ? Vector3d(step * (0.1 / length)) : step;
    if (length < 1e-12)
    {
      return true;
    }
  }
  return false;
}

} // namespace SurfaceScalars::Truth
