#include "MeshCriticalPoints.h"
#include "MeshValues.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace SurfaceScalars
{
namespace
{

constexpr std::size_t Grain = 16384;

/// The differences of f from a vertex to those of its link.
class LinkDifferences
{
public:
  void set(const MeshTopology& mesh, const ValuesRef& values, Index vertex)
  {
    this->isClosed_ = !mesh.isBoundary(vertex);
    this->differences_.clear();
    this->magnitudes_.clear();
    for (const Index neighbor : mesh.link(vertex))
    {
      const double difference = values[neighbor] - values[vertex];
      this->differences_.push_back(difference);
      this->magnitudes_.push_back(std::abs(difference));
    }
  }

  double ofExtremum() const
  {
    return *std::min_element(this->magnitudes_.begin(), this->magnitudes_.end());
  }

  /// The largest magnitude that may be asked of differences without that the saddle is lost.
  double ofSaddle()
  {
    std::sort(this->magnitudes_.begin(), this->magnitudes_.end());
    const auto lost = std::partition_point(this->magnitudes_.begin(), this->magnitudes_.end(),
      [this](double least) { return this->isSaddle(least); });
    return lost == this->magnitudes_.begin() ? 0.0 : lost[-1];
  }

private:
  /// Whether the signs of the differences of at least this magnitude change often enough.
  bool isSaddle(double least) const
  {
    int changes = 0;
    double first = 0.0;
    double last = 0.0;
    for (const double difference : this->differences_)
    {
      if (difference != 0.0 && std::abs(difference) >= least)
      {
        first = first == 0.0 ? difference : first;
        changes += last * difference < 0.0 ? 1 : 0;
        last = difference;
      }
    }
    return this->isClosed_ ? changes + (first * last < 0.0 ? 1 : 0) >= 4 : changes >= 2;
  }

  bool isClosed_ = true;
  std::vector<double> differences_;
  std::vector<double> magnitudes_;
};

} // namespace

Values deltaThresholds(const MeshTopology& mesh, const ValuesRef& values, const VertexTypes& types,
  const Execution& execution)
{
  checkVertexValues(mesh.vertexCount(), values);
  Values thresholds = Values::Zero(values.size());
  parallelFor(mesh.vertexCount(), Grain, execution,
    [&](std::size_t begin, std::size_t end)
    {
      LinkDifferences differences;
      for (auto vertex = static_cast<Index>(begin); vertex < end; ++vertex)
      {
        const CriticalType type = types.types[vertex];
        if (type != CriticalType::Regular)
        {
          differences.set(mesh, values, vertex);
          thresholds[vertex] =
            type == CriticalType::Saddle ? differences.ofSaddle() : differences.ofExtremum();
        }
      }
    });
  return thresholds;
}

} // namespace SurfaceScalars
