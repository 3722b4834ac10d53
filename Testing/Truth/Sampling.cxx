#include "Sampling.h"

#include <cmath>

namespace SurfaceScalars::Truth
{

Random::Random(unsigned seed)
  : engine_(seed)
{
}

double Random::uniform()
{
  return std::ldexp(static_cast<double>(this->engine_() >> 11), -53);
}

double Random::uniform(double begin, double end)
{
  return begin + (end - begin) * this->uniform();
}

// Box and Muller's polar form of two uniform numbers.
double Random::normal()
{
  const double radius = std::sqrt(-2.0 * std::log(1.0 - this->uniform()));
  return radius * std::cos(2.0 * Pi * this->uniform());
}

// The area element is r (R + r cos v) du dv: draw v evenly and reject in proportion.
Points randomTorus(int count, Torus torus, unsigned seed)
{
  Random random(seed);
  const AngleRange axial = axialAngles(torus);
  Points points(3, count);
  for (int i = 0; i < count;)
  {
    const Vector2d angles(random.uniform(axial.begin, axial.end), random.uniform(0.0, 2.0 * Pi));
    const double element = MajorRadius + MinorRadius * std::cos(angles.y());
    if (random.uniform() * (MajorRadius + MinorRadius) <= element)
    {
      points.col(i++) = torusPoint(angles);
    }
  }
  return points;
}

Points randomSphere(int count, unsigned seed)
{
  Random random(seed);
  Points points(3, count);
  for (int i = 0; i < count; ++i)
  {
    const double x = random.normal();
    const double y = random.normal();
    points.col(i) = Vector3d(x, y, random.normal()).normalized();
  }
  return points;
}

Points randomPlane(int count, unsigned seed)
{
  Random random(seed);
  Points points(3, count);
  for (int i = 0; i < count; ++i)
  {
    const double x = random.uniform(-1.0, 1.0);
    points.col(i) = Vector3d(x, random.uniform(-1.0, 1.0), 0.0);
  }
  return points;
}

Points squareGrid(int count, double spacing)
{
  Points points(3, count * count);
  for (int i = 0; i < count * count; ++i)
  {
    points.col(i) = spacing * Vector3d(i % count, i / count, 0.0);
  }
  return points;
}

Points select(const PointsRef& points, const std::function<bool(const Vector3d&)>& keep)
{
  Points kept(3, points.cols());
  Eigen::Index count = 0;
  for (Eigen::Index i = 0; i < points.cols(); ++i)
  {
    if (keep(points.col(i)))
    {
      kept.col(count++) = points.col(i);
    }
  }
  kept.conservativeResize(3, count);
  return kept;
}

void addNoise(Points& points, double standardDeviation, unsigned seed)
{
  Random random(seed);
  for (double& coordinate : points.reshaped())
  {
    coordinate += standardDeviation * random.normal();
  }
}

void addNoise(Values& values, double standardDeviation, unsigned seed)
{
  Random random(seed);
  for (double& value : values)
  {
    value += standardDeviation * random.normal();
  }
}

} // namespace SurfaceScalars::Truth
