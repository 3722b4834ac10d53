#include "NetworkComplement.h"

#include <algorithm>
#include <limits>

namespace SurfaceScalars
{
namespace
{

constexpr Index Network = std::numeric_limits<Index>::max();

/// The components of the free vertices.
class Components
{
public:
  Components(const MeshTopology& mesh, const std::vector<char>& isInNetwork)
    : numbers_(mesh.vertexCount(), Network)
  {
    std::vector<Index> reached;
    for (Index start = 0; start < mesh.vertexCount(); ++start)
    {
      if (isInNetwork[start] != 0 || this->numbers_[start] != Network)
      {
        continue;
      }
      this->numbers_[start] = this->count_;
      reached.assign(1, start);
      for (std::size_t next = 0; next < reached.size(); ++next)
      {
        for (const Index neighbor : mesh.link(reached[next]))
        {
          if (isInNetwork[neighbor] == 0 && this->numbers_[neighbor] == Network)
          {
            this->numbers_[neighbor] = this->count_;
            reached.push_back(neighbor);
          }
        }
      }
      ++this->count_;
    }
  }

  Index count() const { return this->count_; }
  Index operator[](Index vertex) const { return this->numbers_[vertex]; }

  /// V - E + F of what the free vertices span.
  std::vector<int> eulerCharacteristics(const MeshTopology& mesh) const
  {
    std::vector<int> result(this->count_, 0);
    for (Index vertex = 0; vertex < mesh.vertexCount(); ++vertex)
    {
      if (this->numbers_[vertex] != Network)
      {
        int& characteristic = result[this->numbers_[vertex]];
        ++characteristic;
        for (const Index neighbor : mesh.link(vertex))
        {
          characteristic -= neighbor > vertex && this->numbers_[neighbor] != Network ? 1 : 0;
        }
      }
    }
    for (Eigen::Index t = 0; t < mesh.triangles().cols(); ++t)
    {
      const auto corners = mesh.triangles().col(t);
      const Index number = this->numbers_[corners[0]];
      if (number != Network && this->numbers_[corners[1]] != Network &&
        this->numbers_[corners[2]] != Network)
      {
        ++result[number];
      }
    }
    return result;
  }

private:
  std::vector<Index> numbers_;
  Index count_ = 0;
};

} // namespace

bool complete(
  const MeshTopology& mesh, std::vector<char>& isInNetwork, const std::vector<PointIndex>& indices)
{
  const Components components(mesh, isInNetwork);
  std::vector<int> sums = components.eulerCharacteristics(mesh);
  std::vector<char> hasMaximum(components.count(), 0);
  std::vector<char> isPocket(components.count(), 0);
  std::transform(sums.begin(), sums.end(), isPocket.begin(),
    [](int characteristic) { return static_cast<char>(characteristic == 1 ? 1 : 0); });
  for (const PointIndex& point : indices)
  {
    const Index component = components[point.vertex];
    if (component == Network)
    {
      if (point.index != 0)
      {
        return false;
      }
      continue;
    }
    sums[component] -= point.index;
    hasMaximum[component] |= point.index > 0 ? 1 : 0;
    isPocket[component] = 0;
  }
  for (Index component = 0; component < components.count(); ++component)
  {
    if (isPocket[component] == 0 && (sums[component] != 0 || hasMaximum[component] == 0))
    {
      return false;
    }
  }
  for (Index vertex = 0; vertex < mesh.vertexCount(); ++vertex)
  {
    isInNetwork[vertex] |= isInNetwork[vertex] == 0 ? isPocket[components[vertex]] : 0;
  }
  return true;
}

} // namespace SurfaceScalars
