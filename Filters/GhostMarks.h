#pragma once

#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkType.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace SurfaceScalars
{

/// The marks of vtkGhostType on the points or cells of a dataset.
class GhostMarks
{
public:
  static GhostMarks ofCells(vtkDataSet* input)
  {
    return { input->GetCellGhostArray(), input->GetNumberOfCells() };
  }
  static GhostMarks ofPoints(vtkDataSet* input)
  {
    return { input->GetPointGhostArray(), input->GetNumberOfPoints() };
  }

  unsigned char of(vtkIdType id) const { return this->marks_ ? this->marks_->GetValue(id) : 0; }

  /// @param marks of which one is enough
  bool have(vtkIdType id, unsigned char marks) const { return (this->of(id) & marks) != 0; }

private:
  GhostMarks(vtkUnsignedCharArray* marks, vtkIdType count)
    : marks_(marks && marks->GetNumberOfValues() == count ? marks : nullptr)
  {
  }

  vtkUnsignedCharArray* marks_; ///< null if there are none
};

/// Which cells of a dataset are left out: those with a mark, and those with a hidden point.
class LeftOutCells
{
public:
  /// @param marks HIDDENCELL of vtkDataSetAttributes, or more than that
  explicit LeftOutCells(vtkDataSet* input, unsigned char marks = vtkDataSetAttributes::HIDDENCELL)
    : cells_(GhostMarks::ofCells(input))
    , points_(GhostMarks::ofPoints(input))
    , marks_(marks)
    , pointCount_(static_cast<std::size_t>(input->GetNumberOfPoints()))
  {
  }

  /// Remembers the corners of those left out. @param corners exist
  bool add(vtkIdType cell, vtkIdType size, const vtkIdType* corners)
  {
    const bool isLeftOut = this->cells_.have(cell, this->marks_) ||
      std::any_of(corners, corners + size,
        [this](vtkIdType point)
        { return this->points_.have(point, vtkDataSetAttributes::HIDDENPOINT); });
    if (isLeftOut)
    {
      this->corners_.resize(this->pointCount_, 0);
      std::for_each(corners, corners + size,
        [this](vtkIdType point) { this->corners_[static_cast<std::size_t>(point)] = 1; });
    }
    return isLeftOut;
  }

  /// Not 0 for those of the cells left out; empty if there are none.
  const std::vector<char>& corners() const { return this->corners_; }

private:
  GhostMarks cells_;
  GhostMarks points_;
  unsigned char marks_;
  std::vector<char> corners_;
  std::size_t pointCount_;
};

/// The points of cells left out that are in no others: nobody misses them.
/// @param corners of cells left out @param simplices of the others
template <class Simplices>
std::vector<char> pointsLeftOut(std::vector<char> corners, const Simplices& simplices)
{
  if (!corners.empty())
  {
    for (const auto corner : simplices.reshaped())
    {
      corners[corner] = 0;
    }
  }
  return corners;
}

} // namespace SurfaceScalars
