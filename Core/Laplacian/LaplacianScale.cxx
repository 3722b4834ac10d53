#include "LaplacianScale.h"

#include <functional>

namespace SurfaceScalars
{
namespace
{

constexpr std::size_t Grain = 4096; // rows per block of a parallel loop
constexpr int Iterations = 6;
constexpr double LeastRough = 0.2; // of the spectrum of A, which ends at
constexpr double Greatest = 2.0;
constexpr double MostSteps = 1.5; // by which a point may be displaced to count

/// Parts of the work: two filters and an energy.
constexpr double Share = 1.0 / (2 * Iterations + 1);

using Stiffness = Eigen::SparseMatrix<double>;

Vector3d product(const Stiffness& stiffness, Eigen::Index row, const Points& coordinates)
{
  Vector3d result = Vector3d::Zero();
  for (Stiffness::InnerIterator entry(stiffness, row); entry; ++entry)
  {
    result += entry.value() * coordinates.col(entry.index());
  }
  return result;
}

void forEachRow(
  Eigen::Index count, const Execution& execution, const std::function<void(Eigen::Index row)>& body)
{
  parallelFor(static_cast<std::size_t>(count), Grain, execution,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        body(static_cast<Eigen::Index>(i));
      }
    });
}

/// (1 - q(A)) x: what Chebyshev's iteration for A y = A x finds from y = 0.
class RoughPart
{
public:
  explicit RoughPart(const Stiffness& stiffness)
    : stiffness_(stiffness)
    , inverseDiagonal_(
        stiffness.diagonal().unaryExpr([](double d) { return d > 0.0 ? 1.0 / d : 0.0; }))
    , residual_(3, stiffness.cols())
    , step_(3, stiffness.cols())
    , nextStep_(3, stiffness.cols())
    , sum_(3, stiffness.cols())
  {
  }

  Points of(const Points& coordinates, const Execution& execution)
  {
    constexpr double center = (Greatest + LeastRough) / 2;
    constexpr double radius = (Greatest - LeastRough) / 2;
    this->begin(coordinates, 1.0 / center, execution.part(0.0, 1.0 / Iterations));
    double ratio = radius / center;
    for (int i = 1; i < Iterations; ++i)
    {
      const double next = 1.0 / (2.0 * center / radius - ratio);
      this->advance(next * ratio, 2.0 * next / radius,
        execution.part(i / double(Iterations), (i + 1) / double(Iterations)));
      ratio = next;
    }
    return this->sum_;
  }

private:
  void begin(const Points& coordinates, double factor, const Execution& execution)
  {
    forEachRow(coordinates.cols(), execution,
      [&](Eigen::Index i)
      {
        this->residual_.col(i) = product(this->stiffness_, i, coordinates);
        this->step_.col(i) = factor * this->inverseDiagonal_[i] * this->residual_.col(i);
        this->sum_.col(i) = this->step_.col(i);
      });
  }

  void advance(double stepFactor, double residualFactor, const Execution& execution)
  {
    forEachRow(this->sum_.cols(), execution,
      [&](Eigen::Index i)
      {
        this->residual_.col(i) -= product(this->stiffness_, i, this->step_);
        this->nextStep_.col(i) = stepFactor * this->step_.col(i) +
          residualFactor * this->inverseDiagonal_[i] * this->residual_.col(i);
        this->sum_.col(i) += this->nextStep_.col(i);
      });
    this->step_.swap(this->nextStep_);
  }

  const Stiffness& stiffness_;
  Values inverseDiagonal_;
  Points residual_;
  Points step_;
  Points nextStep_;
  Points sum_;
};

/// The factor that makes the energy of the relaxed coordinates twice the mass, as counted where
/// they are displaced little; 0 if that is on less than half of the mass.
double scaleOf(const Laplacian& laplacian, const NeighborGraph& graph, const Points& displacements,
  const Execution& execution)
{
  const Points relaxed = graph.points() - displacements;
  Eigen::Matrix2Xd parts = Eigen::Matrix2Xd::Zero(2, relaxed.cols()); // mass and energy
  forEachRow(relaxed.cols(), execution,
    [&](Eigen::Index i)
    {
      if (displacements.col(i).norm() > MostSteps * graph.samplingStep(static_cast<Index>(i)))
      {
        return;
      }
      parts(0, i) = laplacian.mass[i];
      for (Stiffness::InnerIterator entry(laplacian.stiffness, i); entry; ++entry)
      {
        parts(1, i) -=
          entry.value() / 2 * (relaxed.col(i) - relaxed.col(entry.index())).squaredNorm();
      }
    });
  const Vector2d sums = parts.rowwise().sum();
  return sums[0] > laplacian.mass.sum() / 2 && sums[1] > 0.0 ? 2.0 * sums[0] / sums[1] : 0.0;
}

} // namespace

double stiffnessScale(
  const Laplacian& laplacian, const NeighborGraph& graph, const Execution& execution)
{
  RoughPart rough(laplacian.stiffness);
  const Execution first = execution.part(0.0, Iterations * Share);
  const Execution second = execution.part(Iterations * Share, 2 * Iterations * Share);
  const Execution last = execution.part(2 * Iterations * Share, 1.0);
  Points displacements = rough.of(rough.of(graph.points(), first), second);
  double result = scaleOf(laplacian, graph, displacements, last.part(0.0, 0.5));
  if (result == 0.0)
  {
    displacements.setZero(); // too few points to relax: all of it is rough
    result = scaleOf(laplacian, graph, displacements, last.part(0.5, 1.0));
  }
  return result > 0.0 ? result : 1.0; // 0: nothing is linked
}

} // namespace SurfaceScalars
