#pragma once

#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataArray;
class vtkPointSet;

namespace SurfaceScalars
{

/// The point array a user chose as f.
struct ScalarChoice
{
  std::string name;
  std::vector<vtkDataArray*> arrays; ///< one per block, null where a block lacks it
};

/**
 * Finds the array of SetInputArrayToProcess(index, ...), by name or as active attribute, in the
 * blocks of an input.
 *
 * @throws InvalidInput if it is not a point array of numbers with one component, or if no block has
 * it
 */
ScalarChoice chooseScalars(
  vtkAlgorithm& filter, const std::vector<vtkPointSet*>& blocks, int index = 0);

} // namespace SurfaceScalars
