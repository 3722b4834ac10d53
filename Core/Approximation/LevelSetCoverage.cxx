#include "LevelSetCoverage.h"

#include "MeshValues.h"
#include "NumberText.h"
#include "Require.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

namespace SurfaceScalars
{
namespace
{

constexpr int MostSteps = 30;       // of the dichotomy, in search of the last that matters
constexpr int MostUsefulSteps = 20; // a million iso-values
constexpr std::size_t Grain = 4096; // simplices in a block of a parallel loop

/// How often the range can be halved until rounding makes two of the values between equal.
int distinctSteps(double largest, double range)
{
  const double spacing = 4.0 * std::numeric_limits<double>::epsilon() * largest;
  return range > spacing ? std::clamp(std::ilogb(range / spacing), 1, MostSteps) : 1;
}

/// f's range and the values that divide it in 2^30 equal parts, or as many as numbers can tell
/// apart, among which are those of all coarser divisions.
class Division
{
public:
  explicit Division(const ValuesRef& values)
    : lowest_(values.minCoeff())
    , range_(values.maxCoeff() - lowest_)
    , steps_(distinctSteps(values.lpNorm<Eigen::Infinity>(), range_))
    , parts_(Index(1) << steps_)
  {
  }

  double range() const { return this->range_; }
  int steps() const { return this->steps_; }
  double value(Index i) const { return this->lowest_ + this->range_ * (i / double(this->parts_)); }

  /// The first k for which one of the 2^k - 1 values is in the interval; above 30 if there is none.
  int firstStep(double lower, double upper) const
  {
    Index first = std::max(Index(1), static_cast<Index>(this->place(lower)));
    Index last = std::min(this->parts_ - 1, static_cast<Index>(std::ceil(this->place(upper))));
    for (int i = 0; i < 2; ++i) // the second for rounding
    {
      first += this->value(first) < lower ? 1 : 0;
      last -= this->value(last) > upper ? 1 : 0;
    }
    // Of the numbers from first to last, the one that the highest power of 2 divides ends in as
    // many zeros as first - 1 and last have bits from the highest in which they differ.
    return first <= last ? this->steps_ - std::ilogb(double((first - 1) ^ last)) : MostSteps + 1;
  }

private:
  double place(double value) const { return (value - this->lowest_) / this->range_ * this->parts_; }

  double lowest_;
  double range_;
  int steps_;
  Index parts_;
};

/// Area of a triangle, volume of a tetrahedron.
template <class Corners>
double measureOf(const PointsRef& vertices, const Corners& corners)
{
  const Vector3d origin = vertices.col(corners[0]);
  const Vector3d normal =
    (vertices.col(corners[1]) - origin).cross(vertices.col(corners[2]) - origin);
  return corners.size() == 3 ? normal.norm() / 2.0
                             : std::abs(normal.dot(vertices.col(corners[3]) - origin)) / 6.0;
}

/// By which step simplices are met for the first time, and their shares of the whole.
struct FirstMeetings
{
  std::vector<signed char> steps;
  Values shares;
};

FirstMeetings firstMeetings(const PointsRef& vertices, const SimplicesRef& simplices,
  const ValuesRef& values, const Execution& execution)
{
  const Division division(values);
  const auto count = static_cast<std::size_t>(simplices.cols());
  FirstMeetings result{ std::vector<signed char>(count), Values(simplices.cols()) };
  parallelFor(count, Grain, execution,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        const auto corners = simplices.col(static_cast<Eigen::Index>(i));
        double lower = values[corners[0]];
        double upper = lower;
        for (const Index corner : corners.tail(corners.size() - 1))
        {
          lower = std::min(lower, values[corner]);
          upper = std::max(upper, values[corner]);
        }
        result.steps[i] = static_cast<signed char>(division.firstStep(lower, upper));
        result.shares[static_cast<Eigen::Index>(i)] = measureOf(vertices, corners);
      }
    });
  const double whole = result.shares.sum();
  require(whole > 0.0 && std::isfinite(whole), "a mesh with an area or volume",
    std::to_string(count) + " triangles or tetrahedra of " + textOf(whole) + " in all",
    "Choose another mesh or another unit of length.");
  result.shares /= whole;
  return result;
}

