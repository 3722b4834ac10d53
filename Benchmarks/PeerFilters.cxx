#include "PeerFilters.h"

#include <cmath>
#include <vector>

namespace SurfaceScalars::Benchmark
{
namespace
{

constexpr double PassBandFrequency = 0.1; ///< 1 / lambda + 1 / mu, as Taubin suggests

/// The vertices within a radius that edges within it lead to.
class MeshBall
{
public:
  MeshBall(const PointsRef& vertices, const MeshTopology& mesh)
    : vertices_(vertices)
    , mesh_(mesh)
    , lastVisit_(mesh.vertexCount(), -1)
  {
  }

  const std::vector<Index>& around(Index center, double radius)
  {
    this->ball_.assign(1, center);
    this->lastVisit_[center] = center;
    for (std::size_t i = 0; i < this->ball_.size(); ++i)
    {
      for (const Index neighbor : this->mesh_.link(this->ball_[i]))
      {
        if (this->lastVisit_[neighbor] != center &&
          (this->vertices_.col(neighbor) - this->vertices_.col(center)).norm() <= radius)
        {
          this->lastVisit_[neighbor] = center;
          this->ball_.push_back(neighbor);
        }
      }
    }
    return this->ball_;
  }

private:
  const PointsRef& vertices_;
  const MeshTopology& mesh_;
  std::vector<std::int64_t> lastVisit_;
  std::vector<Index> ball_;
};

} // namespace

Values lowPass(const Laplacian& laplacian, const ValuesRef& values, int passPairs, double lambda)
{
  const Values scale = laplacian.stiffness.diagonal().cwiseInverse();
  const double mu = 1.0 / (PassBandFrequency - 1.0 / lambda);
  Values result = values;
  for (int pass = 0; pass < 2 * passPairs; ++pass)
  {
    const Values change = scale.cwiseProduct(laplacian.stiffness * result);
    result -= (pass % 2 == 0 ? lambda : mu) * change;
  }
  return result;
}

Values salientSmoothing(const PointsRef& vertices, const MeshTopology& mesh,
  const ValuesRef& values, const SalientParameters& parameters)
{
  const auto weight = [](double squared, double variance)
  { return std::exp(-squared / (2.0 * variance)); };

  MeshBall ball(vertices, mesh);
  Values current = values;
  for (int step = 0; step < parameters.steps; ++step)
  {
    Values next = current;
    for (Index vertex = 0; vertex < mesh.vertexCount(); ++vertex)
    {
      double sum = 0.0;
      double weights = 0.0;
      for (const Index neighbor : ball.around(vertex, parameters.radius))
      {
        const double difference = current[neighbor] - current[vertex];
        const double w =
          weight((vertices.col(neighbor) - vertices.col(vertex)).squaredNorm(), parameters.spread) *
          weight(difference * difference, parameters.range);
        sum += w * difference;
        weights += w;
      }
      next[vertex] += sum / weights;
    }
    current = next;
  }
  return current;
}

} // namespace SurfaceScalars::Benchmark
