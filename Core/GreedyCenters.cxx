#include "GreedyCenters.h"

#include "FarthestPoints.h"
#include "MortonOrder.h"
#include "PointTree.h"

#include <algorithm>
#include <cmath>

namespace SurfaceScalars
{
namespace
{

constexpr double CoverShare = 1.0 / 3.0;    // of the centers that are not of stars
constexpr std::size_t PlacesPerCover = 20;  // among which they are found
constexpr std::size_t PlacesPerCenter = 16; // that rounds look at
constexpr std::size_t PlacesInTheEnd = 32;  // those missed most
constexpr std::size_t FurtherPerCenter = 3;
constexpr double Growth = 0.1; // of a round
constexpr std::size_t FewestAdded = 8;
constexpr double Separation = 1.1;     // of those of a round, in spacings of centers
constexpr double SmallestShare = 0.01; // of that, from those before
constexpr double Rounding = 1e-14;     // relative to the largest value

/// Rounds cost the cube of the centers: many centers have fewer and larger ones.
constexpr std::size_t Many = 2000;
constexpr double GrowthOfMany = 0.2;
constexpr double LastGrowth = 0.02; // of the last rounds, for which all vertices compete
constexpr std::size_t LastRounds = 10;
constexpr std::size_t LastRoundsOfMany = 2;

/// Vertices, the most wanted first, of which some are chosen.
class SpreadCandidates
{
public:
  SpreadCandidates(const Points& vertices, const std::vector<Index>& candidates)
    : vertices_(vertices)
    , candidates_(candidates)
    , places_(columnsOf(vertices, candidates))
    , tree_(this->places_)
  {
  }

  /// Appends to `chosen` until it has `count`: no closer than `apart` to those from `first` on, and
  /// than `apartFromOthers` to those before.
  void choose(std::vector<Index>& chosen, std::size_t first, double apart, double apartFromOthers,
    std::size_t count) const
  {
    std::vector<char> isTaken(this->candidates_.size(), 0);
    for (std::size_t i = 0; i < chosen.size(); ++i)
    {
      this->take(chosen[i], i < first ? apartFromOthers : apart, isTaken);
    }
    for (std::size_t i = 0; i < isTaken.size() && chosen.size() < count; ++i)
    {
      if (isTaken[i] == 0)
      {
        chosen.push_back(this->candidates_[i]);
        this->take(chosen.back(), apart, isTaken);
      }
    }
  }

private:
  void take(Index vertex, double radius, std::vector<char>& isTaken) const
  {
    std::vector<Index> near;
    this->tree_.gather(this->vertices_.col(vertex), radius, isTaken.size(), near);
    for (const Index candidate : near)
    {
      isTaken[candidate] = 1;
    }
  }

  const Points& vertices_;
  const std::vector<Index>& candidates_;
  Points places_;
  PointTree tree_;
};

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
  CenterSet centers() const
  {
    return { columnsOf(this->vertices_, this->chosen_), entriesOf(this->values_, this->chosen_),
      static_cast<Eigen::Index>(this->starCount_) };
  }

private:
  Execution part(const Execution& execution, std::size_t more) const;
  double spacing() const;
  bool isMany() const { return this->count_ > Many; }
  std::vector<Index> mostMissed(const std::vector<Index>& places, std::size_t most, CenterSum& sum,
    const Execution& execution) const;
  bool add(const std::vector<Index>& candidates, std::size_t count);

