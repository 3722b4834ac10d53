#include "SaddleFan.h"

#include <Eigen/Geometry>
#include <Eigen/QR>

#include <algorithm>
#include <array>
#include <cmath>

namespace SurfaceScalars
{
namespace
{

constexpr int Degree = 5;
constexpr int TermCount = (Degree + 1) * (Degree + 2) / 2;
constexpr std::size_t MostBranches = 10; // of 2 n with n = Degree
constexpr int SamplesPerTerm = 3;
constexpr std::size_t CirclePoints = 64;
constexpr double LargestError = 0.3;        // of the polynomial, to its values on a circle
constexpr double LargestShift = 0.2;        // from a circle onto the level set, in radii
constexpr double LeastOutwards = 0.9;       // cosine between a branch and the way from the center
constexpr double LargestUncertainty = 1e-3; // of f's range, that the samples leave to values
constexpr double FarthestCenter = 8.0;      // from the candidate, in widened sampling steps
constexpr double CenterPrecision = 1e-9;
constexpr int CenterIterations = 40;
constexpr std::array<double, 7> Radii{ 0.5, 0.7, 1.0, 1.4, 2.0, 2.8, 4.0 }; // in such steps

double factorial(int n)
{
  return std::tgamma(n + 1.0);
}

/// The powers u^(d - j) v^j of a place by degree d, then by j.
std::array<double, TermCount> powersOf(const Vector2d& place)
{
  std::array<double, TermCount> powers{ 1.0 };
  for (int d = 1, term = 1; d <= Degree; ++d)
  {
    for (int j = 0; j < d; ++j, ++term)
    {
      powers[static_cast<std::size_t>(term)] =
        powers[static_cast<std::size_t>(term - d)] * place.x();
    }
    powers[static_cast<std::size_t>(term)] =
      powers[static_cast<std::size_t>(term - d - 1)] * place.y();
    ++term;
  }
  return powers;
}

} // namespace

SaddleFinder::SaddleFinder(LevelSetModel& model, LevelSetWalker& walker,
  const SampledFunction& function, double level, const Poll& poll)
  : model_(model)
  , walker_(walker)
  , function_(function)
  , level_(level)
  , poll_(poll)
{
}

/// Moves a place onto the surface and fits the polynomial around it.
bool SaddleFinder::fitAt(const Vector3d& place)
{
  this->poll_();
  if (!this->model_.center(place))
  {
    return false;
  }
  const Vector3d& gradient = this->model_.distanceGradient;
  this->center_ = place - this->model_.distance / gradient.squaredNorm() * gradient;
  this->axes_.col(0) = gradient.unitOrthogonal();
  this->axes_.col(1) = gradient.normalized().cross(this->axes_.col(0));
  const PointCloud& cloud = this->function_.graph;
  cloud.nearest(this->center_,
    std::max(SamplesPerTerm * TermCount, static_cast<int>(this->model_.samples().size())),
    this->near_);
  const auto count = static_cast<Eigen::Index>(this->near_.indices.size());
  this->scale_ = std::sqrt(this->near_.squaredDistances.back());
  Eigen::MatrixXd matrix(count, TermCount);
  Values right(count);
  double weightSum = 0.0;
  for (Eigen::Index i = 0; i < count; ++i)
  {
    const auto k = static_cast<std::size_t>(i);
    const Vector3d offset = cloud.points().col(this->near_.indices[k]) - this->center_;
    const double weight = 1.0 - this->near_.squaredDistances[k] / (this->scale_ * this->scale_);
    const auto powers = powersOf(this->axes_.transpose() * offset / this->scale_);
    matrix.row(i) = weight * Eigen::Map<const Eigen::RowVectorXd>(powers.data(), TermCount);
    right[i] = weight * (this->function_.values[this->near_.indices[k]] - this->level_);
    weightSum += weight * weight;
  }
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> decomposition(matrix);
  this->coefficients_ = decomposition.solve(right);
  this->deviation_ = (matrix * this->coefficients_ - right).norm() / std::sqrt(weightSum);
  return decomposition.rank() == TermCount;
}

double SaddleFinder::polynomial(const Vector2d& place) const
{
  const auto powers = powersOf(place / this->scale_);
  return this->coefficients_.dot(Eigen::Map<const Values>(powers.data(), TermCount));
}

/// The way from the center to where the derivatives of order n - 1, linear as those of order n make
/// them, vanish in the mean of squares; it does not depend on the axes. Newton's step for n = 2.
Vector2d SaddleFinder::stepToZero(int order) const
{
  const auto derivative = [&](int i, int j)
  { return this->coefficients_[(i + j) * (i + j + 1) / 2 + j] * factorial(i) * factorial(j); };
  Eigen::MatrixX2d slopes(order, 2);
  Values constants(order);
  for (int j = 0; j < order; ++j)
  {
    const int i = order - 1 - j;
    const double weight = std::sqrt(factorial(order - 1) / (factorial(i) * factorial(j)));
    slopes.row(j) << weight * derivative(i + 1, j), weight * derivative(i, j + 1);
    constants[j] = weight * derivative(i, j);
  }
  return this->scale_ * slopes.colPivHouseholderQr().solve(-constants);
}

SaddleFinder::Ring SaddleFinder::ringOf(double radius) const
{
  const auto angleOf = [](double i) { return 2.0 * Pi * i / CirclePoints; };
  std::array<double, CirclePoints> values{};
  for (std::size_t i = 0; i < CirclePoints; ++i)
  {
    const double angle = angleOf(static_cast<double>(i));
    values[i] = this->polynomial(radius * Vector2d(std::cos(angle), std::sin(angle)));
  }
  const auto changesAfter = [&](std::size_t i)
  { return (values[i] < 0.0) != (values[(i + 1) % CirclePoints] < 0.0); };
  Ring ring{ radius, {}, false, INFINITY };
  std::size_t first = 0;
  while (first < CirclePoints && !changesAfter(first))
  {
    ++first;
  }
  double largest = INFINITY;
  for (std::size_t k = first; k < first + CirclePoints; ++k)
  {
    const double value = values[k % CirclePoints];
    const double next = values[(k + 1) % CirclePoints];
    if (changesAfter(k % CirclePoints))
    {
      ring.angles.push_back(angleOf(static_cast<double>(k) + value / (value - next)));
      ring.amplitude = std::min(ring.amplitude, largest);
      largest = 0.0;
    }
    largest = std::max(largest, std::abs(next));
  }
  ring.amplitude = std::min(ring.amplitude, largest);
  ring.firstSectorIsAbove = values[(first + 1) % CirclePoints] >= 0.0;
  return ring;
}

/// A circle of a saddle: with at least four branches, and more values than errors between them.
std::optional<SaddleFinder::Ring> SaddleFinder::clearRing(double radius) const
{
  Ring ring = this->ringOf(radius);
  const bool isClear = ring.angles.size() >= 4 && ring.angles.size() <= MostBranches &&
    this->deviation_ <= LargestError * ring.amplitude;
  return radius < this->scale_ && isClear ? std::optional<Ring>(ring) : std::nullopt;
}

/// n of the 2 n branches on the smallest clear circle; 2 if there is none.
int SaddleFinder::orderHere(double step) const
{
  for (const double radius : Radii)
  {
    if (const std::optional<Ring> ring = this->clearRing(radius * step))
    {
      return static_cast<int>(ring->angles.size()) / 2;
    }
  }
  return 2;
}

bool SaddleFinder::refine(Vector3d& center, double step)
{
  const Vector3d start = center;
  for (int i = 0; i < CenterIterations && this->fitAt(center); ++i)
  {
    Vector2d way = this->stepToZero(this->orderHere(step));
    const double length = way.norm();
    if (!std::isfinite(length))
    {
      return false;
    }
    way *= std::min(1.0, step / length);
    center = this->center_ + this->axes_ * way;
    if ((center - start).norm() > FarthestCenter * step)
    {
      return false;
    }
    if (length <= CenterPrecision * step)
    {
      return true;
    }
  }
  return false;
}

std::optional<SaddleFan> SaddleFinder::fanOf(
  const Vector3d& center, const Ring& ring, const Station& nearby)
{
  SaddleFan fan{ {}, ring.radius, {}, ring.firstSectorIsAbove };
  for (const double angle : ring.angles)
  {
    const Vector3d outwards = this->axes_ * Vector2d(std::cos(angle), std::sin(angle));
    LevelSetPoint seed;
    seed.position = center + ring.radius * outwards;
    std::optional<Station> branch = this->walker_.start(seed);
    if (!branch ||
      !((branch->point.position - seed.position).norm() <= LargestShift * ring.radius) ||
      std::abs(branch->direction.dot(outwards)) < LeastOutwards)
    {
      return {};
    }
    if (branch->direction.dot(outwards) < 0.0)
    {
      branch->direction = -branch->direction;
      branch->point.normal = -branch->point.normal; // larger values stay to the left
    }
    fan.branches.push_back(*branch);
  }
  fan.center = this->walker_.endAt(center, nearby);
  return fan;
}

std::optional<SaddleFan> SaddleFinder::find(const Saddle& candidate, const Station& nearby)
{
  Vector3d center = candidate.position;
  if (!this->refine(center, nearby.step) || !this->fitAt(center))
  {
    return {};
  }
  const double uncertainty =
    std::max(CriticalFraction, std::min(LargestUncertainty, 5.0 * this->deviation_));
  if (std::abs(this->coefficients_[0]) > uncertainty &&
    std::abs(candidate.value - this->level_) > CriticalFraction)
  {
    return {};
  }
  const auto branchCount = 2 * static_cast<std::size_t>(this->orderHere(nearby.step));
  // The curves are the model's: they begin where its error is small, too.
  const double error = this->model_.center(this->center_) ? this->model_.deviation() : INFINITY;
  for (const double radius : Radii)
  {
    const std::optional<Ring> ring = this->clearRing(radius * nearby.step);
    std::optional<SaddleFan> fan =
      ring && ring->angles.size() == branchCount && error <= LargestError * ring->amplitude
      ? this->fanOf(this->center_, *ring, nearby)
      : std::nullopt;
    if (fan)
    {
      return fan;
    }
  }
  return {};
}

} // namespace SurfaceScalars
