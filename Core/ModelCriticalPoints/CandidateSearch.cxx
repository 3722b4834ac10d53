#include "CandidateSearch.h"

#include "ChartPrediction.h"
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
  CandidateSearch(const ModelOnMesh& model, const CriticalPoint& candidate, SearchStage stage,
    const Poll& poll, Arrivals& arrivals)
    : model_(model)
    , newton_(model.vertices, model.mesh, model.values, model.u, model.tolerance)
    , vertex_(static_cast<Index>(candidate.input))
    , type_(candidate.type)
    , stage_(stage)
    , poll_(poll)
    , arrivals_(arrivals)
  {
    if (stage == SearchStage::Certain) // which is the first
    {
      this->arrivals_.residual = this->newton_.residualAt(this->vertex_);
    }
  }

  void search(int wanted)
  {
    this->wanted_ = this->arrivals_.found.size() + static_cast<std::size_t>(wanted);
    if (this->stage_ == SearchStage::Certain)
    {
      this->onNearestCharts();
    }
    const std::size_t begin = this->stage_ == SearchStage::Certain ? 0 : 1;
    const std::size_t end = this->stage_ == SearchStage::Certain ? 1 : MeshChart::MostFits;
    for (std::size_t rank = begin; rank < end; ++rank)
    {
      this->onChart(this->vertex_, rank);
    }
    for (std::size_t rank = begin; rank < end; ++rank)
    {
      for (const Index neighbor : this->model_.mesh.link(this->vertex_))
      {
        this->onChart(neighbor, rank);
      }
    }
  }

private:
  bool goesOn() const
  {
    return this->arrivals_.found.size() < this->wanted_ && this->arrivals_.steps < MostSearchSteps;
  }

  std::vector<Vector3d> predictions()
  {
    return predictedPlaces(this->model_.vertices, this->model_.mesh, this->newton_.chart(),
      this->type_, this->model_.vertices.col(this->vertex_));
  }

  /// From what the vertex' own chart predicts, on the charts of the vertices next to there.
  void onNearestCharts()
  {
    if (!this->newton_.enter(this->vertex_))
    {
      return;
    }
    for (const Vector3d& place : this->predictions())
    {
      if (this->goesOn() && this->newton_.enter(this->newton_.chart().nearestVertex(place)))
      {
        this->searchFrom(place);
      }
    }
  }

  void onChart(Index vertex, std::size_t rank)
  {
    if (!this->goesOn() || !this->newton_.enter(vertex) || rank >= this->newton_.chart().fitCount())
    {
      return;
    }
    this->poll_();
    this->newton_.chart().choose(rank);
    for (const Vector3d& place : this->predictions())
    {
      if (this->goesOn())
      {
        this->searchFrom(place);
      }
    }
  }

  void searchFrom(const Vector3d& place)
  {
    const SearchEffort effort{ MostSearchSteps - this->arrivals_.steps };
    const SurfaceSearch search = this->newton_.search(place, this->type_, effort, this->poll_);
    ++this->arrivals_.searches;
    this->arrivals_.steps += search.stepCount();
    const auto isKnown = [&](const Arrival& other) { return isSame(search, other.search); };
    std::vector<Arrival>& found = this->arrivals_.found;
    if (search.isCritical && search.isOnMesh && typeOf(search.restricted.hessian) == this->type_ &&
      std::none_of(found.begin(), found.end(), isKnown))
    {
      found.push_back({ search, this->arrivals_.steps, this->stage_ });
      this->arrivals_.steps = 0;
    }
  }

  const ModelOnMesh& model_;
  SurfaceNewton newton_;
  Index vertex_;
  CriticalType type_;
  SearchStage stage_;
  const Poll& poll_;
  Arrivals& arrivals_;
  std::size_t wanted_ = 0;
};

} // namespace

double reachOf(const SurfaceSearch& search)
{
  return SamePlace * search.spacing;
}

void searchFromAll(const ModelOnMesh& model, const std::vector<CriticalPoint>& candidates,
  SearchStage stage, const std::vector<int>& wanted, std::vector<Arrivals>& arrivals,
  const Execution& execution)
{
  parallelForEach(candidates.size(), execution,
    [&](std::size_t i, const Poll& poll)
    {
      if (wanted[i] == 0)
      {
        return;
      }
      CandidateSearch search(model, candidates[i], stage, poll, arrivals[i]);
      if (!model.mesh.isBoundary(static_cast<Index>(candidates[i].input)) && model.tolerance > 0.0)
      {
        search.search(wanted[i]);
      }
    });
}

} // namespace SurfaceScalars
