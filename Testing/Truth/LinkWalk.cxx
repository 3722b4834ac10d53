#include "LinkWalk.h"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>

namespace SurfaceScalars::Truth
{
namespace
{

/// To which vertices a vertex of the link is joined by edges of the link.
using LinkEdges = std::map<int, std::vector<int>>;

OrderedLink walk(const LinkEdges& edges)
{
  int start = edges.begin()->first;
  for (const auto& [vertex, next] : edges)
  {
    if (next.size() == 1)
    {
      start = vertex;
    }
  }
  OrderedLink link{ { start }, edges.at(start).size() == 2 };
  int last = start;
  int here = edges.at(start).front();
  while (here != start)
  {
    link.vertices.push_back(here);
    const std::vector<int>& next = edges.at(here);
    if (next.size() == 1)
    {
      break;
    }
    const int ahead = next[next[0] == last ? 1 : 0];
    last = here;
    here = ahead;
  }
  return link;
}

} // namespace

std::vector<OrderedLink> orderedLinks(const TriangleMesh& mesh)
{
  std::vector<LinkEdges> edges(static_cast<std::size_t>(mesh.points.cols()));
  for (const auto& [a, b, c] : mesh.triangles)
  {
    for (const auto& [vertex, from, to] :
      { std::array<int, 3>{ a, b, c }, { b, c, a }, { c, a, b } })
    {
      edges[static_cast<std::size_t>(vertex)][from].push_back(to);
      edges[static_cast<std::size_t>(vertex)][to].push_back(from);
    }
  }
  std::vector<OrderedLink> links;
  for (const LinkEdges& around : edges)
  {
    const bool branches = std::any_of(
      around.begin(), around.end(), [](const auto& entry) { return entry.second.size() > 2; });
    if (!branches)
    {
      links.push_back(walk(around));
    }
    if (branches || links.back().vertices.size() != around.size())
    {
      throw std::runtime_error("no manifold at vertex " + std::to_string(&around - edges.data()));
    }
  }
  return links;
}

std::vector<VertexType> typesByWalking(
  const std::vector<OrderedLink>& links, const ValuesRef& values)
{
  std::vector<VertexType> types;
  for (const auto& [link, isClosed] : links)
  {
    const auto vertex = static_cast<int>(types.size());
    const auto isAbove = [&, vertex](int neighbor)
    {
      return values[neighbor] != values[vertex] ? values[neighbor] > values[vertex]
                                                : neighbor > vertex;
    };
    std::vector<int> around = link;
    if (!isClosed)
    {
      around.insert(around.end(), link.rbegin(), link.rend());
    }
    int changes = 0;
    for (std::size_t i = 0; i < around.size(); ++i)
    {
      changes += isAbove(around[i]) != isAbove(around[(i + 1) % around.size()]) ? 1 : 0;
    }
    if (changes == 0)
    {
      types.push_back({ isAbove(link[0]) ? CriticalType::Minimum : CriticalType::Maximum, 1 });
    }
    else
    {
      types.push_back(
        { changes > 2 ? CriticalType::Saddle : CriticalType::Regular, changes / 2 - 1 });
    }
  }
  return types;
}

} // namespace SurfaceScalars::Truth
