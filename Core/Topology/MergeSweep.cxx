#include "MergeSweep.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace SurfaceScalars
{
namespace
{

constexpr double MostResolutions = 8.0; // between a saddle's value and where the graph passes it

} // namespace

MergeSweep::MergeSweep(CriticalPairing& pairing, const MergeTree& tree, CriticalType extremumType)
  : all_(pairing)
  , tree_(tree)
  , sign_(extremumType == CriticalType::Minimum ? 1.0 : -1.0)
  , times_(tree)
  , sets_(static_cast<Index>(tree.basins.size()))
  , isPassed_(pairing.points.size(), 0)
  , waiting_(pairing.points.size())
{
  for (std::size_t i = 0; i < pairing.points.size(); ++i)
  {
    const CriticalType type = pairing.points[i].type;
    if (type == extremumType)
    {
      this->placeExtremum(i);
    }
    else if (type == CriticalType::Saddle)
    {
      this->placeSaddle(i);
    }
    else if (type != CriticalType::Minimum && type != CriticalType::Maximum)
    {
      this->placeUncertain(i);
    }
  }
}

MergeComponent& MergeSweep::componentOf(Index sample)
{
  const Index root = this->sets_.find(this->tree_.basins[sample]);
  return this->components_
    .try_emplace(root, MergeComponent{ root, this->heightOfSample(root), NoPoint, {} })
    .first->second;
}

void MergeSweep::placeExtremum(std::size_t extremum)
{
  const CriticalPlace& place = this->all_.places[extremum];
  MergeComponent& component = this->componentOf(place.samples.front());
  std::size_t hidden = component.extremum;
  if (hidden == NoPoint || this->height(extremum) < this->height(hidden))
  {
    component.extremum = extremum;
    // A sample of the same valley is not taken for a deeper extremum.
    component.birth = this->height(extremum) - LeastResolutions * place.resolution;
  }
  else
  {
    hidden = extremum;
  }
  if (hidden != NoPoint)
  {
    this->all_.hidden.push_back(hidden);
  }
}

void MergeSweep::placeSaddle(std::size_t saddle)
{
  for (const Index sample : this->all_.places[saddle].samples)
  {
    std::vector<std::size_t>& saddles = this->componentOf(sample).saddles;
    if (saddles.empty() || saddles.back() != saddle)
    {
      saddles.push_back(saddle);
    }
  }
}

void MergeSweep::placeUncertain(std::size_t point)
{
  for (const Index sample : this->all_.places[point].samples)
  {
    this->uncertainAt_[sample].push_back(point);
  }
}

bool MergeSweep::isOlder(const MergeComponent& a, const MergeComponent& b) const
{
  if (a.extremum != NoPoint && b.extremum != NoPoint)
  {
    return this->height(a.extremum) < this->height(b.extremum) ||
      (this->height(a.extremum) == this->height(b.extremum) && a.extremum < b.extremum);
  }
  return a.birth < b.birth || (a.birth == b.birth && a.root < b.root);
}

/// The saddles around which both components lie and that can be where the graph merges them.
std::vector<std::size_t> MergeSweep::saddlesBetween(
  const MergeComponent& a, const MergeComponent& b, double level) const
{
  std::vector<std::size_t> common;
  std::set_intersection(a.saddles.begin(), a.saddles.end(), b.saddles.begin(), b.saddles.end(),
    std::back_inserter(common));
  const auto isElsewhere = [&](std::size_t saddle)
  {
    return std::abs(this->height(saddle) - level) >
      MostResolutions * this->all_.places[saddle].resolution;
  };
  common.erase(std::remove_if(common.begin(), common.end(), isElsewhere), common.end());
  return common;
}

void MergeSweep::endAtSaddle(const MergeComponent& younger, std::size_t saddle)
{
  if (younger.extremum != NoPoint)
  {
    this->all_.pair(younger.extremum, saddle);
  }
  else
  {
    this->all_.note(saddle, std::abs(this->height(saddle) - younger.birth));
  }
}

void MergeSweep::endAtSample(
  const MergeComponent& younger, Index sample, const std::vector<std::size_t>& saddles)
{
  const double level = this->heightOfSample(sample);
  const std::size_t extremum = younger.extremum;
  const double persistence =
    std::abs(level - (extremum != NoPoint ? this->height(extremum) : younger.birth));
  const auto noteAt = [&](Index place)
  {
    const auto found = this->uncertainAt_.find(place);
    for (const std::size_t point :
      found != this->uncertainAt_.end() ? found->second : std::vector<std::size_t>())
    {
      this->all_.note(point, persistence);
    }
  };
  noteAt(sample);
  if (extremum != NoPoint)
  {
    this->all_.points[extremum].persistence = persistence;
    return;
  }
  noteAt(younger.root);
  for (const std::size_t saddle : saddles)
  {
    if (std::abs(this->height(saddle) - level) <= 0.5 * persistence)
    {
      this->endAtSaddle(younger, saddle);
    }
  }
}

void MergeSweep::absorb(MergeComponent& elder, MergeComponent& younger)
{
  std::vector<std::size_t> saddles;
  std::set_union(elder.saddles.begin(), elder.saddles.end(), younger.saddles.begin(),
    younger.saddles.end(), std::back_inserter(saddles));
  elder.saddles = std::move(saddles);
  this->sets_.attach(younger.root, elder.root);
  this->components_.erase(younger.root);
}

/// A merge of the graph: at the saddle that lies between the two components, in its turn, or at
/// the sample where the graph has it. Edges may jump over a saddle that cancels other extrema: what
/// they merge is left for other saddles.
void MergeSweep::passMerge(const Merge& merge)
{
  MergeComponent* younger = &this->componentOf(merge.basins[0]);
  MergeComponent* elder = &this->componentOf(merge.basins[1]);
  if (younger == elder)
  {
    return;
  }
  if (this->isOlder(*younger, *elder))
  {
    std::swap(younger, elder);
  }
  const double level = this->heightOfSample(merge.vertex);
  const std::vector<std::size_t> saddles = this->saddlesBetween(*elder, *younger, level);
  if (younger->extremum != NoPoint && !saddles.empty() && !this->isLast_)
  {
    const auto next = std::find_if(saddles.begin(), saddles.end(),
      [this](std::size_t saddle) { return this->isPassed_[saddle] == 0; });
    (next != saddles.end() ? this->waiting_[*next] : this->postponed_).push_back(merge);
    return;
  }
  const auto saddle = std::find_if(
    saddles.begin(), saddles.end(), [this](std::size_t i) { return this->all_.freeCount[i] > 0; });
  if (younger->extremum != NoPoint && saddle != saddles.end())
  {
    this->endAtSaddle(*younger, *saddle);
  }
  else
  {
    this->endAtSample(*younger, merge.vertex, saddles);
  }
  this->absorb(*elder, *younger);
}

/// A saddle joins the components around it that come together in the graph at about its value,
/// those of critical extrema first.
void MergeSweep::pass(std::size_t saddle)
{
  this->isPassed_[saddle] = 1;
  const CriticalPlace& place = this->all_.places[saddle];
  const double highest = this->height(saddle) + MostResolutions * place.resolution;
  const Index first = this->tree_.basins[place.samples.front()];
  std::vector<MergeComponent*> around{ &this->componentOf(first) };
  for (const Index sample : place.samples)
  {
    MergeComponent* component = &this->componentOf(sample);
    const Merge* merge = this->times_.mergeOf(first, this->tree_.basins[sample]);
    if (merge && this->heightOfSample(merge->vertex) <= highest &&
      std::find(around.begin(), around.end(), component) == around.end())
    {
      around.push_back(component);
    }
  }
  std::stable_partition(around.begin(), around.end(),
    [](const MergeComponent* component) { return component->extremum != NoPoint; });
  const auto most = static_cast<std::size_t>(this->all_.freeCount[saddle]) + 1;
  around.resize(std::min(around.size(), most));
  std::sort(around.begin(), around.end(),
    [this](const MergeComponent* a, const MergeComponent* b) { return this->isOlder(*a, *b); });
  for (std::size_t i = 1; i < around.size(); ++i)
  {
    this->endAtSaddle(*around[i], saddle);
    this->absorb(*around[0], *around[i]);
  }
  for (const Merge& merge : this->waiting_[saddle])
  {
    this->passMerge(merge);
  }
}

void MergeSweep::run(double range)
{
  std::vector<std::size_t> saddles;
  for (std::size_t i = 0; i < this->all_.points.size(); ++i)
  {
    if (this->all_.isSaddle(i))
    {
      saddles.push_back(i);
    }
  }
  // The two sweeps meet the saddles in opposite orders, also where values are equal: what the one
  // cannot join is then left for the other.
  if (this->sign_ < 0.0)
  {
    std::reverse(saddles.begin(), saddles.end());
  }
  std::stable_sort(saddles.begin(), saddles.end(),
    [this](std::size_t a, std::size_t b) { return this->height(a) < this->height(b); });
  auto next = saddles.begin();
  for (const Merge& merge : this->tree_.merges)
  {
    for (; next != saddles.end() && this->height(*next) <= this->heightOfSample(merge.vertex);
         ++next)
    {
      this->pass(*next);
    }
    this->passMerge(merge);
  }
  std::for_each(next, saddles.end(), [this](std::size_t saddle) { this->pass(saddle); });
  this->isLast_ = true;
  for (const Merge& merge : this->postponed_)
  {
    this->passMerge(merge);
  }
  for (const auto& [root, component] : this->components_)
  {
    if (component.extremum != NoPoint)
    {
      this->all_.points[component.extremum].persistence = range;
    }
  }
}

} // namespace SurfaceScalars
