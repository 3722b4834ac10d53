#include "Clouds.h"

#include <cmath>
#include <map>
#include <random>

using namespace SurfaceScalars;

namespace
{

Points randomTorus(int count)
{
  std::mt19937_64 engine(1);
  std::uniform_real_distribution<double> angle(0.0, 2.0 * Pi);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  Points points(3, count);
  for (int i = 0; i < count;)
  {
    const double u = angle(engine);
    const double v = angle(engine);
    const double distance = 1.0 + 0.4 * std::cos(v); // from the axis: proportional to the area
    if (uniform(engine) * 1.4 <= distance)
    {
      points.col(i++) << distance * std::cos(u), distance * std::sin(u), 0.4 * std::sin(v);
    }
  }
  return points;
}

} // namespace

const Points& torusCloud(int count)
{
  static std::map<int, Points> clouds;
  const auto found = clouds.find(count);
  return found != clouds.end() ? found->second
                               : clouds.emplace(count, randomTorus(count)).first->second;
}

const Values& tiltedHeight(int count)
{
  static std::map<int, Values> heights;
  const Vector3d direction = Vector3d(0.5, 0.2, 0.84).normalized();
  const auto found = heights.find(count);
  return found != heights.end()
    ? found->second
    : heights.emplace(count, torusCloud(count).transpose() * direction).first->second;
}

std::vector<double> twentyIsoValues(int count)
{
  const Values& height = tiltedHeight(count);
  std::vector<double> isoValues;
  for (int i = 0; i < 20; ++i)
  {
    isoValues.push_back(
      height.minCoeff() + (i + 0.5) / 20.0 * (height.maxCoeff() - height.minCoeff()));
  }
  return isoValues;
}
