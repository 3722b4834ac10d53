#include "SampleThreading.h"

#include "PointTree.h"
#include "Polyline.h"

#include <algorithm>
#include <limits>

namespace SurfaceScalars
{
namespace
{

// In widened sampling steps.
constexpr double ThreadedDistance = 0.75;
constexpr double SmallestSpacing = 0.5;

/// Where a sample belongs.
struct Attachment
{
  double distance = std::numeric_limits<double>::infinity();
  std::size_t curve = 0;
  std::size_t segment = 0;
  double along = 0.0; ///< arc length on the curve
};

/// Each sample to the closest segment of the closest curve.
std::vector<Attachment> attach(
  const std::vector<TracedCurve>& curves, const std::vector<LevelSetPoint>& samples)
{
  const Points positions = positionsOf(samples);
  const PointTree tree(positions);
  std::vector<Attachment> attachments(samples.size());
  Neighborhood near;
  for (std::size_t c = 0; c < curves.size(); ++c)
  {
    const TracedCurve& curve = curves[c];
    const std::size_t count = curve.points.size();
    double length = 0.0;
    for (std::size_t i = 0; i + (curve.closed ? 0 : 1) < count; ++i)
    {
      const Vector3d& from = curve.points[i].position;
      const Vector3d& to = curve.points[(i + 1) % count].position;
      const Vector3d along = to - from;
      const double reach = ThreadedDistance * curve.steps[i];
      tree.within(0.5 * (from + to), 0.5 * along.norm() + reach, near);
      for (const Index sample : near.indices)
      {
        const Vector3d place = positions.col(sample);
        const double distance = distanceToSegment(place, from, to);
        if (distance <= reach && distance < attachments[sample].distance)
        {
          attachments[sample] = { distance, c, i,
            length + std::clamp((place - from).dot(along) / along.norm(), 0.0, along.norm()) };
        }
      }
      length += along.norm();
    }
  }
  return attachments;
}

/// A point of a curve to be: a sample, or a saddle that the curve passes.
struct Bead
{
  Attachment at;
  LevelSetPoint point;
  bool isSaddle;
};

/// The saddles of a curve.
std::vector<Bead> saddlesOf(const std::vector<TracedCurve>& curves, std::size_t c)
{
  const TracedCurve& curve = curves[c];
  std::vector<Bead> saddles;
  double length = 0.0;
  for (std::size_t i = 0; i < curve.points.size(); ++i)
  {
    length += i > 0 ? (curve.points[i].position - curve.points[i - 1].position).norm() : 0.0;
    const bool isEnd = !curve.closed &&
      ((i == 0 && curve.start == CurveEnd::Saddle) ||
        (i + 1 == curve.points.size() && curve.end == CurveEnd::Saddle));
    if (isEnd || std::binary_search(curve.corners.begin(), curve.corners.end(), i))
    {
      saddles.push_back({ { 0.0, c, i, length }, curve.points[i], true });
    }
  }
  return saddles;
}

/// All beads, curve by curve and along each.
std::vector<Bead> beadsOf(
  const std::vector<TracedCurve>& curves, const std::vector<LevelSetPoint>& samples)
{
  const std::vector<Attachment> attachments = attach(curves, samples);
  std::vector<Bead> beads;
  for (std::size_t c = 0; c < curves.size(); ++c)
  {
    const std::vector<Bead> saddles = saddlesOf(curves, c);
    beads.insert(beads.end(), saddles.begin(), saddles.end());
  }
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    if (attachments[i].distance < std::numeric_limits<double>::infinity())
    {
      beads.push_back({ attachments[i], samples[i], false });
    }
  }
  std::sort(beads.begin(), beads.end(),
    [](const Bead& a, const Bead& b)
    {
      const Attachment& left = a.at;
      const Attachment& right = b.at;
      return left.curve != right.curve ? left.curve < right.curve : left.along < right.along;
    });
  return beads;
}

} // namespace

std::vector<TracedCurve> threadSamples(
  const std::vector<TracedCurve>& curves, const std::vector<LevelSetPoint>& samples)
{
  if (curves.empty())
  {
    return {};
  }
  std::vector<TracedCurve> threaded(curves.size());
  std::vector<double> last(curves.size(), -std::numeric_limits<double>::infinity());
  for (const Bead& bead : beadsOf(curves, samples))
  {
    const Attachment& at = bead.at;
    const TracedCurve& curve = curves[at.curve];
    if (!bead.isSaddle && at.along - last[at.curve] < SmallestSpacing * curve.steps[at.segment])
    {
      continue;
    }
    last[at.curve] = at.along;
    LevelSetPoint point = bead.point;
    if (point.normal.dot(curve.points[at.segment].normal) < 0.0)
    {
      point.normal = -point.normal;
    }
    TracedCurve& result = threaded[at.curve];
    if (bead.isSaddle && curve.closed)
    {
      result.corners.push_back(result.points.size());
    }
    result.points.push_back(point);
    result.tangents.push_back(curve.tangents[at.segment]);
    result.steps.push_back(curve.steps[at.segment]);
  }
  for (std::size_t c = 0; c < curves.size(); ++c)
  {
    threaded[c].closed = curves[c].closed;
    threaded[c].start = curves[c].start;
    threaded[c].end = curves[c].end;
    if (threaded[c].points.size() < (curves[c].closed ? 3 : 2))
    {
      threaded[c] = curves[c]; // too short to have samples of its own
    }
  }
  return threaded;
}

} // namespace SurfaceScalars
