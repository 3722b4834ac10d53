#pragma once

#include "FunctionDesign.h"

namespace SurfaceScalars
{

/// @throws InvalidInput for parameters, or requests on a mesh, that designFunction() refuses
void checkDesign(const DesignParameters& parameters);
void checkRequests(
  const DesignMesh& mesh, const std::vector<CriticalRequest>& requests, const PlaceName& nameOf);

} // namespace SurfaceScalars
