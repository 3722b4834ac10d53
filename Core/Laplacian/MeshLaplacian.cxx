#include "Laplacian.h"
#include "Require.h"
#include "RowScaling.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace SurfaceScalars
{
namespace
{

/// Slimmer triangles count as being as high as this, in longest edges.
constexpr double LeastHeight = 1e-8;

using Matrix = Eigen::SparseMatrix<double>;
using Triplet = Eigen::Triplet<double, int>;

/// One triangle as its corners see it.
struct Corners
{
  Corners(const PointsRef& vertices, const Eigen::Matrix<Index, 3, 1>& triangle)
  {
    for (int c = 0; c < 3; ++c)
    {
      this->vertex[c] = static_cast<int>(triangle[c]);
      this->edge[c] = vertices.col(triangle[(c + 2) % 3]) - vertices.col(triangle[(c + 1) % 3]);
    }
    const double longest =
      std::sqrt(std::max({ edge[0].squaredNorm(), edge[1].squaredNorm(), edge[2].squaredNorm() }));
    this->area = edge[0].cross(edge[1]).norm() / 2;
    this->leastLength = LeastHeight * longest;
    this->countedArea = std::max(this->area, this->leastLength * longest / 2);
  }

  bool isPoint() const { return this->countedArea <= 0.0; }
  double cosine(int c) const
  {
    return -edge[(c + 1) % 3].dot(edge[(c + 2) % 3]);
  } ///< times lengths
  double length(int c) const { return std::max(this->edge[c].norm(), this->leastLength); }
  double cotangent(int c) const { return this->cosine(c) / (2 * this->countedArea); }
  double tangentOfHalf(int c) const
  {
    return (this->length((c + 1) % 3) * this->length((c + 2) % 3) - this->cosine(c)) /
      (2 * this->countedArea);
  }

  std::array<int, 3> vertex{};
  std::array<Vector3d, 3> edge; ///< opposite to the corner
  double area;
  double leastLength;
  double countedArea; ///< what is divided by
};

void checkInput(const PointsRef& vertices, const Triangles& triangles, LaplacianWeights weights)
{
  require(weights == LaplacianWeights::Cotangent ||
      weights == LaplacianWeights::NormalizedCotangent || weights == LaplacianWeights::MeanValue,
    "weights of triangles (Cotangent 3, NormalizedCotangent 4 or MeanValue 5)",
    std::to_string(static_cast<int>(weights)), "Choose one of these.");
  require(triangles.cols() > 0, "triangles", "none", "Choose an input with triangles.");
  require(
    vertices.allFinite(), "finite vertices", "a coordinate that is not", "Remove such vertices.");
  const Index greatest = triangles.maxCoeff();
  require(greatest < vertices.cols(),
    "corners below " + std::to_string(vertices.cols()) + ", the number of vertices",
    std::to_string(greatest), "Correct the triangles.");
}

class MeshAssembler
{
public:
  MeshAssembler(const PointsRef& vertices, const Triangles& triangles, bool meanValue,
    const Execution& execution)
    : areas_(Values::Zero(vertices.cols()))
    , diagonal_(Values::Zero(vertices.cols()))
  {
    this->entries_.reserve(static_cast<std::size_t>(6 * triangles.cols() + vertices.cols()));
    for (Eigen::Index t = 0; t < triangles.cols(); ++t)
    {
      this->add(Corners(vertices, triangles.col(t)), meanValue);
      if (t % 65536 == 0)
      {
        execution.report(0.5 * static_cast<double>(t) / static_cast<double>(triangles.cols()));
      }
    }
    for (int i = 0; i < static_cast<int>(vertices.cols()); ++i)
    {
      this->entries_.emplace_back(i, i, this->diagonal_[i]);
    }
  }

  const Values& areas() const { return this->areas_; }

  Matrix stiffness() const
  {
    Matrix result(this->areas_.size(), this->areas_.size());
    result.setFromTriplets(this->entries_.begin(), this->entries_.end());
    return result;
  }

private:
  void add(const Corners& corners, bool meanValue)
  {
    if (corners.isPoint())
    {
      return;
    }
    for (int c = 0; c < 3; ++c)
    {
      this->areas_[corners.vertex[c]] += corners.area / 3;
      const int next = (c + 1) % 3;
      const int last = (c + 2) % 3;
      if (meanValue)
      {
        const double tangent = corners.tangentOfHalf(c);
        this->link(corners.vertex[c], corners.vertex[next], tangent / corners.length(last));
        this->link(corners.vertex[c], corners.vertex[last], tangent / corners.length(next));
      }
      else
      {
        const double half = corners.cotangent(c) / 2;
        this->link(corners.vertex[next], corners.vertex[last], half);
        this->link(corners.vertex[last], corners.vertex[next], half);
      }
    }
  }

  void link(int from, int to, double weight)
  {
    this->entries_.emplace_back(from, to, -weight);
    this->diagonal_[from] += weight;
  }

  Values areas_;
  Values diagonal_;
  std::vector<Triplet> entries_;
};

/// For a row of mean value weights: what makes sum w (f_j - f_i) the integral of the Laplacian over
/// the area, if the directions of the edges are evenly distributed.
Values meanValueScales(const Matrix& weights, const PointsRef& vertices, const Values& areas)
{
  Values moments = Values::Zero(areas.size());
  for (int j = 0; j < weights.cols(); ++j)
  {
    for (Matrix::InnerIterator entry(weights, j); entry; ++entry)
    {
      moments[entry.row()] -=
        entry.value() * (vertices.col(entry.row()) - vertices.col(j)).squaredNorm();
    }
  }
  return (moments.array() > 0.0).select(4.0 * areas.array() / moments.array(), 0.0);
}

/// The mean in place of what is not positive.
Values positive(const Values& mass)
{
  const double mean = mass.sum() / static_cast<double>(mass.size());
  return (mass.array() > 0.0).select(mass, mean);
}

} // namespace

Laplacian meshLaplacian(const PointsRef& vertices, const Triangles& triangles,
  LaplacianWeights weights, const Execution& execution)
{
  checkInput(vertices, triangles, weights);
  const bool meanValue = weights == LaplacianWeights::MeanValue;
  const MeshAssembler assembler(vertices, triangles, meanValue, execution);
  require(assembler.areas().sum() > 0.0, "triangles with an area",
    std::to_string(triangles.cols()) + " without", "Choose another input.");

  Laplacian result;
  result.stiffness = assembler.stiffness();
  execution.report(0.9);
  result.symmetric = !meanValue;
  result.mass =
    positive(weights == LaplacianWeights::NormalizedCotangent ? Values(result.stiffness.diagonal())
                                                              : assembler.areas());
  if (meanValue)
  {
    result.stiffness =
      scaleRows(result.stiffness, meanValueScales(result.stiffness, vertices, result.mass));
  }
  execution.report(1.0);
  return result;
}

} // namespace SurfaceScalars
