#pragma once

#include "Basics.h"

#include <vector>

/// Random points on the torus R = 1, r = 0.4, in random order; made once for each count.
const SurfaceScalars::Points& torusCloud(int count);

/// The height of those points in a tilted direction.
const SurfaceScalars::Values& tiltedHeight(int count);

/// Twenty values that divide the range of that height evenly.
std::vector<double> twentyIsoValues(int count);
