#include "TriangleMesh.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace SurfaceScalars::Truth
{
namespace
{

using Edge = std::pair<int, int>;

std::vector<Edge> edgesOf(const TriangleMesh& mesh)
{
  std::vector<Edge> edges;
  for (const std::array<int, 3>& triangle : mesh.triangles)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const auto [low, high] = std::minmax({ triangle[i], triangle[(i + 1) % 3] });
      edges.emplace_back(low, high);
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

/// The place of every vertex in the order of the values, ties by index.
std::vector<int> rankByValue(const ValuesRef& values)
{
  std::vector<int> order(static_cast<std::size_t>(values.size()));
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return values[a] < values[b]; });
  std::vector<int> rank(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    rank[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
  }
  return rank;
}

/// Numbers of the vertices in the order of a sweep, and what the sweep has joined so far.
class Components
{
public:
  explicit Components(std::size_t count)
    : parents_(count)
  {
    std::iota(this->parents_.begin(), this->parents_.end(), 0);
  }

  /// The first vertex of the component.
  int root(int vertex)
  {
    while (this->parent(vertex) != vertex)
    {
      vertex = this->parent(vertex) = this->parent(this->parent(vertex));
    }
    return vertex;
  }

  void join(int older, int younger) { this->parent(younger) = older; }

private:
  int& parent(int vertex) { return this->parents_[static_cast<std::size_t>(vertex)]; }
  std::vector<int> parents_;
};

/// A component that began at one place of the order of a sweep and ended at another.
struct Lifetime
{
  int begin;
  int end;
};

/// Of the components of the edges among the first vertices of the sweep, for ever more of them.
std::vector<Lifetime> sweep(const std::vector<Edge>& edges, const std::vector<int>& rank)
{
  std::vector<std::vector<int>> earlier(rank.size());
  for (const Edge& edge : edges)
  {
    const auto [low, high] = std::minmax(
      { rank[static_cast<std::size_t>(edge.first)], rank[static_cast<std::size_t>(edge.second)] });
    earlier[static_cast<std::size_t>(high)].push_back(low);
  }
  Components components(rank.size());
  std::vector<Lifetime> lifetimes;
  for (int vertex = 0; vertex < static_cast<int>(rank.size()); ++vertex)
  {
    for (const int neighbor : earlier[static_cast<std::size_t>(vertex)])
    {
      const auto [older, younger] =
        std::minmax({ components.root(vertex), components.root(neighbor) });
      if (older == younger)
      {
        continue;
      }
      components.join(older, younger);
      if (younger != vertex)
      {
        lifetimes.push_back({ younger, vertex });
      }
    }
  }
  return lifetimes;
}

/// In how many of its triangles a vertex is the lowest, the middle and the highest.
using Places = std::array<int, 3>;

std::vector<Places> placesInTriangles(const TriangleMesh& mesh, const std::vector<int>& rank)
{
  std::vector<Places> places(rank.size(), Places{ 0, 0, 0 });
  for (std::array<int, 3> triangle : mesh.triangles)
  {
    std::sort(triangle.begin(), triangle.end(),
      [&](int a, int b)
      { return rank[static_cast<std::size_t>(a)] < rank[static_cast<std::size_t>(b)]; });
    for (std::size_t i = 0; i < 3; ++i)
    {
      ++places[static_cast<std::size_t>(triangle[i])][i];
    }
  }
  return places;
}

CriticalType typeOf(const Places& places)
{
  if (places[1] > 0)
  {
    return places[1] > 2 ? CriticalType::Saddle : CriticalType::Regular;
  }
  return places[0] > 0 ? CriticalType::Minimum
    : places[2] > 0    ? CriticalType::Maximum
                       : CriticalType::Excluded;
}

/// Adds the persistence of every pair of a sweep to its two vertices.
void addPairs(std::vector<std::vector<double>>& persistences, const std::vector<Edge>& edges,
  const std::vector<int>& rank, const ValuesRef& values)
{
  std::vector<std::size_t> order(rank.size());
  for (std::size_t i = 0; i < rank.size(); ++i)
  {
    order[static_cast<std::size_t>(rank[i])] = i;
  }
  for (const Lifetime& lifetime : sweep(edges, rank))
  {
    const std::size_t extremum = order[static_cast<std::size_t>(lifetime.begin)];
    const std::size_t saddle = order[static_cast<std::size_t>(lifetime.end)];
    const double persistence = std::abs(
      values[static_cast<Eigen::Index>(saddle)] - values[static_cast<Eigen::Index>(extremum)]);
    persistences[extremum].push_back(persistence);
    persistences[saddle].push_back(persistence);
  }
}

constexpr std::streamsize RestOfLine = std::numeric_limits<std::streamsize>::max();

std::istringstream withoutComments(const std::string& fileName)
{
  std::ifstream file(fileName);
  std::string text;
  for (std::string line; std::getline(file, line);)
  {
    text += line.substr(0, line.find('#')) + '\n';
  }
  return std::istringstream(text);
}

/// As a fan around its first corner. What else is in the line is a color.
void addFace(TriangleMesh& mesh, std::istream& file)
{
  int count = 0;
  std::array<int, 3> triangle{};
  file >> count >> triangle[0] >> triangle[2];
  for (int corner = 2; corner < count; ++corner)
  {
    triangle[1] = triangle[2];
    file >> triangle[2];
    mesh.triangles.push_back(triangle);
  }
  file.ignore(RestOfLine, '\n');
}

} // namespace

int TriangleMesh::eulerCharacteristic() const
{
  std::vector<char> used(static_cast<std::size_t>(this->points.cols()), 0);
  for (const std::array<int, 3>& triangle : this->triangles)
  {
    for (const int vertex : triangle)
    {
      used[static_cast<std::size_t>(vertex)] = 1;
    }
  }
  return static_cast<int>(std::count(used.begin(), used.end(), 1)) -
    static_cast<int>(edgesOf(*this).size()) + static_cast<int>(this->triangles.size());
}

TriangleMesh readOff(const std::string& fileName)
{
  std::istringstream file = withoutComments(fileName);
  std::string word;
  int pointCount = 0;
  int faceCount = 0;
  int edgeCount = 0;
  if (!(file >> word >> pointCount >> faceCount >> edgeCount) || (word != "OFF" && word != "COFF"))
  {
    throw std::runtime_error(fileName + " is not in OFF format");
  }
  TriangleMesh mesh;
  mesh.points.resize(3, pointCount);
  for (Eigen::Index i = 0; i < pointCount; ++i)
  {
    file >> mesh.points(0, i) >> mesh.points(1, i) >> mesh.points(2, i);
    if (word == "COFF")
    {
      file.ignore(RestOfLine, '\n');
    }
  }
  for (int face = 0; face < faceCount; ++face)
  {
    addFace(mesh, file);
  }
  if (!file)
  {
    throw std::runtime_error(fileName + " ends early");
  }
  return mesh;
}

TriangleMesh readCentered(const std::string& fileName)
{
  TriangleMesh mesh = readOff(fileName);
  const Vector3d low = mesh.points.rowwise().minCoeff();
  const Vector3d high = mesh.points.rowwise().maxCoeff();
  mesh.points = (mesh.points.colwise() - 0.5 * (low + high)) * (2.0 / (high - low).norm());
  return mesh;
}

std::vector<CriticalPoint> meshCriticalPoints(const TriangleMesh& mesh, const ValuesRef& values)
{
  const std::vector<Edge> edges = edgesOf(mesh);
  std::vector<int> rank = rankByValue(values);
  const std::vector<Places> places = placesInTriangles(mesh, rank);
  std::vector<std::vector<double>> persistences(rank.size());
  addPairs(persistences, edges, rank, values);
  for (int& place : rank)
  {
    place = static_cast<int>(values.size()) - 1 - place; // downwards
  }
  addPairs(persistences, edges, rank, values);

  std::vector<CriticalPoint> critical;
  for (std::size_t vertex = 0; vertex < places.size(); ++vertex)
  {
    CriticalPoint point;
    point.type = typeOf(places[vertex]);
    if (point.type == CriticalType::Regular || point.type == CriticalType::Excluded)
    {
      continue;
    }
    const auto column = static_cast<Eigen::Index>(vertex);
    point.position = mesh.points.col(column);
    point.multiplicity = point.type == CriticalType::Saddle ? places[vertex][1] / 2 - 1 : 1;
    point.value = values[column];
    point.input = vertex;
    const std::vector<double>& ended = persistences[vertex];
    point.persistence = static_cast<int>(ended.size()) < point.multiplicity
      ? values.maxCoeff() - values.minCoeff()
      : *std::max_element(ended.begin(), ended.end());
    critical.push_back(point);
  }
  return critical;
}

} // namespace SurfaceScalars::Truth
