// Whether designed functions have the critical points that are asked for, and which others, as
// tables in Markdown.

#include "FunctionDesign.h"
#include "LinkWalk.h"
#include "MarkdownReport.h"
#include "MeshExamples.h"
#include "MeshFunctions.h"

#include <chrono>
#include <cstring>

using namespace SurfaceScalars;
using namespace SurfaceScalars::Truth;

namespace
{
struct Way
{
  const char* name;
  DesignParameters p;
};

std::vector<CriticalRequest> randomRequests(const MeshTopology& topology, unsigned seed)
{
  Random random(seed);
  std::vector<CriticalRequest> result;
  const int count = 2 + static_cast<int>(random.uniform() * 19);
  const bool given = seed % 2 == 0;
  std::vector<char> used(topology.vertexCount(), 0);
  while (static_cast<int>(result.size()) < count)
  {
    CriticalRequest r;
    r.vertex = static_cast<Index>(random.uniform() * topology.vertexCount());
    bool bad = used[r.vertex];
    for (Index n : topology.link(r.vertex))
      bad = bad || used[n];
    if (bad)
      continue;
    const int t = static_cast<int>(random.uniform() * 3);
    r.type = t == 0 ? CriticalType::Minimum : t == 1 ? CriticalType::Saddle : CriticalType::Maximum;
    if (t == 1)
    {
      const int m = 1 + static_cast<int>(random.uniform() * 3);
      r.multiplicity = std::min<int>(m, (int(topology.link(r.vertex).size()) - 2) / 2);
      if (r.multiplicity < 1)
        continue;
    }
    if (given)
      r.value = random.uniform();
    used[r.vertex] = 1;
    for (Index n : topology.link(r.vertex))
      used[n] = 1;
    result.push_back(r);
  }
  return result;
}
}

int main(int argc, char** argv)
{
  MarkdownReport report;
  std::vector<std::pair<std::string, TriangleMesh>> meshes;
  meshes.push_back({ "sphere", subdividedSphere(5) });
  {
    Mesh t = torusMesh(100, true);
    TriangleMesh m;
    m.points = t.vertices;
    for (auto c : t.triangles.colwise())
      m.triangles.push_back({ int(c[0]), int(c[1]), int(c[2]) });
    meshes.push_back({ "torus", m });
  }
  meshes.push_back({ "genus 2", plateWithHoles(2, 4) });
  for (int i = 2; i < argc; ++i)
    meshes.push_back({ argv[i], readOff(argv[i]) });
  std::vector<Way> ways;
  auto add = [&](const char* n, auto f)
  {
    Way w{ n, {} };
    f(w.p);
    ways.push_back(w);
  };
  add("biharmonic", [](auto&) {});
  add("biharmonic mass", [](auto& p) { p.metric = DataMetric::MassMatrix; });
  add("harmonic", [](auto& p) { p.energy = SmoothingEnergy::Harmonic; });
  add("LS L-curve", [](auto& p) { p.constraints = DesignConstraints::LeastSquares; });
  for (double e : { 1e5, 1e7, 1e9, 1e11 })
  {
    static std::vector<std::string> keep;
    keep.reserve(10);
    keep.push_back("LS eps " + number("%.0e", e));
    add(keep.back().c_str(),
      [e](auto& p)
      {
        p.constraints = DesignConstraints::LeastSquares;
        p.epsilonChoice = EpsilonChoice::Manual;
        p.epsilon = e;
      });
  }
  add("cubic", [](auto& p) { p.approach = DesignApproach::Meshless; });
  add("gauss",
    [](auto& p)
    {
      p.approach = DesignApproach::Meshless;
      p.kernel = KernelType::Gaussian;
    });
  add("1/r",
    [](auto& p)
    {
      p.approach = DesignApproach::Meshless;
      p.kernel = KernelType::Harmonic;
    });
  const int trials = std::atoi(argv[1]);
  for (auto& [name, mesh] : meshes)
  {
    DesignMesh design(mesh.points, trianglesOf(mesh));
    report.head(name + " n=" + std::to_string(mesh.points.cols()) + " chi " +
        std::to_string(design.topology().eulerCharacteristic()),
      { "way", "kept", "added", "missing after cleanup", "added after", "necessary", "refused",
        "s" });
    for (const Way& way : ways)
    {
      int asked = 0, kept = 0, added = 0, keptAfter = 0, addedAfter = 0, refused = 0, necessary = 0;
      std::string why;
      const auto t0 = std::chrono::steady_clock::now();
      for (int trial = 0; trial < trials; ++trial)
      {
        const auto requests = randomRequests(design.topology(), trial + 1);
        try
        {
          const auto f = designFunction(design, requests, way.p);
          DesignParameters q = way.p;
          q.cleanUp = true;
          const auto g = designFunction(design, requests, q);
          asked += requests.size();
          kept += requests.size() - f.missing.size();
          added += f.critical.points.size() - (requests.size() - f.missing.size());
          keptAfter += requests.size() - g.missing.size();
          addedAfter += g.critical.points.size() - (requests.size() - g.missing.size());
          int sum = 0, mi = 0, ma = 0;
          for (auto& r : requests)
          {
            sum += indexOf(r.type, r.multiplicity);
            mi += r.type == CriticalType::Minimum;
            ma += r.type == CriticalType::Maximum;
          }
          int need =
            std::abs(int(design.topology().eulerCharacteristic()) - sum - !mi - !ma) + !mi + !ma;
          necessary += need;
        }
        catch (const std::exception& e)
        {
          ++refused;
          why = e.what();
        }
      }
      const double s = std::chrono::duration<double>(std::chrono::steady_clock::now() - t0).count();
      report.row({ way.name, ofAll(kept, asked), std::to_string(added),
        std::to_string(asked - keptAfter), std::to_string(addedAfter), std::to_string(necessary),
        std::to_string(refused) + " " + why, number("%.2f", s / trials / 2) });
    }
  }
  return 0;
}
