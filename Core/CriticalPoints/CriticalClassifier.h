#pragma once

#include "CriticalRing.h"
#include "CriticalTrust.h"

#include <optional>
#include <vector>

namespace SurfaceScalars
{

struct TypedPoint
{
  RefinedPoint point;
  CriticalType type = CriticalType::Uncertain;
  int multiplicity = 1;
  double extent = 0.0; ///< how far places may lie that are parts of it, length
};

inline int indexOf(const TypedPoint& point)
{
  return indexOf(point.type, point.multiplicity);
}

/**
 * Types groups of places that may be parts of one critical point. Not for several threads at once.
 */
class CriticalClassifier
{
public:
  CriticalClassifier(const std::vector<RefinedPoint>& points, const SurePoints& sure,
    const Trust& trust, const CriticalScale& scale)
    : points_(points)
    , sure_(sure)
    , trust_(trust)
    , model_(scale)
  {
  }

  /// @param group indices of points: a sure one alone, or doubtful ones close to each other
  std::vector<TypedPoint> classify(const std::vector<std::size_t>& group);

private:
  /// What a ring is found to enclose.
  struct Enclosed
  {
    Ring ring;
    RingCount count;
  };

  std::vector<TypedPoint> byHessian(const std::vector<std::size_t>& group) const;
  std::optional<Enclosed> countAround(const std::vector<std::size_t>& group);
  std::vector<TypedPoint> byRing(const std::vector<std::size_t>& group, const Enclosed& enclosed);
  std::optional<RefinedPoint> mostCentral(
    const std::vector<std::size_t>& group, const Enclosed& enclosed) const;

  const std::vector<RefinedPoint>& points_;
  const SurePoints& sure_;
  const Trust& trust_;
  CriticalModel model_;
};

} // namespace SurfaceScalars
