#pragma once

#include "MeshTopology.h"

#include <Eigen/Geometry>

namespace SurfaceScalars
{

/// The sum of the normals of the triangles around a vertex, weighted by their areas: its link runs
/// counterclockwise seen from there. 0 where they cancel.
inline Vector3d linkNormal(const PointsRef& vertices, const MeshTopology& mesh, Index vertex)
{
  const Vector3d place = vertices.col(vertex);
  const VertexRange path = mesh.linkPath(vertex);
  Vector3d sum = Vector3d::Zero();
  for (const Index* edge = path.begin(); edge + 1 != path.end(); ++edge)
  {
    sum += (vertices.col(edge[0]) - place).cross(vertices.col(edge[1]) - place);
  }
  return sum;
}

} // namespace SurfaceScalars
