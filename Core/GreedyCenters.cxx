#include "GreedyCenters.h"

#include "FarthestPoints.h"
#include "MortonOrder.h"
#include "PointTree.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace SurfaceScalars
{
namespace
{

constexpr double CoverShare = 1.0 / 3.0;       // of the centers that are not of stars
constexpr std::size_t CandidatesPerCover = 20; // for each center of the cover
constexpr std::size_t ProbesPerCenter = 16;    // vertices that all but the last rounds look at
constexpr std::size_t MostCandidates = 100000; // of the last rounds: those missed most
constexpr double LastShare = 0.05;             // of the centers, chosen among all vertices
constexpr double Growth = 0.1;                 // of a round
constexpr double LateGrowth = 0.2; // the same of many centers, as their system takes long
constexpr std::size_t Many = 2000;
constexpr std::size_t FewestAdded = 8;
constexpr double Separation = 1.1;     // of those of a round, in spacings of centers
constexpr double SmallestShare = 0.01; // of that, from those before
constexpr double Rounding = 1e-14;     // relative to the largest value
constexpr std::size_t FurtherPerCenter = 3;

/// Vertices, the most wanted first, of which some are chosen.
class SpreadCandidates
{
public:
  SpreadCandidates(const Points& vertices, std::vector<Index> candidates)
    : vertices_(vertices)
    , candidates_(std::move(candidates))
    , places_(columnsOf(vertices, this->candidates_))
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
  std::vector<Index> candidates_;
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
  double done(std::size_t more = 0) const;
  double spacing() const;
  std::size_t roundSize() const;
  std::size_t add(const std::vector<Index>& places, const Values& misses, std::size_t most);

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
    evenSubset(this->vertices_, CandidatesPerCover * most, execution.part(0.0, 0.2));
  const FarthestPoints cover = farthestPoints(columnsOf(this->vertices_, candidates),
    columnsOf(this->vertices_, this->chosen_), most, execution.part(0.2, 1.0));
  for (const Index candidate : cover.chosen)
  {
    this->chosen_.push_back(candidates[candidate]);
  }
  this->coverCount_ = cover.chosen.size();
  this->coverRadius_ = cover.radius;
}

/// Of the work, which grows with the cube of the centers.
double GreedySelection::done(std::size_t more) const
{
  const double share =
    static_cast<double>(this->chosen_.size() + more) / static_cast<double>(this->count_);
  return std::min(1.0, share * share * share);
}

/// Between centers that are not of stars: what the radius of the cover becomes as they grow in
/// number.
double GreedySelection::spacing() const
{
  const auto now = static_cast<double>(this->chosen_.size() - this->starCount_ + 1);
  const auto then = static_cast<double>(this->coverCount_ + 1);
  return this->coverRadius_ * std::pow(then / now, 1.0 / this->dimension_);
}

std::size_t GreedySelection::roundSize() const
{
  const std::size_t left = this->count_ - this->chosen_.size();
  const auto last = static_cast<std::size_t>(LastShare * static_cast<double>(this->count_));
  const double growth = this->chosen_.size() < Many ? Growth : LateGrowth;
  const auto added = std::max(
    FewestAdded, static_cast<std::size_t>(growth * static_cast<double>(this->chosen_.size())));
  return left <= last + FewestAdded ? left : std::min(added, left - last);
}

/// Adds at most so many of the places, where f is missed most. @returns how many
std::size_t GreedySelection::add(
  const std::vector<Index>& places, const Values& misses, std::size_t most)
{
  std::vector<Index> order(places.size());
  std::iota(order.begin(), order.end(), Index(0));
  const auto missesMore = [&](Index a, Index b)
  { return misses[a] != misses[b] ? misses[a] > misses[b] : a < b; };
  if (order.size() > MostCandidates)
  {
    const auto end = order.begin() + static_cast<std::ptrdiff_t>(MostCandidates);
    std::nth_element(order.begin(), end, order.end(), missesMore);
    order.erase(end, order.end());
  }
  std::sort(order.begin(), order.end(), missesMore);
  std::transform(
    order.begin(), order.end(), order.begin(), [&](Index place) { return places[place]; });

  const std::size_t before = this->chosen_.size();
  const double spacing = Separation * this->spacing();
  const SpreadCandidates candidates(this->vertices_, std::move(order));
  for (double apart = spacing; apart > SmallestShare * spacing; apart *= 0.5)
  {
    candidates.choose(this->chosen_, before, apart, SmallestShare * spacing, before + most);
  }
  return this->chosen_.size() - before;
}

void GreedySelection::refine(CenterSum& sum, const Execution& execution)
{
  if (!(this->coverRadius_ > 0.0))
  {
    return; // every place is a center
  }
  const std::vector<Index> order = mortonOrder(this->vertices_, execution.part(0.0, 0.02));
  bool isOfAll = false;
  const double rounding = Rounding * this->values_.lpNorm<Eigen::Infinity>();
  while (this->chosen_.size() < this->count_)
  {
    const std::size_t wanted = this->roundSize();
    isOfAll = isOfAll || this->chosen_.size() + wanted == this->count_;
    const std::vector<Index> places =
      isOfAll ? order : evenPart(order, ProbesPerCenter * this->chosen_.size());
    const Execution round =
      execution.part(0.02 + 0.98 * this->done(), 0.02 + 0.98 * this->done(wanted));
    sum.interpolate(this->centers(), round.part(0.0, 0.5));
    const Values misses = (sum.at(columnsOf(this->vertices_, places), round.part(0.5, 1.0)) -
      entriesOf(this->values_, places))
                            .cwiseAbs();
    const bool isExact = misses.maxCoeff() <= rounding;
    if ((isExact || this->add(places, misses, wanted) == 0) && std::exchange(isOfAll, true))
    {
      return;
    }
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
