#include "GraphMergeTrees.h"
#include "Persistence.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <unordered_map>

namespace SurfaceScalars
{
namespace
{

constexpr std::size_t None = std::numeric_limits<std::size_t>::max();
constexpr double TouchRadius = 2.5; // in sampling steps: what lies within is at a critical point
constexpr double PairRadius = 10.0; // of extrema and saddles between which the graph has no barrier
constexpr std::size_t NearSamples = 6;   // whose values tell what the sampling can resolve
constexpr double LeastResolutions = 4.0; // more than that is seen by the sampling
constexpr double MostResolutions = 8.0;  // between a saddle's value and where the graph passes it

/// Where a critical point lies among the samples.
struct Place
{
  std::vector<Index> samples; ///< nearest first
  double step;                ///< sampling step
  double resolution;          ///< by how much f~ at the nearest samples differs from its value
};

Place placeOf(const CriticalPoint& point, const NeighborGraph& graph, const ValuesRef& values)
{
  const Vector3d position = point.position - graph.origin();
  const double step = graph.samplingStep(graph.pointOfInput(point.input));
  Neighborhood around;
  graph.within(position, TouchRadius * step, around);
  if (around.indices.size() < NearSamples)
  {
    graph.nearest(position, NearSamples, around);
  }
  double resolution = 0.0;
  const std::size_t near = std::min(NearSamples, around.indices.size());
  for (std::size_t i = 0; i < near; ++i)
  {
    resolution += std::abs(values[around.indices[i]] - point.value) / static_cast<double>(near);
  }
  return { std::move(around.indices), step, resolution };
}

/// When basins of a merge tree come together in the graph.
class MergeTimes
{
public:
  MergeTimes(const MergeTree& tree)
    : merges_(tree.merges)
    , times_(tree.basins.size(), tree.merges.size())
  {
    for (std::size_t i = 0; i < this->merges_.size(); ++i)
    {
      this->times_[this->merges_[i].younger] = i;
    }
  }

  /// The merge after which two extrema are in one component; none if there is no such merge.
  const Merge* mergeOf(Index a, Index b) const
  {
    std::size_t time = None;
    while (a != b)
    {
      Index& first = this->times_[a] < this->times_[b] ? a : b;
      time = this->times_[first];
      if (time == this->merges_.size())
      {
        return nullptr;
      }
      first = this->merges_[time].elder;
    }
    return time == None ? nullptr : &this->merges_[time];
  }

private:
  const std::vector<Merge>& merges_;
  std::vector<std::size_t> times_; ///< of the end of each extremum
};

/// A component of a sublevel set, or of a superlevel set.
struct Component
{
  Index root;                       ///< the extremum of the graph it is known by
  double birth;                     ///< height of its oldest extremum
  std::size_t extremum = None;      ///< that critical point, if it is one
  std::vector<std::size_t> saddles; ///< around which it lies, ascending
};

/// What both sweeps know of the critical points.
struct Assignment
{
  std::vector<CriticalPoint>& points;
  const NeighborGraph& graph;
  const ValuesRef& values;
  std::vector<Place> places = {};
  std::vector<int> freeCount = {};      ///< times that a saddle may still be paired
  std::vector<double> seen = {};        ///< persistence of graph pairs at a point
  std::vector<std::size_t> hidden = {}; ///< extrema in the basin of a deeper one
  std::vector<CriticalPair> pairs = {};

  bool isSaddle(std::size_t i) const { return this->points[i].type == CriticalType::Saddle; }
  void pair(std::size_t extremum, std::size_t saddle)
  {
    const double persistence = std::abs(this->points[saddle].value - this->points[extremum].value);
    this->points[extremum].persistence = persistence;
    this->pairs.push_back({ extremum, saddle, persistence });
    --this->freeCount[saddle];
  }
};

/// One sweep over the levels; superlevel sets are swept as the sublevel sets of -f.
class Sweep
{
public:
  Sweep(Assignment& assignment, const MergeTree& tree, CriticalType extremumType);
  void run(double range);

private:
  double height(double value) const { return this->sign_ * value; }
  double height(std::size_t point) const { return this->height(this->all_.points[point].value); }
  double heightOfSample(Index sample) const { return this->height(this->all_.values[sample]); }

