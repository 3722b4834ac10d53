#include "CriticalScore.h"

#include <algorithm>
#include <cmath>

namespace SurfaceScalars::Truth
{
namespace
{

struct Pair
{
  double distance;
  std::size_t found;
  std::size_t exact;
};

std::vector<Pair> possiblePairs(
  const std::vector<CriticalPoint>& found, const std::vector<CriticalPoint>& exact, double radius)
{
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    for (std::size_t j = 0; j < exact.size(); ++j)
    {
      const double distance = (found[i].position - exact[j].position).norm();
      if (distance <= radius && found[i].type == exact[j].type &&
        found[i].multiplicity == exact[j].multiplicity)
      {
        pairs.push_back({ distance, i, j });
      }
    }
  }
  std::sort(pairs.begin(), pairs.end(),
    [](const Pair& a, const Pair& b) { return a.distance < b.distance; });
  return pairs;
}

} // namespace

double CriticalScore::precision() const
{
  return this->foundCount == 0 ? 1.0 : static_cast<double>(this->rightCount) / this->foundCount;
}

double CriticalScore::recall() const
{
  return this->exactCount == 0 ? 1.0 : static_cast<double>(this->rightCount) / this->exactCount;
}

double CriticalScore::meanError() const
{
  return this->errorSum / this->rightCount;
}

double CriticalScore::rootMeanSquareError() const
{
  return std::sqrt(this->squaredErrorSum / this->rightCount);
}

CriticalScore CriticalScore::inUnitsOf(double length) const
{
  CriticalScore score = *this;
  score.errorSum /= length;
  score.squaredErrorSum /= length * length;
  score.errorMaximum /= length;
  return score;
}

void CriticalScore::add(const CriticalScore& other)
{
  this->exactCount += other.exactCount;
  this->foundCount += other.foundCount;
  this->uncertainCount += other.uncertainCount;
  this->rightCount += other.rightCount;
  this->errorSum += other.errorSum;
  this->squaredErrorSum += other.squaredErrorSum;
  this->errorMaximum = std::max(this->errorMaximum, other.errorMaximum);
}

// A point outside the judged region may still be the partner of one inside; such a pair is right
// for the one that is judged.
CriticalScore scoreCriticalPoints(const std::vector<CriticalPoint>& found,
  const std::vector<CriticalPoint>& exact, double radius,
  const std::function<bool(const Vector3d&)>& counts)
{
  const auto judged = [&](const CriticalPoint& point) { return !counts || counts(point.position); };
  std::vector<char> foundUsed(found.size(), 0);
  std::vector<char> exactUsed(exact.size(), 0);
  CriticalScore score;
  for (const Pair& pair : possiblePairs(found, exact, radius))
  {
    if (foundUsed[pair.found] != 0 || exactUsed[pair.exact] != 0)
    {
      continue;
    }
    foundUsed[pair.found] = 1;
    exactUsed[pair.exact] = 1;
    if (judged(found[pair.found]) || judged(exact[pair.exact]))
    {
      ++score.rightCount;
      score.errorSum += pair.distance;
      score.squaredErrorSum += pair.distance * pair.distance;
      score.errorMaximum = std::max(score.errorMaximum, pair.distance);
    }
  }
  score.foundCount = score.rightCount;
  score.exactCount = score.rightCount;
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    if (foundUsed[i] == 0 && judged(found[i]))
    {
      ++(found[i].type == CriticalType::Uncertain ? score.uncertainCount : score.foundCount);
    }
  }
  for (std::size_t j = 0; j < exact.size(); ++j)
  {
    score.exactCount += exactUsed[j] == 0 && judged(exact[j]) ? 1 : 0;
  }
  return score;
}

double unambiguousRadius(const std::vector<CriticalPoint>& points)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      nearest = std::min(nearest, (points[i].position - points[j].position).norm());
    }
  }
  return 0.25 * nearest;
}

} // namespace SurfaceScalars::Truth
