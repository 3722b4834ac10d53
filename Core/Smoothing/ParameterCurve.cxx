#include "ParameterCurve.h"

#include "LCurve.h"
#include "Require.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace SurfaceScalars
{
namespace
{

constexpr double Accuracy = 1e-5;           // of solutions
constexpr double DerivativeAccuracy = 1e-3; // of a quadratic form, whose error is its square
constexpr double Step = 1.5;                // of log10 epsilon, before it is refined
constexpr double CornerStep = 0.75;         // the same, of the L-curve, whose corner is narrow
constexpr int Refinements = 2;              // each halves the step about the best
constexpr int Extensions = 4;               // steps beyond the range
constexpr Eigen::Index ProbeValues = 1000;

struct Entry
{
  double residual;
  double seminorm;
  double gcv;
  double curvature;
};

/// The largest magnitude, 1 if all are 0.
double unitOf(const ValuesRef& values)
{
  const double largest = values.lpNorm<Eigen::Infinity>();
  return largest > 0.0 ? largest : 1.0;
}

constexpr Eigen::Index NoCorner = 0; ///< the first entry has no neighbor below it

/// Where the curvature is largest, positive and larger than at both neighbors.
Eigen::Index cornerOf(const Values& curvatures)
{
  Eigen::Index result = NoCorner;
  for (Eigen::Index i = 1; i + 1 < curvatures.size(); ++i)
  {
    const bool isPeak =
      curvatures[i] > std::max(0.0, curvatures[i - 1]) && curvatures[i] > curvatures[i + 1];
    if (isPeak && (result == NoCorner || curvatures[i] > curvatures[result]))
    {
      result = i;
    }
  }
  return result;
}

class CurveBuilder
{
public:
  CurveBuilder(const TikhonovSmoother& smoother, const ValuesRef& values, EpsilonChoice choice,
    NoiseShares& shares, const Execution& execution)
    : smoother_(smoother)
    , scale_(unitOf(values))
    , values_(values / scale_)
    , choice_(choice)
    , shares_(shares)
    , execution_(execution)
  {
    std::mt19937_64 random(1);
    const Eigen::Index count = (ProbeValues + values.size() - 1) / values.size();
    this->probes_ = Eigen::MatrixXd::NullaryExpr(
      values.size(), count, [&]() { return (random() >> 63U) == 0 ? 1.0 : -1.0; });
  }

  ParameterCurve build();

private:
  double logEpsilon(double length) const
  {
    return std::log10(this->smoother_.epsilonOfLength(length));
  }
  void add(double logEpsilon);
  double shareLeft(double logEpsilon, const Execution& execution);
  std::map<double, Entry>::const_iterator best() const;
  void extend();
  void refine();

  const TikhonovSmoother& smoother_;
  double scale_; ///< so that squares are in range
  const Values values_;
  EpsilonChoice choice_;
  NoiseShares& shares_;
  Execution execution_;
  Eigen::MatrixXd probes_;          ///< columns of signs
  std::map<double, Entry> entries_; ///< by log10 epsilon
  double planned_ = 0.0;
};

/// 1 - trace / n, the share of noise that is removed.
double CurveBuilder::shareLeft(double logEpsilon, const Execution& execution)
{
  const auto known = this->shares_.find(logEpsilon);
  if (known != this->shares_.end())
  {
    return known->second;
  }
  const double epsilon = std::pow(10.0, logEpsilon);
  const auto count = static_cast<double>(this->probes_.cols());
  double sum = 0.0;
  for (int i = 0; i < this->probes_.cols(); ++i)
  {
    const Values probe = this->probes_.col(i);
    const Execution part = execution.part(static_cast<double>(i) / count, (i + 1.0) / count);
    sum += probe.dot(probe - this->smoother_.smooth(probe, epsilon, part, Accuracy));
  }
  return this->shares_[logEpsilon] = sum / static_cast<double>(this->probes_.size());
}

void CurveBuilder::add(double logEpsilon)
{
  const double epsilon = std::pow(10.0, logEpsilon);
  const auto done = static_cast<double>(this->entries_.size());
  const Execution part =
    this->execution_.part(done / this->planned_, std::min(1.0, (done + 1.0) / this->planned_));
  const Values smoothed =
    this->smoother_.smooth(this->values_, epsilon, part.part(0.0, 0.4), Accuracy);
  const Values rest = this->values_ - smoothed;
  const Values change =
    this->smoother_.smooth(rest, epsilon, part.part(0.4, 0.6), DerivativeAccuracy);
  const double share = this->shareLeft(logEpsilon, part.part(0.6, 1.0));

  Entry entry{};
  entry.residual = this->smoother_.distance(this->values_, smoothed);
  entry.seminorm = std::sqrt(this->smoother_.energy(smoothed));
  const double meanSquare = rest.squaredNorm() / static_cast<double>(rest.size());
  entry.gcv = meanSquare > 0.0 ? meanSquare / (share * share) : 0.0;
  entry.curvature = lCurveCurvature(std::pow(entry.residual, 2), std::pow(entry.seminorm, 2),
    -2.0 * this->smoother_.product(rest, change), this->smoother_.weight(epsilon));
  this->entries_.emplace(logEpsilon, entry);
}

/// At the corner of the L-curve, if it has one; otherwise where cross-validation is best.
std::map<double, Entry>::const_iterator CurveBuilder::best() const
{
  if (this->choice_ == EpsilonChoice::LCurve)
  {
    Values curvatures(this->entries_.size());
    std::transform(this->entries_.begin(), this->entries_.end(), curvatures.begin(),
      [](const auto& entry) { return entry.second.curvature; });
    if (const Eigen::Index corner = cornerOf(curvatures); corner != NoCorner)
    {
      return std::next(this->entries_.begin(), corner);
    }
  }
  return std::min_element(this->entries_.begin(), this->entries_.end(),
    [](const auto& a, const auto& b) { return a.second.gcv < b.second.gcv; });
}

void CurveBuilder::extend()
{
  for (int i = 0; i < Extensions; ++i)
  {
    const auto found = this->best();
    if (!(found->second.residual > 0.0))
    {
      return;
    }
    if (found == this->entries_.begin())
    {
      this->add(found->first - Step);
    }
    else if (std::next(found) == this->entries_.end())
    {
      this->add(found->first + Step);
    }
  }
}

void CurveBuilder::refine()
{
  double step = this->choice_ == EpsilonChoice::LCurve ? CornerStep : Step;
  for (int i = 0; i < Refinements; ++i)
  {
    const double middle = this->best()->first;
    step *= 0.5;
    this->add(middle - step);
    this->add(middle + step);
  }
}

ParameterCurve CurveBuilder::build()
{
  const double size = std::sqrt(this->smoother_.area());
  const double edge = size / std::sqrt(static_cast<double>(this->values_.size()));
  const double first = this->logEpsilon(size);
  const double step = this->choice_ == EpsilonChoice::LCurve ? CornerStep : Step;
  const int count = static_cast<int>(std::ceil((this->logEpsilon(0.5 * edge) - first) / step));
  this->planned_ = count + 1 + 2 * Refinements + Extensions;
  for (int i = 0; i <= count; ++i)
  {
    this->add(first + i * step);
  }
  this->extend();
  this->refine();

  ParameterCurve result;
  const auto entries = static_cast<Eigen::Index>(this->entries_.size());
  for (Values* column :
    { &result.epsilons, &result.residuals, &result.seminorms, &result.gcv, &result.curvatures })
  {
    column->resize(entries);
  }
  Eigen::Index row = 0;
  for (const auto& [logEpsilon, entry] : this->entries_)
  {
    result.epsilons[row] = std::pow(10.0, logEpsilon);
    result.residuals[row] = this->scale_ * entry.residual;
    result.seminorms[row] = this->scale_ * entry.seminorm;
    result.gcv[row] = this->scale_ * this->scale_ * entry.gcv;
    result.curvatures[row] = entry.curvature;
    ++row;
  }
  this->execution_.report(1.0);
  return result;
}

/// Where the parabola through three points is least; the middle one if they are not convex.
double parabolaMinimum(const Eigen::Array3d& x, const Eigen::Array3d& y)
{
  const double left = (y[1] - y[0]) / (x[1] - x[0]);
  const double right = (y[2] - y[1]) / (x[2] - x[1]);
  if (!(right > left))
  {
    return x[1];
  }
  const double middleOfLeft = 0.5 * (x[0] + x[1]);
  const double middleOfRight = 0.5 * (x[1] + x[2]);
  return std::clamp(
    middleOfLeft - left * (middleOfRight - middleOfLeft) / (right - left), x[0], x[2]);
}

} // namespace

ParameterCurve parameterCurve(const TikhonovSmoother& smoother, const ValuesRef& values,
  const Execution& execution, EpsilonChoice choice, NoiseShares* known)
{
  require(values.size() == smoother.size(),
    "a value at each of " + std::to_string(smoother.size()) + " vertices",
    std::to_string(values.size()) + " values", "Choose another array.");
  NoiseShares own;
  return CurveBuilder(smoother, values, choice, known ? *known : own, execution).build();
}

double chooseEpsilon(const ParameterCurve& curve, EpsilonChoice choice)
{
  require(choice != EpsilonChoice::Manual, "GCV 0 or LCurve 1", "Manual 2", "Choose one of these.");
  const Eigen::Index corner = cornerOf(curve.curvatures);
  const bool hasCorner = choice == EpsilonChoice::LCurve && corner != NoCorner;
  const Values badness = hasCorner ? Values(-curve.curvatures) : curve.gcv;
  Eigen::Index best = corner;
  if (!hasCorner)
  {
    badness.minCoeff(&best);
  }
  if (best == 0 || best == badness.size() - 1)
  {
    return curve.epsilons[best];
  }
  return std::pow(10.0,
    parabolaMinimum(
      curve.epsilons.segment<3>(best - 1).array().log10(), badness.segment<3>(best - 1).array()));
}

} // namespace SurfaceScalars
