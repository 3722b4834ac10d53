#include "FieldChecks.h"
#include "FieldSchemes.h"

#include <algorithm>
#include <cmath>

namespace SurfaceScalars
{
namespace
{

constexpr std::size_t SamplesPerBlock = 64; // of a parallel loop

class HybridScheme : public FieldApproximation
{
public:
  HybridScheme(
    const FieldSamples& samples, const FieldParameters& parameters, const std::vector<char>& marked)
    : marked_(marked)
    , cloud_(samples.cloud)
    , average_(makeExplicitMLS(samples, parameters))
    , interpolant_(makeLocalRBF(samples, parameters))
    , current_(this->average_.get())
  {
  }

  /// Where samples are not marked: these are most.
  Eigen::Index expect(const PointsRef& places) override { return this->average_->expect(places); }

  bool center(const Vector3d& place) override
  {
    this->cloud_.nearest(place, 1, this->nearest_);
    const bool missed = this->marked_[this->nearest_.indices.front()] != 0;
    this->current_ = missed ? this->interpolant_.get() : this->average_.get();
    return this->current_->center(place);
  }
  FieldJet jet(const Vector3d& place, Derivatives derivatives) const override
  {
    return this->current_->jet(place, derivatives);
  }

private:
  const std::vector<char>& marked_;
  const PointCloud& cloud_;
  Neighborhood nearest_;
  std::unique_ptr<FieldApproximation> average_;
  std::unique_ptr<FieldApproximation> interpolant_;
  FieldApproximation* current_;
};

/// e_MLS of sec. 3.3: what the average over a neighborhood misses its samples by, root mean square.
double missOf(const FieldApproximation& average, const FieldSamples& samples,
  const std::vector<NearestSearch::Found>& near)
{
  double squares = 0.0;
  for (const NearestSearch::Found& found : near)
  {
    const Vector3d place = samples.cloud.points().col(found.index);
    squares +=
      std::pow(average.jet(place, Derivatives::None).value - samples.values[found.index], 2);
  }
  return std::sqrt(squares / static_cast<double>(near.size()));
}

} // namespace

std::unique_ptr<FieldApproximation> makeHybrid(
  const FieldSamples& samples, const FieldParameters& parameters, const std::vector<char>& marked)
{
  return std::make_unique<HybridScheme>(samples, parameters, marked);
}

std::vector<char> markMissedSamples(
  const FieldSamples& samples, const FieldParameters& parameters, const Execution& execution)
{
  const double range = samples.values.maxCoeff() - samples.values.minCoeff();
  std::vector<char> marked(static_cast<std::size_t>(samples.values.size()));
  parallelForEach((marked.size() + SamplesPerBlock - 1) / SamplesPerBlock, execution,
    [&](std::size_t block, const Poll& poll)
    {
      const auto approximation = makeExplicitMLS(samples, parameters);
      NearestSearch search = neighborhoodSearch(samples.cloud, parameters);
      const std::size_t end = std::min(marked.size(), (block + 1) * SamplesPerBlock);
      for (std::size_t i = block * SamplesPerBlock; i < end; ++i)
      {
        poll(); // each takes time with the square of its neighborhood
        const Vector3d place = samples.cloud.points().col(static_cast<Eigen::Index>(i));
        const std::vector<NearestSearch::Found>& near = search.find(place);
        checkNeighborhood(near.size());
        approximation->center(place);
        const double miss = missOf(*approximation, samples, near);
        marked[i] = miss > parameters.hybridThreshold * range ? 1 : 0;
      }
    });
  return marked;
}

} // namespace SurfaceScalars
