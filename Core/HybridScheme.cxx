#include "FieldSchemes.h"

#include <cmath>

namespace SurfaceScalars
{
namespace
{

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
  parallelFor(marked.size(), 64, execution,
    [&](std::size_t begin, std::size_t end)
    {
      const auto approximation = makeExplicitMLS(samples, parameters);
      NearestSearch search = neighborhoodSearch(samples.cloud, parameters);
      for (std::size_t i = begin; i < end; ++i)
      {
        // e_MLS of sec. 3.3: the average over the neighborhood, at each of its samples.
        const Vector3d place = samples.cloud.points().col(static_cast<Eigen::Index>(i));
        approximation->center(place);
        double squares = 0.0;
        const std::vector<NearestSearch::Found>& near = search.find(place);
        for (const NearestSearch::Found& found : near)
        {
          const Index j = found.index;
          const double average =
            approximation->jet(samples.cloud.points().col(j), Derivatives::None).value;
          squares += std::pow(average - samples.values[j], 2);
        }
        const double miss = std::sqrt(squares / static_cast<double>(near.size()));
        marked[i] = miss > parameters.hybridThreshold * range ? 1 : 0;
      }
    });
  return marked;
}

} // namespace SurfaceScalars
