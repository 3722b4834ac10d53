#include "SaddleLoops.h"

#include "CurveJoining.h"

#include <map>
#include <utility>

namespace SurfaceScalars
{
namespace
{

/// An arc from one of its two ends.
struct Way
{
  std::size_t arc;
  bool isReversed;
};

class ArcJoining
{
public:
  ArcJoining(const std::vector<SaddleFan>& fans, const std::vector<SaddleArc>& arcs)
    : fans_(fans)
    , arcs_(arcs)
    , isJoined_(arcs.size(), false)
  {
    for (std::size_t i = 0; i < arcs.size(); ++i)
    {
      if (arcs[i].to)
      {
        this->ways_[key(arcs[i].from)] = { i, false };
        this->ways_[key(*arcs[i].to)] = { i, true };
      }
    }
  }

  std::vector<TracedCurve> join();

private:
  static std::pair<std::size_t, std::size_t> key(const BranchId& id)
  {
    return { id.fan, id.branch };
  }
  bool isLoop(std::size_t arc) const
  {
    return this->arcs_[arc].to && this->arcs_[arc].to->fan == this->arcs_[arc].from.fan;
  }
  BranchId endOf(const Way& way) const
  {
    return way.isReversed ? this->arcs_[way.arc].from : *this->arcs_[way.arc].to;
  }

  std::optional<Way> next(const Way& way) const;
  std::vector<Way> follow(std::size_t arc) const;
  TracedCurve loopOf(const std::vector<Way>& ways) const;

  const std::vector<SaddleFan>& fans_;
  const std::vector<SaddleArc>& arcs_;
  std::map<std::pair<std::size_t, std::size_t>, Way> ways_; ///< that begin at a branch
  std::vector<bool> isJoined_;
};

/// Beyond the saddle at the end of a way; none if that branch ends elsewhere.
std::optional<Way> ArcJoining::next(const Way& way) const
{
  BranchId at = this->endOf(way);
  for (std::size_t i = 0; i < this->fans_[at.fan].branches.size(); ++i)
  {
    const auto found = this->ways_.find({ at.fan, this->fans_[at.fan].acrossLarger(at.branch) });
    if (found == this->ways_.end())
    {
      return {};
    }
    if (!this->isLoop(found->second.arc))
    {
      return found->second;
    }
    at = this->endOf(found->second);
  }
  return {};
}

/// The ways from an arc on round larger values until it comes again; empty if it does not.
std::vector<Way> ArcJoining::follow(std::size_t arc) const
{
  std::vector<Way> ways{ { arc, false } };
  for (std::size_t i = 0; i < this->ways_.size(); ++i)
  {
    const std::optional<Way> next = this->next(ways.back());
    if (!next || this->isJoined_[next->arc])
    {
      return {};
    }
    if (next->arc == arc)
    {
      return next->isReversed ? std::vector<Way>() : ways;
    }
    ways.push_back(*next);
  }
  return {};
}

TracedCurve ArcJoining::loopOf(const std::vector<Way>& ways) const
{
  TracedCurve loop;
  loop.closed = true;
  for (const Way& way : ways)
  {
    TracedCurve curve = this->arcs_[way.arc].curve;
    if (way.isReversed)
    {
      reverse(curve);
    }
    loop.corners.push_back(loop.points.size());
    loop.points.insert(loop.points.end(), curve.points.begin(), curve.points.end() - 1);
    loop.tangents.insert(loop.tangents.end(), curve.tangents.begin(), curve.tangents.end() - 1);
    loop.steps.insert(loop.steps.end(), curve.steps.begin(), curve.steps.end() - 1);
  }
  return loop;
}

std::vector<TracedCurve> ArcJoining::join()
{
  std::vector<TracedCurve> curves;
  for (std::size_t arc = 0; arc < this->arcs_.size(); ++arc)
  {
    if (this->isJoined_[arc])
    {
      continue;
    }
    std::vector<Way> ways;
    if (this->isLoop(arc))
    {
      ways = { { arc, false } };
    }
    else if (this->arcs_[arc].to)
    {
      ways = this->follow(arc);
    }
    for (const Way& way : ways)
    {
      this->isJoined_[way.arc] = true;
    }
    curves.push_back(ways.empty() ? this->arcs_[arc].curve : this->loopOf(ways));
  }
  return curves;
}

} // namespace

std::vector<TracedCurve> joinArcs(
  const std::vector<SaddleFan>& fans, const std::vector<SaddleArc>& arcs)
{
  return ArcJoining(fans, arcs).join();
}

} // namespace SurfaceScalars
