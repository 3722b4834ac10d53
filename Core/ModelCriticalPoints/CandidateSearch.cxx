#include "CandidateSearch.h"

#include "SurfaceRestriction.h"

#include <algorithm>
#include <cstddef>

namespace SurfaceScalars
{
namespace
{

constexpr double SamePlace = 0.1; // of two points, in spacings of the mesh

bool isSame(const SurfaceSearch& one, const SurfaceSearch& other)
{
  return (one.place - other.place).norm() <= std::max(reachOf(one), reachOf(other));
}

class CandidateSearch
{
public:
  CandidateSearch(
    const PointsRef& vertices, const MeshTopology& mesh, const Field& u, double tolerance)
    : vertices_(vertices)
    , mesh_(mesh)
    , newton_(vertices, mesh, u, { tolerance })
    , isConstant_(tolerance == 0.0)
  {
  }

  Arrivals from(const CriticalPoint& candidate, const Poll& poll)
  {
    const auto vertex = static_cast<Index>(candidate.input);
    Arrivals arrivals;
    arrivals.residual = this->newton_.residualAt(vertex);
    if (this->mesh_.isBoundary(vertex) || this->isConstant_)
    {
      return arrivals;
    }
    this->steps_ = 0;
    const auto wanted = static_cast<std::size_t>(candidate.multiplicity);
    const auto search = [&](Index start, ChartChoice charts)
    {
      if (arrivals.found.size() < wanted)
      {
        this->add(start, candidate.type, charts, poll, arrivals);
      }
    };
    search(vertex, ChartChoice::Nearest);
    search(vertex, ChartChoice::First);
    for (const Index neighbor : this->mesh_.link(vertex))
    {
      search(neighbor, ChartChoice::Nearest);
    }
    return arrivals;
  }

private:
  void add(Index start, CriticalType type, ChartChoice charts, const Poll& poll, Arrivals& arrivals)
  {
    const SurfaceSearch search =
      this->newton_.search(this->vertices_.col(start), start, type, charts, poll);
    this->steps_ += search.stepCount();
    const auto isKnown = [&](const Arrival& other) { return isSame(search, other.search); };
    if (search.isCritical && search.isOnMesh && typeOf(search.restricted.hessian) == type &&
      std::none_of(arrivals.found.begin(), arrivals.found.end(), isKnown))
    {
      arrivals.found.push_back({ search, this->steps_ });
      this->steps_ = 0;
    }
  }

  PointsRef vertices_;
  const MeshTopology& mesh_;
  SurfaceNewton newton_;
  bool isConstant_;
  int steps_ = 0; ///< since something was found
};

} // namespace

double reachOf(const SurfaceSearch& search)
{
  return SamePlace * search.spacing;
}

std::vector<Arrivals> searchFromAll(const PointsRef& vertices, const MeshTopology& mesh,
  const Field& u, const std::vector<CriticalPoint>& candidates, double tolerance,
  const Execution& execution)
{
  std::vector<Arrivals> arrivals(candidates.size());
  parallelForEach(candidates.size(), execution,
    [&](std::size_t i, const Poll& poll)
    {
      const CriticalPoint& candidate = candidates[i];
      arrivals[i] = CandidateSearch(vertices, mesh, u, tolerance).from(candidate, poll);
    });
  return arrivals;
}

} // namespace SurfaceScalars
