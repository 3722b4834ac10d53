#pragma once

#include "PaperMeshes.h"

namespace SurfaceScalars::Benchmark
{

void tabulateSimplification(const PaperMeshes& meshes); ///< Fig. 2, 3
void tabulateTikhonov(const PaperMeshes& meshes);       ///< Fig. 4, 5, 9, 10
void tabulateMetrics(const PaperMeshes& meshes);        ///< Fig. 6, 7, 8
void tabulateConstraints(const PaperMeshes& meshes);    ///< Fig. 12, 13, 14, Table 1
void tabulateEpsilons(const PaperMeshes& meshes);       ///< Fig. 15
void tabulatePeers(const PaperMeshes& meshes);          ///< Fig. 16
void tabulateGrowth();                                  ///< Table 2

} // namespace SurfaceScalars::Benchmark
