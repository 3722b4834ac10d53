#include "MorseNetwork.h"

#include "NetworkComplement.h"
#include "NetworkPaths.h"

#include <algorithm>

namespace SurfaceScalars
{
namespace
{

Precedence starsOf(const MeshTopology& mesh, const std::vector<MorsePoint>& points)
{
  Precedence result;
  for (const MorsePoint& point : points)
  {
    for (std::size_t i = 0; i < point.sides.size(); ++i)
    {
      const Index neighbor = mesh.link(point.vertex).begin()[i];
      const bool isLower = point.sides[i] < 0;
      result.add(isLower ? neighbor : point.vertex, isLower ? point.vertex : neighbor);
    }
  }
  return result;
}

class NetworkBuilder
{
public:
  NetworkBuilder(const DesignMesh& mesh, const Values& values,
    const std::vector<MorsePoint>& points, const PathCosts& costs)
    : mesh_(mesh.topology())
    , points_(points)
    , stars_(starsOf(mesh.topology(), points))
    , paths_(mesh, values, points, this->stars_, costs)
    , result_{ std::vector<char>(values.size(), 0), this->stars_, values }
  {
    for (const MorsePoint& point : points)
    {
      this->result_.isInNetwork[point.vertex] = point.type == CriticalType::Minimum ? 1 : 0;
    }
  }

  /// @returns whether there was room
  bool connect(const MorsePoint& saddle, const Execution& execution);

  const MorseNetwork& result() const { return this->result_; }

private:
  using Sector = std::vector<Index>;

  std::vector<PointIndex> indices() const;
  bool complete();
  bool takeMetSectors();
  bool take(const NetworkPath& path, const Sector& sector);
  bool connect(const Sector& sector, const Execution& execution);

  const MeshTopology& mesh_;
  const std::vector<MorsePoint>& points_;
  const Precedence stars_;
  NetworkPaths paths_;
  Index saddle_ = 0;          ///< that is being connected
  std::vector<Sector> open_;  ///< sectors of the saddle that have no path yet
  std::vector<Index> higher_; ///< neighbors of the saddles so far
  MorseNetwork result_;
};

/// What is to come.
std::vector<PointIndex> NetworkBuilder::indices() const
{
  std::vector<PointIndex> result;
  for (const MorsePoint& point : this->points_)
  {
    if (this->result_.isInNetwork[point.vertex] == 0)
    {
      result.push_back({ point.vertex, indexOf(point.type, point.multiplicity) });
    }
  }
  for (const Sector& sector : this->open_)
  {
    result.push_back({ sector.front(), -1 });
  }
  for (const Index vertex : this->higher_)
  {
    result.push_back({ vertex, 0 });
  }
  return result;
}

bool NetworkBuilder::complete()
{
  return SurfaceScalars::complete(this->mesh_, this->result_.isInNetwork, this->indices());
}

/// @param path through the sector, which becomes part of the network as a whole: all of it is lower
/// than the saddle
bool NetworkBuilder::take(const NetworkPath& path, const Sector& sector)
{
  const auto mark = [&](char flag)
  {
    for (const std::vector<Index>* vertices : { &path.vertices, &sector })
    {
      for (const Index vertex : *vertices)
      {
        this->result_.isInNetwork[vertex] = flag;
      }
    }
  };
  mark(1);
  if (!this->complete())
  {
    mark(0);
    return false;
  }
  Index lower = path.end;
  for (auto vertex = path.vertices.rbegin(); vertex != path.vertices.rend(); ++vertex)
  {
    double& height = this->result_.heights[*vertex];
    height = std::min(height, this->result_.heights[this->saddle_]);
    this->result_.precedence.add(lower, *vertex);
    lower = *vertex;
  }
  return true;
}

/// Takes the cheapest path that is possible. @returns whether there is one
bool NetworkBuilder::connect(const Sector& sector, const Execution& execution)
{
  std::vector<Index> obstacles;
  for (const PointIndex& point : this->indices())
  {
    if (point.index != 0)
    {
      obstacles.push_back(point.vertex);
    }
  }
  this->paths_.search(this->saddle_, sector, this->result_.isInNetwork, obstacles, execution);
  for (const NetworkPaths::Crossing& crossing : this->paths_.crossings())
  {
    for (const bool isNarrow : { false, true })
    {
      const NetworkPath path = this->paths_.path(crossing, isNarrow);
      if (!path.vertices.empty() && this->take(path, sector))
      {
        return true;
      }
    }
  }
  return false;
}

/// Sectors through which paths of other saddles lead are connected by these.
bool NetworkBuilder::takeMetSectors()
{
  std::vector<char>& isInNetwork = this->result_.isInNetwork;
  const auto isMet = [&](const Sector& sector)
  {
    return std::any_of(
      sector.begin(), sector.end(), [&](Index vertex) { return isInNetwork[vertex] != 0; });
  };
  const auto met = std::stable_partition(
    this->open_.begin(), this->open_.end(), [&](const Sector& sector) { return !isMet(sector); });
  for (auto sector = met; sector != this->open_.end(); ++sector)
  {
    for (const Index vertex : *sector)
    {
      isInNetwork[vertex] = 1;
    }
  }
  const bool areSome = met != this->open_.end();
  this->open_.erase(met, this->open_.end());
  return !areSome || this->complete();
}

bool NetworkBuilder::connect(const MorsePoint& saddle, const Execution& execution)
{
  this->saddle_ = saddle.vertex;
  this->result_.isInNetwork[saddle.vertex] = 1;
  this->open_ = lowerSectors(this->mesh_, saddle);
  for (std::size_t i = 0; i < saddle.sides.size(); ++i)
  {
    if (saddle.sides[i] > 0)
    {
      this->higher_.push_back(this->mesh_.link(saddle.vertex).begin()[i]);
    }
  }
  if (!this->takeMetSectors())
  {
    return false;
  }
  while (!this->open_.empty())
  {
    const Sector sector = this->open_.back();
    this->open_.pop_back();
    if (!this->connect(sector, execution))
    {
      return false;
    }
  }
  return true;
}

} // namespace

std::optional<MorseNetwork> morseNetwork(const DesignMesh& mesh, const Values& values,
  const std::vector<MorsePoint>& points, const PathCosts& costs, const Execution& execution)
{
  const auto count = static_cast<double>(points.size());
  NetworkBuilder builder(mesh, values, points, costs);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const double share = static_cast<double>(i) / count;
    if (points[i].type == CriticalType::Saddle &&
      !builder.connect(points[i], execution.part(share, share)))
    {
      return std::nullopt;
    }
  }
  return builder.result();
}

} // namespace SurfaceScalars