void checkInput(const PointsRef& vertices, const SimplicesRef& simplices, const ValuesRef& values,
  double tolerance)
{
  require(tolerance > 0.0 && tolerance < 1.0, "a CoverageTolerance above 0 and below 1",
    textOf(tolerance),
    "It is a share of the area: 1e-4 ends the dichotomy once a step changes the coverage by less.");
  require(simplices.cols() > 0 && (simplices.rows() == 3 || simplices.rows() == 4),
    "triangles or tetrahedra",
    std::to_string(simplices.cols()) + " simplices of " + std::to_string(simplices.rows()) +
      " corners",
    "Choose a mesh.");
  checkVertexValues(static_cast<Index>(vertices.cols()), values);
  checkValueRange(values);
  require(simplices.maxCoeff() < values.size(), "corners that are vertices",
    "a corner " + std::to_string(simplices.maxCoeff()) + " of " + std::to_string(values.size()),
    "Check what made this mesh.");
  require(
    vertices.allFinite(), "finite vertices", "others", "Leave them out, with what is around them.");
}

/// The share that each step adds.
std::vector<double> additions(const FirstMeetings& meetings)
{
  std::vector<double> added(MostSteps + 2, 0.0);
  for (std::size_t i = 0; i < meetings.steps.size(); ++i)
  {
    added[static_cast<std::size_t>(meetings.steps[i])] +=
      meetings.shares[static_cast<Eigen::Index>(i)];
  }
  return added;
}

/// The last step that matters: it adds as much as the tolerance of what steps can add, or, where
/// none does, more than any other.
int lastStep(const std::vector<double>& added, double tolerance)
{
  const auto first = added.begin() + 1;
  const auto beyond = first + MostSteps; // what is met later or by nothing
  const double least =
    std::min(tolerance * std::accumulate(first, beyond, 0.0), *std::max_element(first, beyond));
  int last = MostSteps;
  while (last > 1 && (added[static_cast<std::size_t>(last)] < least || least == 0.0))
  {
    --last;
  }
  return last;
}

} // namespace

LevelSetCoverage levelSetCoverage(const PointsRef& vertices, const SimplicesRef& simplices,
  const ValuesRef& values, double tolerance, const Execution& execution)
{
  checkInput(vertices, simplices, values, tolerance);
  LevelSetCoverage result;
  result.covered.assign(static_cast<std::size_t>(simplices.cols()), 0);
  if (Division(values).range() == 0.0)
  {
    return result;
  }
  const FirstMeetings meetings = firstMeetings(vertices, simplices, values, execution);
  const std::vector<double> added = additions(meetings);
  const int stationary = lastStep(added, tolerance);
  const int last = std::min(stationary, MostUsefulSteps);
  result.isStationary = stationary == last;
  // From the last one, so that what is met by all is 1 without rounding.
  double left = std::accumulate(added.begin() + last + 1, added.end(), 0.0);
  result.coverages.resize(static_cast<std::size_t>(last));
  for (int step = last; step >= 1; --step)
  {
    result.coverages[static_cast<std::size_t>(step - 1)] = std::max(0.0, 1.0 - left);
    left += added[static_cast<std::size_t>(step)];
  }
  result.isoValues = dyadicIsoValues(values, last);
  std::transform(meetings.steps.begin(), meetings.steps.end(), result.covered.begin(),
    [last](signed char step) { return step <= last ? 1 : 0; });
  return result;
}

Values dyadicIsoValues(const ValuesRef& values, int k)
{
  const Division division(values);
  require(k >= 1 && k <= division.steps(), "1 to " + std::to_string(division.steps()) + " halvings",
    std::to_string(k), "Choose fewer.");
  const Index parts = Index(1) << (division.steps() - k);
  return Values::NullaryExpr((Index(1) << k) - 1,
    [&](Eigen::Index i) { return division.value(static_cast<Index>(i + 1) * parts); });
}

} // namespace SurfaceScalars
