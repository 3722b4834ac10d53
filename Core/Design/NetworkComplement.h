#pragma once

#include "MeshTopology.h"

#include <vector>

namespace SurfaceScalars
{

/// What a vertex off the network stands for: 1 for a maximum, -1 for each path that must still
/// leave a saddle there, 0 for one that must stay off the network.
struct PointIndex
{
  Index vertex;
  int index;
};

/**
 * Whether a network of vertices on a closed mesh can be completed without another critical point.
 * If so, disks of the rest for which no vertex stands, which paths side by side enclose, become
 * part of it.
 *
 * A path of vertices that joins the network at both ends raises the Euler characteristic of what is
 * left of the surface by 1, where it also may cut it in two. In the end all components of this rest
 * shall be disks with a maximum each. So in each component, now and always, the characteristic must
 * be the number of maxima less that of the paths to come, and one maximum at least must be there.
 *
 * @param isInNetwork by vertex
 * @param indices of all vertices that stand for something; if one is on the network, the answer is
 * no
 */
bool complete(
  const MeshTopology& mesh, std::vector<char>& isInNetwork, const std::vector<PointIndex>& indices);

} // namespace SurfaceScalars
