#include "PatchCurves.h"

#include "PatchStars.h"
#include "Polyline.h"
#include "SaddleLoops.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace SurfaceScalars
{
namespace
{

/// A segment with the normal of its triangle.
struct Segment
{
  PatchSegment ends;
  Vector3d normal;
};

/// A way along segments, through nodes that join two of them.
struct NodePath
{
  std::vector<Index> nodes;
  std::vector<Vector3d> normals; ///< of the segments, agreeing with each other
  std::size_t first;             ///< segment
  std::size_t last;
};

class CurveAssembly
{
public:
  explicit CurveAssembly(const ContourPatch& patch);
  std::vector<LevelSetCurve> run();

private:
  bool isEnd(Index node) const
  {
    return this->isSaddle_[node] || this->incident_[node].size() != 2;
  }
  NodePath follow(std::size_t segment, Index from);
  TracedCurve curveAlong(const NodePath& path) const;
  std::vector<SaddleFan> fans();
  std::optional<BranchId> branchOf(Index node, std::size_t segment) const;

  const ContourPatch& patch_;
  std::vector<Segment> segments_;
  std::vector<std::vector<std::size_t>> incident_;         ///< segments of each node
  std::vector<bool> isSaddle_;                             ///< of each node
  std::vector<bool> isUsed_;                               ///< of each segment
  std::vector<std::pair<std::size_t, BranchId>> branches_; ///< segments that begin them, ascending
};

CurveAssembly::CurveAssembly(const ContourPatch& patch)
  : patch_(patch)
  , incident_(patch.nodes.size())
  , isSaddle_(patch.nodes.size())
{
  for (const PatchPiece& piece : patch.pieces)
  {
    if (const std::optional<PatchSegment> segment = patch.segment(piece))
    {
      this->incident_[segment->from].push_back(this->segments_.size());
      this->incident_[segment->to].push_back(this->segments_.size());
      this->segments_.push_back({ *segment, patch.normal(piece) });
    }
  }
  for (const PatchVertex& vertex : patch.vertices)
  {
    if (vertex.node != PatchVertex::None)
    {
      this->isSaddle_[vertex.node] = true;
    }
  }
  this->isUsed_.resize(this->segments_.size());
}

NodePath CurveAssembly::follow(std::size_t segment, Index from)
{
  NodePath path{ { from }, {}, segment, segment };
  double agreement = 0.0;
  for (bool isOver = false; !isOver;)
  {
    const Segment& next = this->segments_[segment];
    this->isUsed_[segment] = true;
    const bool isForwards = next.ends.from == path.nodes.back();
    const Index to = isForwards ? next.ends.to : next.ends.from;
    const double length =
      (this->patch_.nodes[next.ends.to] - this->patch_.nodes[next.ends.from]).norm();
    agreement += isForwards ? length : -length;
    path.normals.push_back(isForwards ? next.normal : Vector3d(-next.normal));
    path.nodes.push_back(to);
    path.last = segment;
    isOver = this->isEnd(to);
    if (!isOver)
    {
      const std::vector<std::size_t>& around = this->incident_[to];
      segment = around[0] == segment ? around[1] : around[0];
      isOver = this->isUsed_[segment];
    }
  }
  if (agreement < 0.0)
  {
    std::reverse(path.nodes.begin(), path.nodes.end());
    std::reverse(path.normals.begin(), path.normals.end());
    std::for_each(path.normals.begin(), path.normals.end(), [](Vector3d& n) { n = -n; });
    std::swap(path.first, path.last);
  }
  return path;
}

/// The places along a path, each once; normals are means of those beside them.
TracedCurve CurveAssembly::curveAlong(const NodePath& path) const
{
  TracedCurve curve;
  for (std::size_t i = 0; i < path.nodes.size(); ++i)
  {
    const Vector3d& place = this->patch_.nodes[path.nodes[i]];
    const Vector3d before = i > 0 ? path.normals[i - 1] : Vector3d::Zero();
    const Vector3d after = i < path.normals.size() ? path.normals[i] : Vector3d::Zero();
    if (curve.points.empty() || curve.points.back().position != place)
    {
      curve.points.push_back({ place, before, 0.0, true });
    }
    curve.points.back().normal += after;
  }
  for (LevelSetPoint& point : curve.points)
  {
    point.normal = point.normal.isZero() ? Vector3d::UnitZ() : point.normal.normalized();
  }
  curve.tangents.resize(curve.points.size(), Vector3d::Zero());
  curve.steps.resize(curve.points.size());
  return curve;
}

/// The saddles with their branches in cyclic order; notes which segments begin these.
std::vector<SaddleFan> CurveAssembly::fans()
{
  std::vector<Index> saddles;
  for (Index i = 0; i < this->patch_.vertices.size(); ++i)
  {
    if (this->patch_.vertices[i].node != PatchVertex::None)
    {
      saddles.push_back(i);
    }
  }
  std::vector<SaddleFan> fans(saddles.size());
  const std::vector<PatchStar> stars = starsOf(this->patch_, saddles);
  for (std::size_t fan = 0; fan < saddles.size(); ++fan)
  {
    const std::vector<Index> link = linkOf(this->patch_, saddles[fan], stars[fan]);
    const Index center = this->patch_.vertices[saddles[fan]].node;
    for (std::size_t i = 0; i < link.size(); ++i)
    {
      const ContourPatch::EdgeKey side = ContourPatch::keyOf(link[i], link[(i + 1) % link.size()]);
      if (!this->patch_.isCrossed(side))
      {
        continue;
      }
      const Index node = this->patch_.edges.at(side).node;
      for (const std::size_t segment : this->incident_[center])
      {
        const PatchSegment& ends = this->segments_[segment].ends;
        if (ends.from == node || ends.to == node)
        {
          this->branches_.push_back({ segment, { fan, fans[fan].branches.size() } });
        }
      }
      if (fans[fan].branches.empty())
      {
        fans[fan].firstSectorIsAbove =
          !(this->patch_.vertices[link[(i + 1) % link.size()]].height < 0.0);
      }
      fans[fan].branches.emplace_back();
    }
  }
  std::sort(this->branches_.begin(), this->branches_.end(),
    [](const auto& a, const auto& b) { return a.first < b.first; });
  return fans;
}

/// The branch that a path begins or ends with, if there is a saddle.
std::optional<BranchId> CurveAssembly::branchOf(Index node, std::size_t segment) const
{
  const auto found = std::lower_bound(this->branches_.begin(), this->branches_.end(), segment,
    [](const auto& branch, std::size_t wanted) { return branch.first < wanted; });
  const bool isBranch =
    this->isSaddle_[node] && found != this->branches_.end() && found->first == segment;
  return isBranch ? std::optional<BranchId>(found->second) : std::nullopt;
}

std::vector<LevelSetCurve> CurveAssembly::run()
{
  const std::vector<SaddleFan> fans = this->fans();
  std::vector<TracedCurve> curves;
  std::vector<SaddleArc> arcs;
  const auto add = [&](const NodePath& path)
  {
    TracedCurve curve = this->curveAlong(path);
    const std::optional<BranchId> from = this->branchOf(path.nodes.front(), path.first);
    const std::optional<BranchId> to = this->branchOf(path.nodes.back(), path.last);
    if (from && to)
    {
      arcs.push_back({ std::move(curve), *from, to });
    }
    else
    {
      curve.closed = path.nodes.front() == path.nodes.back();
      if (curve.closed)
      {
        curve.points.pop_back();
      }
      curves.push_back(std::move(curve));
    }
  };
  for (Index node = 0; node < this->incident_.size(); ++node)
  {
    for (const std::size_t segment : this->incident_[node])
    {
      if (this->isEnd(node) && !this->isUsed_[segment])
      {
        add(this->follow(segment, node));
      }
    }
  }
  for (std::size_t segment = 0; segment < this->segments_.size(); ++segment)
  {
    if (!this->isUsed_[segment])
    {
      add(this->follow(segment, this->segments_[segment].ends.from));
    }
  }
  const std::vector<TracedCurve> joined = joinArcs(fans, arcs);
  curves.insert(curves.end(), joined.begin(), joined.end());

  std::vector<LevelSetCurve> result;
  for (TracedCurve& curve : curves)
  {
    LevelSetCurve one;
    one.closed = curve.closed;
    one.length = polylineLength(curve.points, curve.closed);
    one.points = std::move(curve.points);
    if (one.length > 0.0)
    {
      result.push_back(std::move(one));
    }
  }
  return result;
}

} // namespace

std::vector<LevelSetCurve> curvesOf(const ContourPatch& patch)
{
  return CurveAssembly(patch).run();
}

} // namespace SurfaceScalars
