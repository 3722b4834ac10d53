#include "CenterSum.h"

#include "DistinctSamples.h"
#include "Error.h"
#include "KernelWidth.h"
#include "KrylovSolver.h"
#include "NumberText.h"
#include "RadialRefusal.h"
#include "RadialSums.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace SurfaceScalars
{
namespace
{

constexpr double WidthReduction = 0.8; // of an automatic width that proves too large
constexpr int MostReductions = 20;
constexpr double SmallestReciprocal = 1e-14; // of a condition with which misses are checked
constexpr double LargestMiss = 1e-6;         // of an interpolant, of f's range
constexpr double LargestAutomatic = 1e-10;   // the same with a width that can be reduced
constexpr double LeastSquaresGoal = 1e-10;   // of values at centers
constexpr std::size_t PlacesPerBlock = 64;

} // namespace

CenterSum::CenterSum(
  const FieldParameters& parameters, int dimension, double lowest, double highest)
  : parameters_(parameters)
  , dimension_(dimension)
  , lowest_(lowest)
  , highest_(highest)
{
}

bool CenterSum::isReducible() const
{
  return !(this->parameters_.kernelWidth > 0.0) && this->kernel().dependsOnWidth();
}

double CenterSum::largestMiss() const
{
  const double largest = std::max(std::abs(this->lowest_), std::abs(this->highest_));
  return (this->isReducible() ? LargestAutomatic : LargestMiss) * (this->highest_ - this->lowest_) +
    1e-14 * largest;
}

double CenterSum::firstWidth(const CenterSet& centers, const Execution& execution) const
{
  const DistinctSamples distinct(centers.places, execution.part(0.0, 0.1));
  return chooseKernelWidth({ distinct.cloud(), distinct.average(centers.values) },
    this->parameters_.kernel, this->parameters_.regularization, execution.part(0.1, 1.0));
}

/// @returns whether the system of the width can be solved
bool CenterSum::tryWidth(const CenterSet& centers, const Execution& execution)
{
  const bool isRegular = this->fit_.factor(
    centers.places, this->kernel(), this->parameters_.regularization, execution.part(0.0, 0.9));
  // Of a kernel that knows no width, stars as small as the triangles of a large mesh make it worse.
  if (!isRegular && (this->isReducible() || this->fit_.reciprocalCondition() < SmallestReciprocal))
  {
    return false;
  }
  const Values values = centers.values.array() - this->middle();
  this->solve(values, execution.part(1.0, 1.0));
  const Values misses = values - this->sumsAt(centers.places, execution.part(1.0, 1.0));
  return this->parameters_.regularization > 0.0 ||
    misses.lpNorm<Eigen::Infinity>() <= this->largestMiss();
}

/// @param values at the centers
void CenterSum::solve(const Values& values, const Execution& execution)
{
  this->fit_.solve(values);
  this->coefficients_ = this->fit_.coefficients();
  this->tail_ = this->fit_.tail();
  if (this->parameters_.regularization == 0.0)
  {
    // Once more for the rounding errors, which large coefficients magnify.
    this->fit_.solve(values - this->sumsAt(this->fit_.centers(), execution));
    this->coefficients_ += this->fit_.coefficients();
    this->tail_ += this->fit_.tail();
  }
}

void CenterSum::interpolate(const CenterSet& centers, const Execution& execution)
{
  const auto count = static_cast<double>(centers.places.cols() - centers.starCount + 1);
  if (this->width_ == 0.0)
  {
    this->width_ = this->parameters_.kernelWidth > 0.0
      ? this->parameters_.kernelWidth
      : this->firstWidth(centers, execution.part(0.0, 0.1));
    this->count_ = count;
  }
  if (this->isReducible())
  {
    this->width_ *= std::pow(this->count_ / count, 1.0 / this->dimension_);
    this->count_ = count;
  }
  for (int reduction = 0;; ++reduction)
  {
    const double done = 1.0 - 0.9 * std::pow(0.5, reduction); // it may not be the last time
    if (this->tryWidth(centers, execution.part(done, 0.5 * (1.0 + done))))
    {
      return;
    }
    if (!this->isReducible() || reduction == MostReductions)
    {
      refuseSystem("a system too close to singular to interpolate f", this->kernel(),
        1.0 / this->fit_.reciprocalCondition());
    }
    this->width_ *= WidthReduction;
  }
}

void CenterSum::approximate(
  const CenterSet& centers, const PlacedValues& further, const Execution& execution)
{
  this->interpolate(centers, execution.part(0.0, 0.5));
  const Eigen::Index free = centers.places.cols() - centers.starCount;
  Points places(3, free + further.places.cols());
  places << centers.places.rightCols(free), further.places;
  Values misses(places.cols());
  misses << centers.values.tail(free), further.values;
  misses -= this->at(places, execution.part(0.5, 0.5));
  const double unit = this->highest_ > this->lowest_ ? this->highest_ - this->lowest_ : 1.0;

  // What a change of the values at the centers that are not of stars makes of the sum, and its
  // transpose. The first rows are the identity: the matrix has no small singular values.
  const auto changed = [&](const Values& changes, const Execution& polling)
  {
    Values all = Values::Zero(centers.places.cols());
    all.tail(free) = changes;
    this->solve(all, polling);
    return this->sumsAt(places, polling);
  };
  const auto transposed = [&](const Values& sums, const Execution& polling) -> Values
  {
    const Values kernels = radialSums(this->kernel(), places, sums, centers.places, polling);
    const Values polynomials = this->fit_.terms().at(places).transpose() * sums;
    return this->fit_.dependsOnValues(kernels, polynomials).bottomRows(free);
  };
  const PreconditionedSystem normalEquations{ [&](const Values& changes, const Execution& polling)
    { return transposed(changed(changes, polling), polling); },
    [](const Values& residual, const Execution&) { return residual; } };
  Values values = centers.values;
  try
  {
    values.tail(free) += unit *
      normalEquations.solve(transposed(misses / unit, execution.part(0.5, 0.5)), LeastSquaresGoal,
        execution.part(0.5, 1.0), 1.0);
  }
  catch (const Error&)
  {
    this->refuseLeastSquares();
  }
  this->takeValues(values, execution.part(1.0, 1.0));
}

/// Values at centers matter too differently for the few digits that a small regularization leaves.
void CenterSum::refuseLeastSquares() const
{
  throw InvalidInput("a kernel with which least squares can be solved at machine precision",
    "the " + textOf(this->kernel()) + " with a Regularization of " +
      textOf(this->parameters_.regularization) + " (condition about " + textOf(this->condition()) +
      ")",
    std::string(this->kernel().dependsOnWidth() ? "Lower KernelWidth, raise" : "Raise") +
      " Regularization a hundredfold, to 1e-8 at least, or choose Interpolating constraints.");
}

void CenterSum::takeValues(const Values& values, const Execution& execution)
{
  this->solve(values.array() - this->middle(), execution);
}

Eigen::MatrixXd CenterSum::dependences(
  const Points& places, Eigen::Index free, const Execution& execution) const
{
  Eigen::MatrixXd result(free, places.cols());
  parallelFor(static_cast<std::size_t>(places.cols()), PlacesPerBlock, execution,
    [&](std::size_t begin, std::size_t end)
    {
      const auto first = static_cast<Eigen::Index>(begin);
      const auto block = places.middleCols(first, static_cast<Eigen::Index>(end) - first);
      Eigen::MatrixXd kernels(this->fit_.centers().cols(), block.cols());
      for (Eigen::Index i = 0; i < block.cols(); ++i)
      {
        auto column = kernels.col(i).array();
        column = (this->fit_.centers().colwise() - block.col(i)).colwise().squaredNorm();
        this->kernel().apply(column);
      }
      result.middleCols(first, block.cols()) =
        this->fit_.dependsOnValues(kernels, this->fit_.terms().at(block).transpose())
          .bottomRows(free);
    });
  return result;
}

Values CenterSum::leaveOneOutErrors(const CenterSet& centers, const Execution& execution)
{
  this->fit_.solve(centers.values.array() - this->middle());
  return this->fit_.leaveOneOutErrors(execution);
}

Values CenterSum::sumsAt(const PointsRef& places, const Execution& execution) const
{
  const Values sums =
    radialSums(this->kernel(), this->fit_.centers(), this->coefficients_, places, execution);
  const auto offsets = places.colwise() - this->fit_.tailOrigin();
  return sums.array() + this->tail_[0] +
    (this->tail_.tail<3>().transpose() * offsets).transpose().array();
}

Values CenterSum::at(const PointsRef& places, const Execution& execution) const
{
  return this->sumsAt(places, execution).array() + this->middle();
}

FieldModel CenterSum::model() const
{
  FieldModel result;
  result.parameters = this->parameters_;
  result.parameters.kernelWidth = this->width_;
  result.centers = this->fit_.centers();
  result.coefficients = this->coefficients_;
  result.tail = this->tail_;
  result.tail[0] += this->middle();
  result.tailOrigin = this->fit_.tailOrigin();
  result.lowest = this->lowest_;
  result.highest = this->highest_;
  return result;
}

} // namespace SurfaceScalars
