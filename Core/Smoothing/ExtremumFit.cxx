#include "ExtremumFit.h"

#include "SpatialQuadric.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>
#include <utility>
#include <vector>

namespace SurfaceScalars
{
namespace
{

constexpr int PerDoubling = 2;          // windows, each of twice the area of the one before
constexpr int FirstStep = -3;           // of a window from the least: one to compare with that, and
                                        // inner halves
constexpr double LeastRadius = 6.0;     // in smoothing lengths, of a fit worth more than smoothing
constexpr Index MostVertices = 10000;   // of a window
constexpr Index LeastPerTerm = 2;       // vertices, for a fit that tells its error
constexpr double LikelyVariance = 2.25; // of a difference, that says what may be as extreme

double distance(const NoisyFunction& function, Index a, Index b)
{
  return (function.vertices.col(a) - function.vertices.col(b)).norm();
}

/// The vertices within a radius of a vertex that paths within it lead to.
class Window
{
public:
  Window(const NoisyFunction& function, Index center)
    : function_(function)
    , center_(center)
    , beyond_{ center }
    , known_{ center }
  {
  }

  /// Tells the vertices that are new. @param radius larger than before
  template <class Meet>
  void grow(double radius, const Meet& meet)
  {
    std::vector<Index> reached = std::move(this->beyond_);
    this->beyond_.clear();
    while (!reached.empty())
    {
      const Index vertex = reached.back();
      reached.pop_back();
      if (distance(this->function_, vertex, this->center_) > radius)
      {
        this->beyond_.push_back(vertex);
        continue;
      }
      meet(vertex);
      for (const Index neighbor : this->function_.mesh.link(vertex))
      {
        if (this->known_.insert(neighbor).second)
        {
          reached.push_back(neighbor);
        }
      }
    }
  }

  bool isWhole() const { return this->beyond_.empty(); }

private:
  const NoisyFunction& function_;
  Index center_;
  std::vector<Index> beyond_; ///< next to the window
  std::unordered_set<Index> known_;
};

/// The quadric that f is around a vertex, and how far.
class LargestQuadric
{
public:
  LargestQuadric(const NoisyFunction& function, Index center, const Poll& poll)
    : function_(function)
    , center_(center)
  {
    Window window(function, center);
    for (int step = FirstStep; !window.isWhole() && this->moments_.count() <= MostVertices; ++step)
    {
      poll();
      const double radius =
        LeastRadius * function.length * std::exp2(static_cast<double>(step) / PerDoubling);
      window.grow(radius, [&](Index vertex) { this->add(vertex); });
      if (!this->isAgreed(radius))
      {
        return;
      }
    }
  }

  /// Within which f is the quadric.
  double radius() const { return this->radius_; }
  bool isWorthIt() const { return this->radius_ >= LeastRadius * this->function_.length; }

  double value(Index vertex) const
  {
    return this->fits_.back().quadric.coefficients.dot(this->termsOf(vertex));
  }
  /// The variance of the difference of two values.
  double ofDifference(Index a, Index b) const
  {
    return this->fits_.back().quadric.ofDifference(this->termsOf(a) - this->termsOf(b));
  }

private:
  struct Fit
  {
    SpatialQuadric quadric;
    QuadricMatrix spread; ///< of the inner half of its window
  };

  Vector3d placeOf(Index vertex) const
  {
    return (this->function_.vertices.col(vertex) - this->function_.vertices.col(this->center_)) /
      (LeastRadius * this->function_.length);
  }
  QuadricVector termsOf(Index vertex) const { return quadricTerms(this->placeOf(vertex)); }

  void add(Index vertex)
  {
    const Values& origin = this->function_.smooth;
    this->moments_.add(
      this->placeOf(vertex), this->function_.values[vertex] - origin[this->center_]);
  }

  /// Fits a quadric to the window, if it is large enough. @returns whether smaller ones agree
  bool isAgreed(double radius)
  {
    this->spreads_.push_back(this->moments_.spread());
    if (this->spreads_.size() <= PerDoubling ||
      this->moments_.count() < LeastPerTerm * QuadricTerms)
    {
      return true;
    }
    SpatialQuadric quadric = this->moments_.solve();
    const double noise = this->function_.noise;
    quadric.variance = std::min(quadric.variance, noise * noise); // the rest is f
    const bool isAgreed = std::all_of(this->fits_.begin(), this->fits_.end(),
      [&](const Fit& fit) { return areAlike(fit.quadric, quadric, fit.spread); });
    if (isAgreed)
    {
      this->fits_.push_back({ quadric, this->spreads_.rbegin()[PerDoubling] });
      this->radius_ = radius;
    }
    return isAgreed;
  }

  const NoisyFunction& function_;
  Index center_;
  double radius_ = 0.0;
  QuadricMoments moments_;             ///< of the last window
  std::vector<QuadricMatrix> spreads_; ///< of all windows
  std::vector<Fit> fits_;              ///< those that agree
};

/// The vertices within a radius that a path of such leads to along which smooth is nearly the same.
std::vector<Index> candidatesOf(
  const NoisyFunction& function, Index center, double radius, double tolerance)
{
  std::vector<Index> result{ center };
  std::unordered_set<Index> known{ center };
  for (std::size_t i = 0; i < result.size(); ++i)
  {
    for (const Index neighbor : function.mesh.link(result[i]))
    {
      if (distance(function, neighbor, center) <= radius &&
        std::abs(function.smooth[neighbor] - function.smooth[center]) <= tolerance &&
        known.insert(neighbor).second)
      {
        result.push_back(neighbor);
      }
    }
  }
  return result;
}

/// The mean of the places within a smoothing length of the best that noise may have kept from being
/// the best, by their likelihood.
Vector3d likelyPlace(const NoisyFunction& function, const LargestQuadric& quadric,
  const std::vector<Index>& candidates, Index best)
{
  Vector3d sum = function.vertices.col(best);
  double weights = 1.0;
  for (const Index vertex : candidates)
  {
    const double variance = LikelyVariance * quadric.ofDifference(vertex, best);
    if (variance > 0.0 && distance(function, vertex, best) <= function.length)
    {
      const double drop = quadric.value(vertex) - quadric.value(best);
      const double weight = std::exp(-0.5 * drop * drop / variance);
      sum += weight * function.vertices.col(vertex);
      weights += weight;
    }
  }
  return sum / weights;
}

} // namespace

Index fittedExtremum(
  const NoisyFunction& function, Index vertex, double tolerance, double sign, const Poll& poll)
{
  const LargestQuadric quadric(function, vertex, poll);
  if (!quadric.isWorthIt())
  {
    return vertex;
  }
  const std::vector<Index> candidates =
    candidatesOf(function, vertex, 0.5 * quadric.radius(), tolerance);
  const auto leastOf = [&](const auto& quantity)
  {
    return *std::min_element(candidates.begin(), candidates.end(),
      [&](Index a, Index b) { return quantity(a) < quantity(b); });
  };
  const Index best = leastOf([&](Index candidate) { return -sign * quadric.value(candidate); });
  const Vector3d place = likelyPlace(function, quadric, candidates, best);
  return leastOf(
    [&](Index candidate) { return (function.vertices.col(candidate) - place).squaredNorm(); });
}

} // namespace SurfaceScalars
