#include "CriticalSweep.h"

#include "Orientation.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace SurfaceScalars
{
namespace
{

constexpr std::size_t FitsPerBlock = 256; // about
// Of the sample nearest to a place, in sampling steps: standard deviation along each axis. Where
// samples are random it is 1 / sqrt(2 pi) = 0.40, for none is within r with probability
// exp(-pi r^2 / step^2); a little more, so that nearest samples are not missed.
constexpr double NearestDisplacement = 0.55;
constexpr double RunShare = 1.0 / 24.0; // of a neighborhood: most samples in a run
constexpr std::size_t FewestInRun = 6;  // that are asked for
constexpr double RunExtent = 0.6;       // of a run, in radii
constexpr double NoiseExtent = 2.0;     // and in standard deviations of the noise
constexpr double ServedRadius = 0.75;   // around the center of a fit, in radii
constexpr double CandidateRadius = 0.8;
constexpr double InnerCandidateRadius = 0.5; // of fits to many neighbors
constexpr int ManyNeighbors = 60;

// Samples that are surely not critical: -ln pi, and a bound of the variance of gradients.
constexpr double LargestExponent = 15.0;
constexpr double VarianceBound = 1000.0;
constexpr double Flat = 1e-13; // changes of f, in its range: rounding

/// Samples that follow each other and are close to each other.
struct Run
{
  std::size_t begin;
  std::size_t end;
};

/// How many at most.
std::size_t runLength(const CriticalScale& scale)
{
  const double share = RunShare * scale.neighborCount;
  return std::max(FewestInRun, static_cast<std::size_t>(share));
}

class Sweeper
{
public:
  Sweeper(const NeighborGraph& graph, const CriticalScale& scale, ProbabilityModel probabilityModel,
    CriticalSweep& result, std::vector<CriticalCandidate>& candidates)
    : graph_(graph)
    , scale_(scale)
    , probabilityModel_(probabilityModel)
    , model_(scale)
    , result_(result)
    , candidates_(candidates)
  {
  }

  void sweep(std::size_t begin, std::size_t end);

private:
  Vector3d placeOf(std::size_t sample) const
  {
    return this->graph_.points().col(static_cast<Eigen::Index>(sample)) - this->scale_.origin;
  }
  std::vector<Run> divide(std::size_t begin, std::size_t end) const;
  void serve(const Run& run);
  void serveAlone(std::size_t sample);
  void findCandidate();
  void evaluate(std::size_t sample, const Vector2d& uv);
  double probability(std::size_t sample, const Vector2d& uv, const LocalFit::Jet& f);

  const NeighborGraph& graph_;
  const CriticalScale& scale_;
  ProbabilityModel probabilityModel_;
  CriticalModel model_;
  CriticalSweep& result_;
  std::vector<CriticalCandidate>& candidates_;
  std::vector<std::size_t> distant_; ///< samples that no run's fit serves
};

std::vector<Run> Sweeper::divide(std::size_t begin, std::size_t end) const
{
  const std::size_t most = runLength(this->scale_);
  const double steps = std::sqrt(this->scale_.neighborCount / Pi);
  std::vector<Run> runs;
  while (begin < end)
  {
    const Vector3d first = this->placeOf(begin);
    const double reach = steps * this->graph_.samplingStep(static_cast<Index>(begin));
    const double extent = RunExtent * reach + NoiseExtent * this->scale_.heightNoise;
    std::size_t next = begin + 1;
    while (next < end && next - begin < most && (this->placeOf(next) - first).norm() <= extent)
    {
      ++next;
    }
    runs.push_back({ begin, next });
    begin = next;
  }
  return runs;
}

void Sweeper::sweep(std::size_t begin, std::size_t end)
{
  const std::vector<Run> runs = this->divide(begin, end);
  Points centers(3, static_cast<Eigen::Index>(runs.size()));
  for (std::size_t i = 0; i < runs.size(); ++i)
  {
    const auto first = static_cast<Eigen::Index>(runs[i].begin);
    const auto count = static_cast<Eigen::Index>(runs[i].end - runs[i].begin);
    centers.col(static_cast<Eigen::Index>(i)) =
      this->graph_.points().middleCols(first, count).rowwise().mean() - this->scale_.origin;
  }
  std::size_t expected = 0;
  for (std::size_t i = 0; i < runs.size(); ++i)
  {
    const auto column = static_cast<Eigen::Index>(i);
    if (i == expected)
    {
      expected +=
        static_cast<std::size_t>(this->model_.expect(centers.rightCols(centers.cols() - column)));
    }
    if (this->model_.center(centers.col(column)))
    {
      this->findCandidate();
      this->serve(runs[i]);
    }
    else
    {
      for (std::size_t sample = runs[i].begin; sample < runs[i].end; ++sample)
      {
        this->distant_.push_back(sample);
      }
    }
  }
  for (const std::size_t sample : this->distant_)
  {
    this->serveAlone(sample);
  }
}

void Sweeper::findCandidate()
{
  const std::optional<Vector2d> uv = this->model_.criticalPoint(
    this->scale_.neighborCount > ManyNeighbors ? InnerCandidateRadius : CandidateRadius);
  if (uv)
  {
    const double radius = this->model_.radius();
    this->candidates_.push_back({ this->model_.fit().lift(*uv), radius, uv->norm() / radius });
  }
}

void Sweeper::serve(const Run& run)
{
  for (std::size_t sample = run.begin; sample < run.end; ++sample)
  {
    const Vector2d uv = this->model_.fit().flatten(this->placeOf(sample));
    if (uv.norm() <= ServedRadius * this->model_.radius())
    {
      this->evaluate(sample, uv);
    }
    else
    {
      this->distant_.push_back(sample);
    }
  }
}

void Sweeper::serveAlone(std::size_t sample)
{
  const Vector3d place = this->placeOf(sample);
  if (this->model_.center(place))
  {
    this->evaluate(sample, Vector2d::Zero());
    return;
  }
  // Points on a line: no surface.
  const auto column = static_cast<Eigen::Index>(sample);
  this->result_.samples.probability[column] = 0.0;
  this->result_.samples.gradient.col(column).setZero();
  this->result_.samples.normal.col(column) = Vector3d::UnitZ();
  this->result_.values[column] = this->scale_.values.mean();
}

void Sweeper::evaluate(std::size_t sample, const Vector2d& uv)
{
  const auto column = static_cast<Eigen::Index>(sample);
  const LocalFit& fit = this->model_.fit();
  const bool isThere = this->model_.moveField(uv);
  const LocalFit::Jet f = isThere ? this->model_.jet(uv) : fit.value(uv);
  const Vector2d slope = fit.heightSlope(uv).gradient;
  const Vector3d normal = fit.frame() * Vector3d(-slope.x(), -slope.y(), 1.0).normalized();
  SampleCriticality& samples = this->result_.samples;
  samples.normal.col(column) =
    isOutwards(this->graph_.points().col(column), normal) ? normal : Vector3d(-normal);
  samples.gradient.col(column) = fit.tangentialGradient(f.gradient, slope);
  samples.probability[column] = this->probabilityModel_ == ProbabilityModel::NormalAngle
    ? this->model_.normalCosine(uv)
    : this->probability(sample, uv, f);
  this->result_.values[column] = f.value;
}

double Sweeper::probability(std::size_t sample, const Vector2d& uv, const LocalFit::Jet& f)
{
  const double radius = this->model_.radius();
  if (!(f.gradient.norm() * radius + f.hessian.norm() * radius * radius > Flat))
  {
    return 0.0;
  }
  const double displacement =
    NearestDisplacement * this->graph_.samplingStep(static_cast<Index>(sample));
  const double misfit = this->model_.fit().valueMisfit() / radius;
  const double largest = displacement * displacement * f.hessian.squaredNorm() +
    VarianceBound * misfit * misfit / this->scale_.fitCount();
  if (f.gradient.squaredNorm() > 2.0 * LargestExponent * largest)
  {
    return 0.0;
  }
  const Eigen::Matrix2d spread = this->model_.gradientError(uv) +
    displacement * displacement * f.hessian * f.hessian.transpose();
  const double pi = std::exp(-0.5 * f.gradient.dot(spread.inverse() * f.gradient));
  return std::isfinite(pi) ? pi : 0.0;
}

} // namespace

CriticalSweep sweepSamples(const NeighborGraph& graph, const CriticalScale& scale,
  ProbabilityModel probabilityModel, const Execution& execution)
{
  const std::size_t count = graph.pointCount();
  const auto columns = static_cast<Eigen::Index>(count);
  CriticalSweep result;
  result.values.resize(columns);
  result.samples.probability.resize(columns);
  result.samples.gradient.resize(3, columns);
  result.samples.normal.resize(3, columns);
  const std::size_t grain = FitsPerBlock * runLength(scale);
  std::vector<std::vector<CriticalCandidate>> candidates((count + grain - 1) / grain);
  parallelFor(count, grain, execution,
    [&](std::size_t begin, std::size_t end) {
      Sweeper(graph, scale, probabilityModel, result, candidates[begin / grain]).sweep(begin, end);
    });
  for (const std::vector<CriticalCandidate>& some : candidates)
  {
    result.candidates.insert(result.candidates.end(), some.begin(), some.end());
  }
  return result;
}

} // namespace SurfaceScalars
