#pragma once

#include "ConstrainedSmoothing.h"
#include "Functions.h"
#include "TriangleMesh.h"

#include <string>
#include <utility>
#include <vector>

namespace SurfaceScalars::Truth
{

/// A function on a mesh, without noise, with the features that smoothing is to find again.
struct SmoothingCase
{
  std::string name;
  std::string functionName;
  TriangleMesh mesh;
  Values clean;
  double range;                        ///< of clean
  double threshold;                    ///< persistence of features, of the range
  std::pair<double, double> gap;       ///< the persistences next to the threshold, of the range
  std::vector<CriticalPoint> features; ///< extrema of clean from the threshold on, by brute force
  CriticalCounts counts; ///< of these and of the saddles that Euler's formula asks for

  SmoothingCase(std::string caseName, TriangleMesh onMesh, const SpaceFunction& function,
    double leastPersistence);

  /// With normal noise at every vertex, its standard deviation a fraction of the range.
  Values noisy(double noise, unsigned seed) const;
};

/// sin 5x cos 4y + 0.3 z: of many surfaces some extrema persist much more than the others.
SpaceFunction waves();

/// Those of Documentation/smoothing-accuracy.md; without a folder of scans those of the sphere and
/// the torus. @param fineness 1 or 2
std::vector<SmoothingCase> smoothingCases(const std::string& folder, int fineness = 2);

/// What came out, compared with the clean function.
struct SmoothingScore
{
  CriticalCounts counts;        ///< by brute force
  bool hasFeatures = false;     ///< exactly as many minima, saddles and maxima as the features
  double largestDistance = 0.0; ///< from a feature to its counterpart; infinite if it has none
  double meanSquareError = 0.0; ///< root of the mean square, of the range
  double largestError = 0.0;    ///< of the range
};

SmoothingScore scoreOf(const SmoothingCase& smoothingCase, const ValuesRef& values);

/// Each vertex becomes the mean of itself and its neighbors, over and over: what comes nearest to
/// the clean function in the mean square, which only a truth run knows.
struct Averaged
{
  Values values;
  int times;
};
Averaged bestAverage(const SmoothingCase& smoothingCase, const ValuesRef& values);

} // namespace SurfaceScalars::Truth
