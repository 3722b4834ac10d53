#include <SurfaceScalars/Error.h>
#include <SurfaceScalars/LevelSets.h>
#include <SurfaceScalars/NeighborGraph.h>

#include <cstdlib>

// The core links, runs, and its errors are caught across the library's boundary.
int main()
{
  const SurfaceScalars::Points points = SurfaceScalars::Points::Random(3, 100);
  const SurfaceScalars::NeighborGraph graph(points, SurfaceScalars::NeighborQuery{});
  if (graph.pointCount() != 100)
  {
    return EXIT_FAILURE;
  }

  try
  {
    const SurfaceScalars::Points equal = SurfaceScalars::Points::Ones(3, 100);
    const SurfaceScalars::NeighborGraph refused(equal, SurfaceScalars::NeighborQuery{});
  }
  catch (const SurfaceScalars::InvalidInput&)
  {
    return EXIT_SUCCESS;
  }
  return EXIT_FAILURE;
}
