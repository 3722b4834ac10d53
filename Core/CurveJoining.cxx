#include "CurveJoining.h"

#include "Polyline.h"

#include <algorithm>
#include <cmath>

namespace SurfaceScalars
{
namespace
{

constexpr double LargestGap = 1.5; // in widened sampling steps
constexpr double SmallestGap = 0.2;
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

std::vector<End> freeEnds(const std::vector<TracedCurve>& curves)
{
  std::vector<End> ends;
  for (std::size_t i = 0; i < curves.size(); ++i)
  {
    const TracedCurve& curve = curves[i];
    if (!curve.closed && !curve.startsAtSaddle)
    {
      ends.push_back(
        { i, false, curve.points.front().position, -curve.tangents.front(), curve.steps.front() });
    }
    if (!curve.closed && !curve.endsAtSaddle)
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
  for (std::size_t a = 0; a < ends.size(); ++a)
  {
    for (std::size_t b = a + 1; b < ends.size(); ++b)
    {
      const bool same = ends[a].curve == ends[b].curve;
      if (fit(ends[a], ends[b]) && (!same || curves[ends[a].curve].points.size() > 6))
      {
        pairs.push_back({ (ends[a].position - ends[b].position).norm(), a, b });
      }
    }
  }
  std::sort(pairs.begin(), pairs.end(),
    [](const Pair& a, const Pair& b) { return a.distance < b.distance; });
  return pairs;
}

/// The same curve the other way round: with the other side of the surface up, so that larger values
/// stay to the left.
void reverse(TracedCurve& curve)
{
  std::reverse(curve.points.begin(), curve.points.end());
  std::reverse(curve.tangents.begin(), curve.tangents.end());
  std::reverse(curve.steps.begin(), curve.steps.end());
  std::swap(curve.startsAtSaddle, curve.endsAtSaddle);
  for (LevelSetPoint& point : curve.points)
  {
    point.normal = -point.normal;
  }
  for (Vector3d& tangent : curve.tangents)
  {
    tangent = -tangent;
  }
}

/// Drops points at the end of a curve that lie beyond the beginning of the next: the join would fold back.
void trimEnd(TracedCurve& curve, const Vector3d& next)
{
  while (curve.points.size() > 2 &&
    (next - curve.points.back().position).dot(curve.tangents.back()) <
      SmallestGap * curve.steps.back())
  {
    curve.points.pop_back();
    curve.tangents.pop_back();
    curve.steps.pop_back();
  }
}

void append(TracedCurve& curve, const TracedCurve& tail)
{
  trimEnd(curve, tail.points.front().position);
  curve.points.insert(curve.points.end(), tail.points.begin(), tail.points.end());
  curve.tangents.insert(curve.tangents.end(), tail.tangents.begin(), tail.tangents.end());
  curve.steps.insert(curve.steps.end(), tail.steps.begin(), tail.steps.end());
  curve.endsAtSaddle = tail.endsAtSaddle;
}

} // namespace

std::vector<TracedCurve> joinEnds(std::vector<TracedCurve> curves)
{
  // Each join changes the ends: few are needed, so they are found anew.
  for (;;)
  {
    const std::vector<End> ends = freeEnds(curves);
    const std::vector<Pair> pairs = fittingPairs(curves, ends);
    if (pairs.empty())
    {
      return curves;
    }
    const End& a = ends[pairs.front().a];
    const End& b = ends[pairs.front().b];
    TracedCurve& first = curves[a.curve];
    if (a.curve == b.curve)
    {
      trimEnd(first, first.points.front().position);
      first.closed = true;
      continue;
    }
    TracedCurve& second = curves[b.curve];
    if (!a.isBack)
    {
      reverse(first);
    }
    if (b.isBack)
    {
      reverse(second);
    }
    append(first, second);
    curves.erase(curves.begin() + static_cast<std::ptrdiff_t>(b.curve));
  }
}

} // namespace SurfaceScalars
