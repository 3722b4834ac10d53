// The experiments of the smoothing paper on meshes that can be had: tables in Markdown for
// Documentation/smoothing-paper.md.
//
// usage: surface-scalars-smoothing-paper FOLDER     with the meshes of Utilities/fetch-data.sh

#include "PaperTables.h"

#include <cstdio>
#include <cstdlib>
#include <exception>

int main(int argc, char** argv)
{
  using namespace SurfaceScalars::Benchmark;
  if (argc != 2)
  {
    std::fprintf(stderr, "usage: %s FOLDER\n", argv[0]);
    return EXIT_FAILURE;
  }
  try
  {
    const PaperMeshes meshes(argv[1]);
    tabulateSimplification(meshes);
    tabulateTikhonov(meshes);
    tabulateMetrics(meshes);
    tabulateEpsilons(meshes);
    tabulateConstraints(meshes);
    tabulatePeers(meshes);
    tabulateGrowth();
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "%s\n", error.what());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
