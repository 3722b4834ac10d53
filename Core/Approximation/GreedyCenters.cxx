#include "GreedyCenters.h"

#include "FarthestPoints.h"
#include "LargestMisses.h"
#include "MortonOrder.h"
#include "SpreadCandidates.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace SurfaceScalars
{
namespace
{

constexpr double CoverShare = 1.0 / 3.0;    // of the centers that are not of stars
constexpr std::size_t PlacesPerCover = 20;  // among which they are found
constexpr std::size_t PlacesPerCenter = 16; // that rounds look at
constexpr std::size_t PlacesInTheEnd = 32;  // those missed most
constexpr std::size_t FurtherPerCenter = 3;
constexpr double Separation = 1.1;     // of those of a round, in spacings of centers
constexpr double SmallestShare = 0.01; // of that, from those before
constexpr double Rounding = 1e-14;     // relative to the largest value

// Rounds cost the cube of the centers: the more there are, the fewer and larger they are, unless
// the sum at all vertices, which is evaluated twice anyway, takes as long.
constexpr double SmallestGrowth = 0.03;
constexpr double LargestGrowth = 0.2;
constexpr double GrowthPerCube = 1.0 / 9e10;
constexpr double GrowthPerSquare = 1.0 / 180.0; // over the vertices
constexpr double LastShare = 0.2;               // of the centers, for which all vertices compete
constexpr double MostExchanges = 20.0;
constexpr double ExchangesTimesCube = 1e10;
constexpr double ExchangedShare = 0.2; // of the growth
constexpr double LargestLoss = 0.8;    // of the largest miss, that an exchanged center causes

std::size_t shareOf(double share, std::size_t all)
{
  return static_cast<std::size_t>(std::ceil(share * static_cast<double>(all)));
}

/// Where a sum misses f, most first.
struct MissedPlaces
{
  std::vector<Index> vertices;
  double largest = 0.0; ///< miss
};

std::vector<Index> allOf(const Points& vertices)
{
  std::vector<Index> result(static_cast<std::size_t>(vertices.cols()));
  std::iota(result.begin(), result.end(), Index(0));
  return result;
}

class GreedySelection
{
public:
  GreedySelection(const Points& vertices, const ValuesRef& values, const std::vector<Index>& stars,
    std::size_t count, int dimension)
    : vertices_(vertices)
    , values_(values)
    , chosen_(stars)
    , starCount_(stars.size())
    , count_(count)
    , dimension_(dimension)
  {
  }

  void cover(const Execution& execution);
  void refine(CenterSum& sum, const Execution& execution);
  void exchange(CenterSum& sum, const Execution& execution);
  CenterSet centers() const
  {
    return { this->vertices_(Eigen::all, this->chosen_), this->values_(this->chosen_),
      static_cast<Eigen::Index>(this->starCount_) };
  }

private:
  Execution part(const Execution& execution, std::size_t more);
  double spacing() const;
  double growth() const;
  MissedPlaces mostMissed(const std::vector<Index>& places, std::size_t most, CenterSum& sum,
    const Execution& execution) const;
  bool dropLeastUseful(double largestMiss, CenterSum& sum, const Execution& execution);
  bool add(const std::vector<Index>& candidates, std::size_t count);

  const Points& vertices_;
  const ValuesRef& values_;
  std::vector<Index> chosen_;
  std::size_t starCount_;
  std::size_t count_;
  int dimension_;
  std::size_t coverCount_ = 0;
  double coverRadius_ = 0.0;
  double done_ = 0.0; ///< share of the work of all rounds
};

void GreedySelection::cover(const Execution& execution)
{
  const auto rest = static_cast<double>(this->count_ - this->starCount_);
  const auto most = static_cast<std::size_t>(std::ceil(CoverShare * rest));
  std::vector<Index> candidates =
    evenSubset(this->vertices_, PlacesPerCover * most, execution.part(0.0, 0.2));
  const Points stars = this->vertices_(Eigen::all, this->chosen_);
  FarthestPoints cover =
    farthestPoints(this->vertices_(Eigen::all, candidates), stars, most, execution.part(0.2, 0.9));
  if (!(cover.radius > 0.0)) // of few candidates all may be in stars
  {
    candidates = allOf(this->vertices_);
    cover = farthestPoints(this->vertices_, stars, most, execution.part(0.9, 1.0));
  }
  for (const Index candidate : cover.chosen)
  {
    this->chosen_.push_back(candidates[candidate]);
  }
  this->coverCount_ = cover.chosen.size();
  this->coverRadius_ = cover.radius;
}

/// Of the work, which grows with the cube of the centers, a round that adds as many.
Execution GreedySelection::part(const Execution& execution, std::size_t more)
{
  const auto size = static_cast<double>(this->chosen_.size() + more);
  const double begin = this->done_; // a round may have found fewer than it was to
  this->done_ = std::max(begin, std::pow(size / static_cast<double>(this->count_), 3.0));
  return execution.part(begin, this->done_);
}

/// Between centers that are not of stars: what the radius of the cover becomes as they grow in
/// number.
double GreedySelection::spacing() const
{
  const auto now = static_cast<double>(this->chosen_.size() - this->starCount_ + 1);
  const auto then = static_cast<double>(this->coverCount_ + 1);
  return this->coverRadius_ * std::pow(then / now, 1.0 / this->dimension_);
}

/// Of these places those where the sum through the centers misses f, at most so many, by how much.
MissedPlaces GreedySelection::mostMissed(const std::vector<Index>& places, std::size_t most,
  CenterSum& sum, const Execution& execution) const
{
  sum.interpolate(this->centers(), execution.part(0.0, 0.5));
  const Values misses =
    (sum.at(this->vertices_(Eigen::all, places), execution.part(0.5, 1.0)) - this->values_(places))
      .cwiseAbs();
  const double rounding = Rounding * this->values_.lpNorm<Eigen::Infinity>();
  MissedPlaces result{ largestMisses(misses, rounding, most), misses.maxCoeff() };
  std::vector<Index>& order = result.vertices;
  std::transform(order.begin(), order.end(), order.begin(), [&](Index i) { return places[i]; });
  return result;
}

/// The first of the candidates, apart from each other. @returns whether there was one
bool GreedySelection::add(const std::vector<Index>& candidates, std::size_t count)
{
  const std::size_t before = this->chosen_.size();
  const double spacing = Separation * this->spacing();
  const SpreadCandidates spread(this->vertices_, candidates);
  for (double apart = spacing; apart > SmallestShare * spacing; apart *= 0.5)
  {
    spread.choose(this->chosen_, before, apart, SmallestShare * spacing, before + count);
  }
  return this->chosen_.size() > before;
}

/// Of a round.
double GreedySelection::growth() const
{
  const auto count = static_cast<double>(this->count_);
  const double growth = std::min(GrowthPerCube * count * count * count,
    GrowthPerSquare * count * count / static_cast<double>(this->vertices_.cols()));
  return std::clamp(growth, SmallestGrowth, LargestGrowth);
}

void GreedySelection::refine(CenterSum& sum, const Execution& execution)
{
  const std::vector<Index> order = mortonOrder(this->vertices_, execution.part(0.0, 0.0));
  const double growth = this->growth();
  const std::size_t last = shareOf(LastShare, this->count_);
  bool isMissed = this->coverRadius_ > 0.0; // else every place is a center
  while (isMissed && this->chosen_.size() + last < this->count_)
  {
    const std::size_t size = this->chosen_.size();
    const std::size_t count = std::min(shareOf(growth, size), this->count_ - last - size);
    const std::vector<Index> places = evenPart(order, PlacesPerCenter * size);
    isMissed = this->add(
      this->mostMissed(places, places.size(), sum, this->part(execution, count)).vertices, count);
  }
  std::vector<Index> places = order;
  isMissed = this->coverRadius_ > 0.0;
  while (isMissed && this->chosen_.size() < this->count_)
  {
    const std::size_t count =
      std::min(shareOf(0.5 * growth, this->count_), this->count_ - this->chosen_.size());
    places =
      this->mostMissed(places, PlacesInTheEnd * this->count_, sum, this->part(execution, count))
        .vertices;
    isMissed = this->add(places, count);
  }
}

/// Some centers without which u would miss f there by less than now elsewhere, apart from each
/// other. After mostMissed(). @returns whether there is one
bool GreedySelection::dropLeastUseful(
  double largestMiss, CenterSum& sum, const Execution& execution)
{
  const Values losses = sum.leaveOneOutErrors(this->centers(), execution).cwiseAbs();
  std::vector<Index> order;
  for (std::size_t i = this->starCount_; i < this->chosen_.size(); ++i)
  {
    if (losses[static_cast<Eigen::Index>(i)] < LargestLoss * largestMiss)
    {
      order.push_back(static_cast<Index>(i));
    }
  }
  std::sort(order.begin(), order.end(),
    [&](Index a, Index b) { return losses[a] != losses[b] ? losses[a] < losses[b] : a < b; });
  std::transform(
    order.begin(), order.end(), order.begin(), [&](Index i) { return this->chosen_[i]; });
  std::vector<Index> dropped;
  SpreadCandidates(this->vertices_, order)
    .choose(dropped, 0, 2.0 * this->spacing(), 0.0,
      shareOf(ExchangedShare * this->growth(), this->chosen_.size() - this->starCount_));
  std::sort(dropped.begin(), dropped.end());
  const auto free = this->chosen_.begin() + static_cast<std::ptrdiff_t>(this->starCount_);
  this->chosen_.erase(
    std::remove_if(free, this->chosen_.end(),
      [&](Index vertex) { return std::binary_search(dropped.begin(), dropped.end(), vertex); }),
    this->chosen_.end());
  return !dropped.empty();
}

/// Centers that matter least for vertices that are missed most, time and again; the best of all
/// remains.
void GreedySelection::exchange(CenterSum& sum, const Execution& execution)
{
  const std::size_t count = this->chosen_.size();
  const double rounds = std::floor(
    std::min(MostExchanges, ExchangesTimesCube / std::pow(static_cast<double>(count), 3.0)));
  if (count == this->starCount_ || rounds < 1.0 || !(this->coverRadius_ > 0.0))
  {
    return;
  }
  std::vector<Index> places = allOf(this->vertices_);
  std::vector<Index> best;
  double smallest = std::numeric_limits<double>::infinity();
  for (double round = 0.0; round <= rounds; round += 1.0)
  {
    const Execution ofRound =
      execution.part(round / (rounds + 1.0), (round + 1.0) / (rounds + 1.0));
    const MissedPlaces missed =
      this->mostMissed(places, PlacesInTheEnd * count, sum, ofRound.part(0.0, 0.7));
    if (missed.largest < smallest)
    {
      smallest = missed.largest;
      best = this->chosen_;
    }
    places = missed.vertices;
    if (places.empty() || !this->dropLeastUseful(missed.largest, sum, ofRound.part(0.7, 1.0)))
    {
      break;
    }
    this->add(places, count - this->chosen_.size());
  }
  this->chosen_ = best;
}

} // namespace

ChosenCenters greedyCenters(const Points& vertices, const ValuesRef& values,
  const std::vector<Index>& stars, std::size_t count, int dimension, CenterSum& sum,
  const Execution& execution)
{
  GreedySelection selection(vertices, values, stars, count, dimension);
  selection.cover(execution.part(0.0, 0.1));
  selection.refine(sum, execution.part(0.1, 0.7));
  selection.exchange(sum, execution.part(0.7, 1.0));
  const std::vector<Index> further =
    evenSubset(vertices, FurtherPerCenter * (count - stars.size()), execution.part(1.0, 1.0));
  return { selection.centers(), { vertices(Eigen::all, further), values(further) } };
}

} // namespace SurfaceScalars
