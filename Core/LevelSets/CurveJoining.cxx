#include "CurveJoining.h"

#include "PointTree.h"

#include <algorithm>
#include <cmath>

namespace SurfaceScalars
{
void reverse(TracedCurve& curve)
{
  std::reverse(curve.points.begin(), curve.points.end());
  std::reverse(curve.tangents.begin(), curve.tangents.end());
  std::reverse(curve.steps.begin(), curve.steps.end());
  std::swap(curve.start, curve.end);
  for (LevelSetPoint& point : curve.points)
  {
    point.normal = -point.normal;
  }
  for (Vector3d& tangent : curve.tangents)
  {
    tangent = -tangent;
  }
}

namespace
{

constexpr double LargestGap = 1.5; // in widened sampling steps
constexpr double SmallestGap = 0.2;
constexpr double SmallestCosine = 0.7; // of the angles between the curves and the way across
constexpr std::size_t FewestInLoop = 6;
constexpr int MostTrimmed = 16; // points, to make that so
constexpr double LargestOverlap = 0.5;
constexpr double LargestTurn = 1.05; // angle between the curves and across the gap

/// One end of an open curve.
struct End
{
  std::size_t curve;
  bool isBack;
  Vector3d position;
  Vector3d outwards;
  double step;
};

/// Two ends that fit, by their distance.
struct Pair
{
  double distance;
  std::size_t a;
  std::size_t b;
};

std::vector<End> lostEnds(const std::vector<TracedCurve>& curves)
{
  std::vector<End> ends;
  for (std::size_t i = 0; i < curves.size(); ++i)
  {
    const TracedCurve& curve = curves[i];
    if (!curve.closed && curve.start == CurveEnd::Lost)
    {
      ends.push_back(
        { i, false, curve.points.front().position, -curve.tangents.front(), curve.steps.front() });
    }
    if (!curve.closed && curve.end == CurveEnd::Lost)
    {
      ends.push_back(
        { i, true, curve.points.back().position, curve.tangents.back(), curve.steps.back() });
    }
  }
  return ends;
}

bool fit(const End& a, const End& b)
{
  const Vector3d gap = b.position - a.position;
  const double distance = gap.norm();
  const double along = 0.5 * (gap.dot(a.outwards) - gap.dot(b.outwards));
  const double across = std::sqrt(std::max(0.0, distance * distance - along * along));
  return distance <= LargestGap * a.step && along >= -LargestOverlap * a.step &&
    across <= 0.5 * a.step && a.outwards.dot(b.outwards) < -std::cos(LargestTurn);
}

std::vector<Pair> fittingPairs(const std::vector<TracedCurve>& curves, const std::vector<End>& ends)
{
  std::vector<Pair> pairs;
  if (ends.empty())
  {
    return pairs;
  }
  Points positions(3, static_cast<Eigen::Index>(ends.size()));
  for (std::size_t i = 0; i < ends.size(); ++i)
  {
    positions.col(static_cast<Eigen::Index>(i)) = ends[i].position;
  }
  const PointTree tree(positions);
  Neighborhood near;
  for (std::size_t a = 0; a < ends.size(); ++a)
  {
    tree.within(ends[a].position, LargestGap * ends[a].step, near);
    for (const Index b : near.indices)
    {
      const bool same = ends[a].curve == ends[b].curve;
      if (a < b && fit(ends[a], ends[b]) &&
        (!same || curves[ends[a].curve].points.size() > FewestInLoop))
      {
        pairs.push_back({ (ends[a].position - ends[b].position).norm(), a, b });
      }
    }
  }
  std::sort(pairs.begin(), pairs.end(),
    [](const Pair& a, const Pair& b) { return a.distance < b.distance; });
  return pairs;
}

/// Whether a way from one tangent to another is neither backwards nor a kink.
bool isSmooth(const Vector3d& from, const Vector3d& way, const Vector3d& to, double step)
{
  const double length = way.norm();
  return length >= SmallestGap * step && way.dot(from) >= SmallestCosine * length &&
    way.dot(to) >= SmallestCosine * length;
}

/// Drops points at the end of a curve until the way to the beginning of the next is smooth: the two
/// may overlap a little.
/// @returns whether that can be done
bool trimEnd(TracedCurve& curve, const Vector3d& next, const Vector3d& nextTangent)
{
  for (int i = 0; i < MostTrimmed && curve.points.size() > 3; ++i)
  {
    if (isSmooth(curve.tangents.back(), next - curve.points.back().position, nextTangent,
          curve.steps.back()))
    {
      return true;
    }
    curve.points.pop_back();
    curve.tangents.pop_back();
    curve.steps.pop_back();
  }
  return false;
}

bool append(TracedCurve& curve, const TracedCurve& tail)
{
  if (!trimEnd(curve, tail.points.front().position, tail.tangents.front()))
  {
    return false;
  }
  curve.points.insert(curve.points.end(), tail.points.begin(), tail.points.end());
  curve.tangents.insert(curve.tangents.end(), tail.tangents.begin(), tail.tangents.end());
  curve.steps.insert(curve.steps.end(), tail.steps.begin(), tail.steps.end());
  curve.end = tail.end;
  return true;
}

/// Joins two ends, if that can be done without a kink; the second curve is then empty.
bool join(std::vector<TracedCurve>& curves, const End& a, const End& b)
{
  TracedCurve first = curves[a.curve];
  if (a.curve == b.curve)
  {
    first.closed = trimEnd(first, first.points.front().position, first.tangents.front());
  }
  else
  {
    TracedCurve second = curves[b.curve];
    if (!a.isBack)
    {
      reverse(first);
    }
    if (b.isBack)
    {
      reverse(second);
    }
    if (!append(first, second))
    {
      return false;
    }
    curves[b.curve].points.clear();
  }
  if (a.curve == b.curve && !first.closed)
  {
    return false;
  }
  curves[a.curve] = std::move(first);
  return true;
}

} // namespace

std::vector<TracedCurve> joinEnds(std::vector<TracedCurve> curves)
{
  // A join changes the ends of its curves: each curve is joined once a round.
  for (bool joined = true; joined;)
  {
    joined = false;
    std::vector<bool> changed(curves.size(), false);
    const std::vector<End> ends = lostEnds(curves);
    for (const Pair& pair : fittingPairs(curves, ends))
    {
      const End& a = ends[pair.a];
      const End& b = ends[pair.b];
      if (!changed[a.curve] && !changed[b.curve] && join(curves, a, b))
      {
        joined = changed[a.curve] = changed[b.curve] = true;
      }
    }
    curves.erase(std::remove_if(curves.begin(), curves.end(),
                   [](const TracedCurve& curve) { return curve.points.empty(); }),
      curves.end());
  }
  return curves;
}

} // namespace SurfaceScalars
