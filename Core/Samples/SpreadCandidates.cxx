#include "SpreadCandidates.h"

#include "FarthestPoints.h"

namespace SurfaceScalars
{

SpreadCandidates::SpreadCandidates(const Points& vertices, const std::vector<Index>& candidates)
  : vertices_(vertices)
  , candidates_(candidates)
  , places_(vertices(Eigen::all, candidates))
  , tree_(this->places_, { 1, {} })
{
}

void SpreadCandidates::choose(std::vector<Index>& chosen, std::size_t first, double apart,
  double apartFromOthers, std::size_t count) const
{
  std::vector<char> isTaken(this->candidates_.size(), 0);
  for (std::size_t i = 0; i < chosen.size(); ++i)
  {
    this->take(chosen[i], i < first ? apartFromOthers : apart, isTaken);
  }
  for (std::size_t i = 0; i < isTaken.size() && chosen.size() < count; ++i)
  {
    if (isTaken[i] == 0)
    {
      chosen.push_back(this->candidates_[i]);
      this->take(chosen.back(), apart, isTaken);
    }
  }
}

/// Takes all candidates closer than `radius`.
void SpreadCandidates::take(Index vertex, double radius, std::vector<char>& isTaken) const
{
  std::vector<Index> near;
  this->tree_.gather(this->vertices_.col(vertex), radius, isTaken.size(), near);
  for (const Index candidate : near)
  {
    isTaken[candidate] = 1;
  }
}

} // namespace SurfaceScalars