  Component& componentOf(Index sample);
  void placeExtremum(std::size_t extremum);
  void placeSaddle(std::size_t saddle);
  void placeUncertain(std::size_t point);
  bool isOlder(const Component& a, const Component& b) const;
  std::vector<std::size_t> saddlesBetween(
    const Component& a, const Component& b, double level) const;
  void pass(std::size_t saddle);
  void passMerge(const Merge& merge);
  void endAtSaddle(const Component& younger, std::size_t saddle);
  void endAtSample(const Component& younger, Index sample, const std::vector<std::size_t>& saddles);
  void absorb(Component& elder, Component& younger);
  void note(std::size_t point, double persistence);

  Assignment& all_;
  const MergeTree& tree_;
  CriticalType extremumType_;
  double sign_;
  MergeTimes times_;
  DisjointSets sets_;
  std::unordered_map<Index, Component> components_;                 ///< by root
  std::unordered_map<Index, std::vector<std::size_t>> uncertainAt_; ///< a sample
  std::vector<char> isPassed_;                                      ///< of saddles
  std::vector<std::vector<Merge>> waiting_; ///< merges that a saddle close by shall make
  std::vector<Merge> postponed_; ///< merges for which no saddle is left, until all had their turn
  bool isLast_ = false;
};

Sweep::Sweep(Assignment& assignment, const MergeTree& tree, CriticalType extremumType)
  : all_(assignment)
  , tree_(tree)
  , extremumType_(extremumType)
  , sign_(extremumType == CriticalType::Minimum ? 1.0 : -1.0)
  , times_(tree)
  , sets_(static_cast<Index>(tree.basins.size()))
  , isPassed_(assignment.points.size(), 0)
  , waiting_(assignment.points.size())
{
  for (std::size_t i = 0; i < assignment.points.size(); ++i)
  {
    const CriticalType type = assignment.points[i].type;
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

Component& Sweep::componentOf(Index sample)
{
  const Index root = this->sets_.find(this->tree_.basins[sample]);
  return this->components_
    .try_emplace(root, Component{ root, this->heightOfSample(root), None, {} })
    .first->second;
}

void Sweep::placeExtremum(std::size_t extremum)
{
  const Place& place = this->all_.places[extremum];
  Component& component = this->componentOf(place.samples.front());
  std::size_t hidden = component.extremum;
  if (hidden == None || this->height(extremum) < this->height(hidden))
  {
    component.extremum = extremum;
    // A sample of the same valley is not taken for a deeper extremum.
    component.birth = this->height(extremum) - LeastResolutions * place.resolution;
  }
  else
  {
    hidden = extremum;
  }
  if (hidden != None)
  {
    this->all_.hidden.push_back(hidden);
  }
}

void Sweep::placeSaddle(std::size_t saddle)
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

void Sweep::placeUncertain(std::size_t point)
{
  for (const Index sample : this->all_.places[point].samples)
  {
    this->uncertainAt_[sample].push_back(point);
  }
}

bool Sweep::isOlder(const Component& a, const Component& b) const
{
  if (a.extremum != None && b.extremum != None)
  {
    return this->height(a.extremum) < this->height(b.extremum) ||
      (this->height(a.extremum) == this->height(b.extremum) && a.extremum < b.extremum);
  }
  return a.birth < b.birth || (a.birth == b.birth && a.root < b.root);
}

/// The saddles around which both components lie and that can be where the graph merges them.
std::vector<std::size_t> Sweep::saddlesBetween(
  const Component& a, const Component& b, double level) const
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

void Sweep::note(std::size_t point, double persistence)
{
  if (persistence >= LeastResolutions * this->all_.places[point].resolution)
  {
    this->all_.seen[point] = std::max(this->all_.seen[point], persistence);
  }
}

void Sweep::endAtSaddle(const Component& younger, std::size_t saddle)
{
  if (younger.extremum != None)
  {
    this->all_.pair(younger.extremum, saddle);
  }
  else
  {
    this->note(saddle, std::abs(this->height(saddle) - younger.birth));
  }
}

void Sweep::endAtSample(
  const Component& younger, Index sample, const std::vector<std::size_t>& saddles)
{
  const double level = this->heightOfSample(sample);
  const std::size_t extremum = younger.extremum;
  const double persistence =
    std::abs(level - (extremum != None ? this->height(extremum) : younger.birth));
  const auto noteAt = [&](Index place)
  {
    const auto found = this->uncertainAt_.find(place);
    for (const std::size_t point :
      found != this->uncertainAt_.end() ? found->second : std::vector<std::size_t>())
    {
      this->all_.seen[point] = std::max(this->all_.seen[point], persistence);
    }
  };
  noteAt(sample);
  if (extremum != None)
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

void Sweep::absorb(Component& elder, Component& younger)
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
void Sweep::passMerge(const Merge& merge)
{
  Component* younger = &this->componentOf(merge.basins[0]);
  Component* elder = &this->componentOf(merge.basins[1]);
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
  if (younger->extremum != None && !saddles.empty() && !this->isLast_)
  {
    const auto next = std::find_if(saddles.begin(), saddles.end(),
      [this](std::size_t saddle) { return this->isPassed_[saddle] == 0; });
    (next != saddles.end() ? this->waiting_[*next] : this->postponed_).push_back(merge);
    return;
  }
  const auto saddle = std::find_if(
    saddles.begin(), saddles.end(), [this](std::size_t i) { return this->all_.freeCount[i] > 0; });
  if (younger->extremum != None && saddle != saddles.end())
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
void Sweep::pass(std::size_t saddle)
{
  this->isPassed_[saddle] = 1;
  const Place& place = this->all_.places[saddle];
  const double highest = this->height(saddle) + MostResolutions * place.resolution;
  const Index first = this->tree_.basins[place.samples.front()];
  std::vector<Component*> around{ &this->componentOf(first) };
  for (const Index sample : place.samples)
  {
    Component* component = &this->componentOf(sample);
    const Merge* merge = this->times_.mergeOf(first, this->tree_.basins[sample]);
    if (merge && this->heightOfSample(merge->vertex) <= highest &&
      std::find(around.begin(), around.end(), component) == around.end())
    {
      around.push_back(component);
    }
  }
  std::stable_partition(around.begin(), around.end(),
    [](const Component* component) { return component->extremum != None; });
  const auto most = static_cast<std::size_t>(this->all_.freeCount[saddle] + 1);
  around.resize(std::min(around.size(), most));
  std::sort(around.begin(), around.end(),
    [this](const Component* a, const Component* b) { return this->isOlder(*a, *b); });
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

void Sweep::run(double range)
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
    if (component.extremum != None)
    {
      this->all_.points[component.extremum].persistence = range;
    }
  }
}

/// An extremum in the basin of another, and a saddle left over: the two of a pair that the samples
/// do not tell apart.
void pairHidden(Assignment& all)
{
  for (const std::size_t extremum : all.hidden)
  {
    const CriticalPoint& point = all.points[extremum];
    const double sign = point.type == CriticalType::Minimum ? 1.0 : -1.0;
    std::size_t best = None;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < all.points.size(); ++i)
    {
      const double rise = sign * (all.points[i].value - point.value);
      if (all.isSaddle(i) && all.freeCount[i] > 0 && rise >= 0.0 && rise < least &&
        (all.points[i].position - point.position).norm() <= PairRadius * all.places[i].step)
      {
        best = i;
        least = rise;
      }
    }
    all.points[extremum].persistence = 0.0;
    if (best != None)
    {
      all.pair(extremum, best);
    }
  }
}

/// Saddles and uncertain points, once all pairs are known.
void concludePersistence(Assignment& all, double range)
{
  for (std::size_t i = 0; i < all.points.size(); ++i)
  {
    const CriticalType type = all.points[i].type;
    if (type != CriticalType::Minimum && type != CriticalType::Maximum)
    {
      const bool joinsNothing =
        type == CriticalType::Saddle && all.freeCount[i] > 0 && all.seen[i] == 0.0;
      all.points[i].persistence = joinsNothing ? range : all.seen[i];
    }
  }
  for (const CriticalPair& pair : all.pairs)
  {
    double& persistence = all.points[pair.saddle].persistence;
    persistence = std::max(persistence, pair.persistence);
  }
}

} // namespace

std::vector<CriticalPair> assignPersistence(std::vector<CriticalPoint>& points,
  const NeighborGraph& graph, const ValuesRef& values, const Execution& execution)
{
  const GraphMergeTrees trees = graphMergeTrees(graph, values, execution.part(0.0, 0.9));
  const double range = values.maxCoeff() - values.minCoeff();
  Assignment all{ points, graph, values };
  for (const CriticalPoint& point : points)
  {
    all.places.push_back(placeOf(point, graph, values));
    all.freeCount.push_back(point.type == CriticalType::Saddle ? point.multiplicity : 0);
  }
  all.seen.assign(points.size(), 0.0);
  Sweep(all, trees.sublevel, CriticalType::Minimum).run(range);
  Sweep(all, trees.superlevel, CriticalType::Maximum).run(range);
  pairHidden(all);
  concludePersistence(all, range);
  execution.report(1.0);
  return std::move(all.pairs);
}

} // namespace SurfaceScalars
