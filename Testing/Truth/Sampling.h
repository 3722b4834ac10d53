#pragma once

#include "Basics.h"
#include "Torus.h"

#include <functional>
#include <random>

namespace SurfaceScalars::Truth
{

/// Random numbers that are the same with every standard library: the standard fixes the engine but
/// not its distributions.
class Random
{
public:
  explicit Random(unsigned seed);
  double uniform(); ///< in [0, 1)
  double uniform(double begin, double end);
  double normal(); ///< mean 0, standard deviation 1

private:
  std::mt19937_64 engine_;
};

/// Uniform by area.
Points randomTorus(int count, Torus torus, unsigned seed);
Points randomSphere(int count, unsigned seed); ///< radius 1
Points randomPlane(int count, unsigned seed);  ///< z = 0, -1 <= x, y < 1

/// z = 0, count x count points, the corner at the origin.
Points squareGrid(int count, double spacing);

/// The points for which keep is true.
Points select(const PointsRef& points, const std::function<bool(const Vector3d&)>& keep);

/// Adds normal noise to every coordinate.
void addNoise(Points& points, double standardDeviation, unsigned seed);
void addNoise(Values& values, double standardDeviation, unsigned seed);

} // namespace SurfaceScalars::Truth