  const Points& vertices_;
  const ValuesRef& values_;
  std::vector<Index> chosen_;
  std::size_t starCount_;
  std::size_t count_;
  int dimension_;
  std::size_t coverCount_ = 0;
  double coverRadius_ = 0.0;
};

void GreedySelection::cover(const Execution& execution)
{
  const auto rest = static_cast<double>(this->count_ - this->starCount_);
  const auto most = static_cast<std::size_t>(std::ceil(CoverShare * rest));
  const std::vector<Index> candidates =
    evenSubset(this->vertices_, PlacesPerCover * most, execution.part(0.0, 0.2));
  const FarthestPoints cover = farthestPoints(columnsOf(this->vertices_, candidates),
    columnsOf(this->vertices_, this->chosen_), most, execution.part(0.2, 1.0));
  for (const Index candidate : cover.chosen)
  {
    this->chosen_.push_back(candidates[candidate]);
  }
  this->coverCount_ = cover.chosen.size();
  this->coverRadius_ = cover.radius;
}

/// Of the work, which grows with the cube of the centers, a round that adds as many.
Execution GreedySelection::part(const Execution& execution, std::size_t more) const
{
  const auto done = [&](std::size_t size)
  { return std::pow(static_cast<double>(size) / static_cast<double>(this->count_), 3.0); };
  return execution.part(done(this->chosen_.size()), done(this->chosen_.size() + more));
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
std::vector<Index> GreedySelection::mostMissed(const std::vector<Index>& places, std::size_t most,
  CenterSum& sum, const Execution& execution) const
{
  sum.interpolate(this->centers(), execution.part(0.0, 0.5));
  const Values misses = (sum.at(columnsOf(this->vertices_, places), execution.part(0.5, 1.0)) -
    entriesOf(this->values_, places))
                          .cwiseAbs();
  const double rounding = Rounding * this->values_.lpNorm<Eigen::Infinity>();
  std::vector<Index> order;
  for (Index i = 0; i < places.size(); ++i)
  {
    if (misses[i] > rounding)
    {
      order.push_back(i);
    }
  }
  const auto missesMore = [&](Index a, Index b)
  { return misses[a] != misses[b] ? misses[a] > misses[b] : a < b; };
  const auto end = order.begin() + static_cast<std::ptrdiff_t>(std::min(most, order.size()));
  std::partial_sort(order.begin(), end, order.end(), missesMore);
  order.erase(end, order.end());
  std::transform(order.begin(), order.end(), order.begin(), [&](Index i) { return places[i]; });
  return order;
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

void GreedySelection::refine(CenterSum& sum, const Execution& execution)
{
  if (!(this->coverRadius_ > 0.0))
  {
    return; // every place is a center
  }
  const auto shareOf = [](double share, std::size_t all)
  { return std::max(FewestAdded, static_cast<std::size_t>(share * static_cast<double>(all))); };
  const std::vector<Index> order = mortonOrder(this->vertices_, execution.part(0.0, 0.0));
  const std::size_t lastGrowth = shareOf(LastGrowth, this->count_);
  const std::size_t last = lastGrowth * (this->isMany() ? LastRoundsOfMany : LastRounds);
  bool isMissed = true;
  while (isMissed && this->chosen_.size() + last < this->count_)
  {
    const std::size_t size = this->chosen_.size();
    const std::size_t most = shareOf(this->isMany() ? GrowthOfMany : Growth, size);
    const std::size_t count = std::min(most, this->count_ - last - size);
    const std::vector<Index> places = evenPart(order, PlacesPerCenter * size);
    isMissed =
      this->add(this->mostMissed(places, places.size(), sum, this->part(execution, count)), count);
  }
  std::vector<Index> places = order;
  isMissed = true;
  while (isMissed && this->chosen_.size() < this->count_)
  {
    const std::size_t count = std::min(lastGrowth, this->count_ - this->chosen_.size());
    places =
      this->mostMissed(places, PlacesInTheEnd * this->count_, sum, this->part(execution, count));
    isMissed = this->add(places, count);
  }
}

} // namespace

ChosenCenters greedyCenters(const Points& vertices, const ValuesRef& values,
  const std::vector<Index>& stars, std::size_t count, int dimension, CenterSum& sum,
  const Execution& execution)
{
  GreedySelection selection(vertices, values, stars, count, dimension);
  selection.cover(execution.part(0.0, 0.1));
  selection.refine(sum, execution.part(0.1, 1.0));
  const std::vector<Index> further =
    evenSubset(vertices, FurtherPerCenter * (count - stars.size()), execution.part(1.0, 1.0));
  return { selection.centers(), { columnsOf(vertices, further), entriesOf(values, further) } };
}

} // namespace SurfaceScalars
