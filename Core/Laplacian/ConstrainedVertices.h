#pragma once

#include "LaplacianFunctions.h"

#include <functional>
#include <vector>

namespace SurfaceScalars
{

/// Which vertices' values are given, and which are unknown.
struct ConstrainedVertices
{
  static constexpr int Fixed = -1;

  std::vector<int> unknownOfVertex; ///< Fixed where the value is given
  std::vector<int> vertices;        ///< of the unknowns
  Values given;                     ///< 0 where the value is not given

  /// @throws InvalidInput without constraints, for vertices that do not exist, values that are not
  /// finite, contradictory ones, a component of the surface without any (named)
  ConstrainedVertices(const Laplacian& laplacian, const std::vector<ValueConstraint>& constraints,
    const VertexName& nameOf);

  /**
   * The values of all vertices, in the unit in which the given ones are from 0 to 1: so errors are
   * small beside their difference, however large they are.
   *
   * @param solve the unknowns for these given values, 0 elsewhere; not called if all are equal, nor
   * without unknowns
   */
  Values extend(const std::function<Values(const Values& given)>& solve) const;

  bool isFixed(std::size_t vertex) const { return this->unknownOfVertex[vertex] == Fixed; }
};

} // namespace SurfaceScalars
