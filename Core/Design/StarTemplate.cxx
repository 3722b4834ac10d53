#include "StarTemplate.h"

#include "LinkNormal.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <complex>
#include <iterator>

namespace SurfaceScalars
{
namespace
{

constexpr double LeastRatio = 0.3; // of the smaller curvature to the larger
constexpr double Flat = 1e-6;      // of the least curvature: a direction less curved means nothing

using Complex = std::complex<double>; ///< a place in the tangent plane

/// The tangent plane at a vertex; its real axis points to the first vertex of the link, which runs
/// counterclockwise.
class TangentPlane
{
public:
  TangentPlane(const PointsRef& vertices, const MeshTopology& mesh, Index vertex)
    : origin_(vertices.col(vertex))
  {
    const Vector3d first = vertices.col(*mesh.linkPath(vertex).begin()) - this->origin_;
    Vector3d normal = linkNormal(vertices, mesh, vertex);
    normal = normal.norm() > 0.0 ? Vector3d(normal.normalized()) : first.unitOrthogonal();
    const Vector3d along = first - first.dot(normal) * normal;
    this->u_ = along.norm() > 0.0 ? Vector3d(along.normalized()) : normal.unitOrthogonal();
    this->v_ = normal.cross(this->u_);
  }

  Complex project(const Vector3d& offset) const
  {
    return { offset.dot(this->u_), offset.dot(this->v_) };
  }
  /// Its distance is kept.
  Complex place(const Vector3d& point) const
  {
    const Vector3d offset = point - this->origin_;
    return std::polar(offset.norm(), std::arg(this->project(offset)));
  }

private:
  Vector3d origin_;
  Vector3d u_;
  Vector3d v_;
};

/// From 0 to 2 pi.
double positiveAngle(const Complex& place)
{
  const double angle = std::arg(place);
  return angle < 0.0 ? angle + 2.0 * Pi : angle;
}

/// The link and the links of its vertices, without the vertex.
std::vector<Index> surroundings(const MeshTopology& mesh, Index vertex)
{
  std::vector<Index> result;
  for (const Index neighbor : mesh.link(vertex))
  {
    result.push_back(neighbor);
    const VertexRange link = mesh.link(neighbor);
    std::copy_if(link.begin(), link.end(), std::back_inserter(result),
      [&](Index other) { return other != vertex; });
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

class TemplateBuilder
{
public:
  TemplateBuilder(const PointsRef& vertices, const MeshTopology& mesh, const StarPattern& pattern)
    : vertices_(vertices)
    , mesh_(mesh)
    , pattern_(pattern)
    , plane_(vertices, mesh, pattern.vertex)
    , isBoundary_(mesh.isBoundary(pattern.vertex))
    , total_(positiveAngle(this->placeOf(mesh.linkPath(pattern.vertex).last[-1])))
  {
  }

  /// Least squares of a linear function and r^2 (mean + Re(conj(ellipse) e^2ia) +
  /// Re(conj(waves) e^i turned(a))), the last only if it is something else; the least of equals.
  void fit(const ValuesRef& field);
  std::vector<double> differences() const;

private:
  Complex placeOf(Index vertex) const { return this->plane_.place(this->vertices_.col(vertex)); }
  bool isSaddle() const { return this->pattern_.type == CriticalType::Saddle; }
  bool isQuadratic() const
  {
    return !this->isSaddle() || (this->pattern_.multiplicity == 1 && !this->isBoundary_);
  }
  /// The phase of a saddle's waves.
  double turned(const Complex& place) const
  {
    const int waves = this->pattern_.multiplicity + 1;
    return this->isBoundary_ ? waves * Pi * positiveAngle(place) / this->total_
                             : waves * std::arg(place);
  }
  double phaseOf(const Complex& waves) const;
  double quadraticDifference(const Complex& place) const;

  const PointsRef& vertices_;
  const MeshTopology& mesh_;
  const StarPattern& pattern_;
  TangentPlane plane_;
  bool isBoundary_;
  double total_; ///< angle of a vertex on the boundary
  double mean_ = 0.0;
  Complex ellipse_;
  Complex waves_;
};

void TemplateBuilder::fit(const ValuesRef& field)
{
  const std::vector<Index> around = surroundings(this->mesh_, this->pattern_.vertex);
  double size = 0.0; // as the unit of length, with which all terms are comparable
  for (const Index vertex : around)
  {
    size = std::max(size, std::abs(this->placeOf(vertex)));
  }
  Eigen::MatrixXd terms(around.size(), this->isQuadratic() ? 5 : 7);
  for (std::size_t i = 0; i < around.size(); ++i)
  {
    const Complex place = this->placeOf(around[i]) / size;
    const Complex square = place * place;
    auto row = terms.row(static_cast<Eigen::Index>(i));
    row.head<5>() << place.real(), place.imag(), std::norm(place), square.real(), square.imag();
    if (!this->isQuadratic())
    {
      const Complex wave = std::polar(std::norm(place), this->turned(place));
      row.tail<2>() << wave.real(), this->isBoundary_ ? 0.0 : wave.imag();
    }
  }
  const Values differences = field(around).array() - field[this->pattern_.vertex];
  const Values fitted = terms.completeOrthogonalDecomposition().solve(differences) / (size * size);
  this->mean_ = fitted[2];
  this->ellipse_ = { fitted[3], fitted[4] };
  if (!this->isQuadratic())
  {
    this->waves_ = { fitted[5], fitted[6] };
  }
}

/// Where f has waves of this many, theirs; else such that f rises towards the other places, the
/// nearest first.
double TemplateBuilder::phaseOf(const Complex& waves) const
{
  if (std::abs(waves) > Flat * this->pattern_.leastCurvature)
  {
    return std::arg(waves);
  }
  Complex sum;
  for (const Vector3d& offset : this->pattern_.others)
  {
    sum += std::polar(1.0 / offset.squaredNorm(), this->turned(this->plane_.project(offset)));
  }
  return this->isBoundary_ ? 0.0 : std::arg(sum);
}

double TemplateBuilder::quadraticDifference(const Complex& place) const
{
  double lower = this->mean_ - std::abs(this->ellipse_);
  double upper = this->mean_ + std::abs(this->ellipse_);
  const double largest =
    std::max({ std::abs(lower), std::abs(upper), this->pattern_.leastCurvature });
  if (this->pattern_.type == CriticalType::Maximum)
  {
    upper = std::min(upper, -LeastRatio * largest);
    lower = std::min(lower, -LeastRatio * largest);
  }
  else
  {
    upper = std::max(upper, LeastRatio * largest);
    lower = this->isSaddle() ? std::min(lower, -LeastRatio * largest)
                             : std::max(lower, LeastRatio * largest);
  }
  const double phase = this->phaseOf(this->ellipse_);
  return 0.5 * std::norm(place) *
    (upper + lower + (upper - lower) * std::cos(2.0 * std::arg(place) - phase));
}

std::vector<double> TemplateBuilder::differences() const
{
  std::vector<double> result;
  const double height =
    std::max(std::abs(this->mean_) + std::abs(this->ellipse_), this->pattern_.leastCurvature);
  for (const Index neighbor : this->mesh_.link(this->pattern_.vertex))
  {
    const Complex place = this->placeOf(neighbor);
    result.push_back(this->isQuadratic()
        ? this->quadraticDifference(place)
        : height * std::norm(place) * std::cos(this->turned(place) - this->phaseOf(this->waves_)));
  }
  return result;
}

} // namespace

std::vector<double> starTemplate(const PointsRef& vertices, const MeshTopology& mesh,
  const ValuesRef& field, const StarPattern& pattern)
{
  TemplateBuilder builder(vertices, mesh, pattern);
  builder.fit(field);
  return builder.differences();
}

} // namespace SurfaceScalars
