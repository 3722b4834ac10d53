#include "LevelSetCenters.h"

#include "CrossedCells.h"
#include "FarthestPoints.h"
#include "LevelSetCoverage.h"
#include "Quantile.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace SurfaceScalars
{
namespace
{

constexpr std::size_t CandidatesPerCenter = 16;
constexpr std::size_t FurtherPerCenter = 3;
constexpr double SmallestUncovered = 0.25; // share from which on it gets centers

/// Where level sets cross the edges of simplices, one after the other.
class Crossings
{
public:
  Crossings(const ApproximationDomain& domain, const ValuesRef& values, const Values& isoValues)
    : domain_(domain)
    , values_(values)
    , isoValues_(isoValues)
  {
  }

  /// At most `most` of all, at even steps.
  PlacedValues some(std::size_t most, const Execution& execution) const
  {
    std::size_t all = 0;
    this->forEachEdge(execution.part(0.0, 0.5),
      [&](Index, Index, const double* first, const double* last)
      { all += static_cast<std::size_t>(last - first); });
    const std::size_t count = std::min(all, most);
    PlacedValues result{ Points(3, static_cast<Eigen::Index>(count)),
      Values(static_cast<Eigen::Index>(count)) };
    std::size_t passed = 0;
    std::size_t taken = 0;
    this->forEachEdge(execution.part(0.5, 1.0),
      [&](Index a, Index b, const double* first, const double* last)
      {
        const std::size_t end = passed + static_cast<std::size_t>(last - first);
        for (; taken < count && siteOf(taken, count, all) < end; ++taken)
        {
          const double level = first[siteOf(taken, count, all) - passed];
          const auto place = static_cast<Eigen::Index>(taken);
          result.places.col(place) = crossingOf(this->domain_.vertices, this->values_, a, b, level);
          result.values[place] = level;
        }
        passed = end;
      });
    return result;
  }

private:
  /// Of each simplex, its lower end first, with the iso-values from there to the other, which does
  /// not count.
  template <class Visit>
  void forEachEdge(const Execution& execution, const Visit& visit) const
  {
    const auto corners = this->domain_.simplices.rows();
    const double* begin = this->isoValues_.data();
    const double* end = begin + this->isoValues_.size();
    for (Eigen::Index simplex = 0; simplex < this->domain_.simplices.cols(); ++simplex)
    {
      if (simplex % 4096 == 0)
      {
        execution.report(
          static_cast<double>(simplex) / static_cast<double>(this->domain_.simplices.cols()));
      }
      for (Eigen::Index i = 0; i < corners; ++i)
      {
        for (Eigen::Index j = 0; j < corners; ++j)
        {
          const Index a = this->domain_.simplices(i, simplex);
          const Index b = this->domain_.simplices(j, simplex);
          if (this->values_[a] < this->values_[b])
          {
            const double* first = std::lower_bound(begin, end, this->values_[a]);
            visit(a, b, first, std::lower_bound(first, end, this->values_[b]));
          }
        }
      }
    }
  }

  const ApproximationDomain& domain_;
  const ValuesRef& values_;
  const Values& isoValues_;
};

/// The corners of simplices that no level set meets.
std::vector<Index> uncoveredVertices(
  const ApproximationDomain& domain, const std::vector<char>& covered)
{
  std::vector<Index> result;
  for (std::size_t i = 0; i < covered.size(); ++i)
  {
    if (covered[i] == 0)
    {
      const auto corners = domain.simplices.col(static_cast<Eigen::Index>(i));
      result.insert(result.end(), corners.begin(), corners.end());
    }
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

/// Adds some of the candidates, spread over all and apart from the centers that are there.
void addSpread(
  CenterSet& centers, const PlacedValues& candidates, std::size_t count, const Execution& execution)
{
  const std::vector<Index> chosen =
    farthestPoints(candidates.places, centers.places, count, execution).chosen;
  const Eigen::Index before = centers.values.size();
  const auto added = static_cast<Eigen::Index>(chosen.size());
  centers.places.conservativeResize(Eigen::NoChange, before + added);
  centers.values.conservativeResize(before + added);
  centers.places.rightCols(added) = candidates.places(Eigen::all, chosen);
  centers.values.tail(added) = candidates.values(chosen);
}

PlacedValues atVertices(
  const ApproximationDomain& domain, const ValuesRef& values, const std::vector<Index>& vertices)
{
  return { domain.vertices(Eigen::all, vertices), values(vertices) };
}

} // namespace

ChosenCenters levelSetCenters(const ApproximationDomain& domain, const ValuesRef& values,
  const std::vector<Index>& stars, std::size_t count, double tolerance, const Execution& execution)
{
  const LevelSetCoverage coverage = levelSetCoverage(
    domain.vertices, domain.simplices, values, tolerance, execution.part(0.0, 0.1));
  const std::size_t free = count - stars.size();
  const PlacedValues candidates = Crossings(domain, values, coverage.isoValues)
                                    .some(CandidatesPerCenter * free, execution.part(0.1, 0.4));
  const double uncovered = 1.0 - coverage.global();
  const std::size_t between = uncovered < SmallestUncovered
    ? 0
    : static_cast<std::size_t>(std::round(uncovered * static_cast<double>(free)));

  const PlacedValues ofStars = atVertices(domain, values, stars);
  CenterSet centers{ ofStars.places, ofStars.values, ofStars.values.size() };
  addSpread(centers, candidates, free - between, execution.part(0.4, 0.8));
  if (between > 0)
  {
    const std::vector<Index> flat = uncoveredVertices(domain, coverage.covered);
    const PlacedValues flatValues = atVertices(domain, values, flat);
    const std::vector<Index> even =
      evenSubset(flatValues.places, CandidatesPerCenter * between, execution.part(0.8, 0.8));
    addSpread(centers, { flatValues.places(Eigen::all, even), flatValues.values(even) }, between,
      execution.part(0.8, 1.0));
  }
  std::vector<Index> further(static_cast<std::size_t>(candidates.values.size()));
  std::iota(further.begin(), further.end(), Index(0));
  further = evenPart(further, FurtherPerCenter * free);
  return { std::move(centers),
    { candidates.places(Eigen::all, further), candidates.values(further) } };
}

} // namespace SurfaceScalars
