#include "RadialSums.h"

#include <algorithm>

namespace SurfaceScalars
{
namespace
{

constexpr Eigen::Index BlockSize = 256; // targets whose sums stay in the cache

using Block = Eigen::Array<double, Eigen::Dynamic, 1, Eigen::ColMajor, BlockSize, 1>;

} // namespace

Values radialSums(const RadialKernel& kernel, const Points& sources, const Values& weights,
  const PointsRef& targets, const Execution& execution)
{
  Values result(targets.cols());
  parallelFor(static_cast<std::size_t>(targets.cols()), BlockSize, execution,
    [&](std::size_t begin, std::size_t end)
    {
      const auto first = static_cast<Eigen::Index>(begin);
      const auto count = static_cast<Eigen::Index>(end) - first;
      const auto block = targets.middleCols(first, count);
      const Block x = block.row(0);
      const Block y = block.row(1);
      const Block z = block.row(2);
      Block sums = Block::Zero(count);
      Block phi(count);
      for (Eigen::Index j = 0; j < sources.cols(); ++j)
      {
        const auto source = sources.col(j);
        phi = (x - source[0]).square() + (y - source[1]).square() + (z - source[2]).square();
        kernel.apply(phi);
        sums += weights[j] * phi;
      }
      result.segment(first, count) = sums.matrix();
    });
  return result;
}

} // namespace SurfaceScalars
