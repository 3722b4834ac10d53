#include "SimplificationCurve.h"

#include <algorithm>

namespace SurfaceScalars
{
namespace
{

/// The thresholds at which critical points vanish, those of each kind ascending.
class Survival
{
public:
  void add(CriticalType type, double threshold, int multiplicity = 1)
  {
    std::vector<double>& ofKind = type == CriticalType::Minimum ? this->minima_
      : type == CriticalType::Saddle                            ? this->saddles_
                                                                : this->maxima_;
    ofKind.insert(ofKind.end(), static_cast<std::size_t>(multiplicity), threshold);
  }

  void sort()
  {
    for (std::vector<double>* ofKind : { &this->minima_, &this->saddles_, &this->maxima_ })
    {
      std::sort(ofKind->begin(), ofKind->end());
    }
  }

  CriticalCounts atLeast(double threshold) const
  {
    return this->count([=](const std::vector<double>& ofKind)
      { return std::lower_bound(ofKind.begin(), ofKind.end(), threshold); });
  }

  CriticalCounts above(double threshold) const
  {
    return this->count([=](const std::vector<double>& ofKind)
      { return std::upper_bound(ofKind.begin(), ofKind.end(), threshold); });
  }

private:
  template <class First>
  CriticalCounts count(const First& firstOf) const
  {
    const auto left = [&](const std::vector<double>& ofKind)
    { return static_cast<Index>(ofKind.end() - firstOf(ofKind)); };
    return { left(this->minima_), left(this->saddles_), left(this->maxima_) };
  }

  std::vector<double> minima_;
  std::vector<double> saddles_;
  std::vector<double> maxima_;
};

Survival deltaSurvival(const MeshCriticalPoints& critical, const ValuesRef& deltas)
{
  Survival survival;
  for (const CriticalPoint& point : critical.points)
  {
    survival.add(point.type, deltas[static_cast<Eigen::Index>(point.input)], point.multiplicity);
  }
  survival.sort();
  return survival;
}

Survival persistenceSurvival(const MeshCriticalPoints& critical)
{
  Survival survival;
  std::vector<int> left;
  left.reserve(critical.points.size());
  for (const CriticalPoint& point : critical.points)
  {
    left.push_back(point.multiplicity);
  }
  for (const CriticalPair& pair : critical.pairs)
  {
    --left[pair.saddle];
    survival.add(CriticalType::Saddle, pair.persistence);
  }
  for (std::size_t i = 0; i < left.size(); ++i)
  {
    survival.add(critical.points[i].type, critical.points[i].persistence, left[i]);
  }
  survival.sort();
  return survival;
}

} // namespace

SimplificationCurve simplificationCurve(const MeshCriticalPoints& critical, const ValuesRef& deltas,
  double range, const std::vector<double>& thresholds)
{
  const Survival byDelta = deltaSurvival(critical, deltas);
  const Survival byPersistence = persistenceSurvival(critical);
  SimplificationCurve curve;
  curve.thresholds = thresholds;
  for (const double fraction : thresholds)
  {
    const double threshold = fraction * range;
    curve.byDelta.push_back(threshold > 0.0 ? byDelta.above(threshold) : byDelta.atLeast(0.0));
    curve.byPersistence.push_back(byPersistence.atLeast(threshold));
  }
  return curve;
}

} // namespace SurfaceScalars
