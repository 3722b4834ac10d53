#include "DistinctSamples.h"

#include <algorithm>

namespace SurfaceScalars
{

DistinctSamples::DistinctSamples(const PointsRef& points, const Execution& execution)
{
  this->add(points, execution);
  // Points that are equal but for rounding have become one, and the cloud of what is left may
  // have another origin.
  while (this->cloud().pointCount() < this->cloud().inputCount())
  {
    this->add(Points(this->centers_), execution);
  }
}

Values DistinctSamples::average(const ValuesRef& values) const
{
  Values result = values;
  for (const PointCloud& cloud : this->clouds_)
  {
    result = cloud.average(result);
  }
  return result;
}

std::size_t DistinctSamples::contradictions(const ValuesRef& values, const Values& average) const
{
  std::vector<char> contradicting(this->cloud().pointCount(), 0);
  for (std::size_t input = 0; input < this->inputCount(); ++input)
  {
    const Index center = this->centerOf(input);
    if (values[static_cast<Eigen::Index>(input)] != average[center])
    {
      contradicting[center] = 1;
    }
  }
  return static_cast<std::size_t>(std::count(contradicting.begin(), contradicting.end(), 1));
}

Index DistinctSamples::centerOf(std::size_t input) const
{
  for (const PointCloud& cloud : this->clouds_)
  {
    input = cloud.pointOfInput(input);
  }
  return static_cast<Index>(input);
}

void DistinctSamples::add(const PointsRef& points, const Execution& execution)
{
  this->clouds_.emplace_back(points, execution);
  this->centers_.resize(3, this->cloud().pointCount());
  for (Index i = 0; i < this->cloud().pointCount(); ++i)
  {
    this->centers_.col(i) = points.col(static_cast<Eigen::Index>(this->cloud().inputOfPoint(i)));
  }
}

} // namespace SurfaceScalars
