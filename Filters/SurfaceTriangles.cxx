#include "SurfaceTriangles.h"

#include "GhostMarks.h"
#include "Require.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolygon.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <vector>

namespace SurfaceScalars
{
namespace
{

using Visit = std::function<void(vtkIdType size, const vtkIdType* ids)>;

/// Calls visit for each cell once its corners are known to exist.
void forEachCell(
  vtkCellArray* cells, vtkIdType pointCount, const Execution& execution, const Visit& visit)
{
  constexpr vtkIdType step = 1 << 14; // cells between two reports
  const vtkIdType count = cells->GetNumberOfCells();
  const auto cell = vtkSmartPointer<vtkCellArrayIterator>::Take(cells->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    const vtkIdType number = cell->GetCurrentCellId();
    if (number % step == 0)
    {
      execution.report(static_cast<double>(number) / static_cast<double>(count));
    }
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cell->GetCurrentCell(size, ids);
    for (vtkIdType i = 0; i < size; ++i)
    {
      require(ids[i] >= 0 && ids[i] < pointCount,
        "cells whose corners are points 0 to " + std::to_string(pointCount - 1),
        "a corner " + std::to_string(ids[i]), "Check what made this mesh.");
    }
    visit(size, ids);
  }
}

class TriangleList
{
public:
  explicit TriangleList(vtkPoints* points)
    : points_(points)
  {
  }

  void addPolygon(vtkIdType size, const vtkIdType* ids)
  {
    if (size == 3)
    {
      this->add(ids[0], ids[1], ids[2]);
    }
    else if (size > 3)
    {
      this->cutUp(size, ids);
    }
  }

  /// Every other triangle of a strip is the other way round.
  void addStrip(vtkIdType size, const vtkIdType* ids)
  {
    for (vtkIdType i = 0; i + 2 < size; ++i)
    {
      const bool turned = i % 2 != 0;
      this->add(ids[i], ids[i + (turned ? 2 : 1)], ids[i + (turned ? 1 : 2)]);
    }
  }

  std::size_t size() const { return this->corners_.size() / 3; }

  Triangles result() const
  {
    return Eigen::Map<const Triangles>(
      this->corners_.data(), 3, static_cast<Eigen::Index>(this->size()));
  }

private:
  void add(vtkIdType a, vtkIdType b, vtkIdType c)
  {
    for (const vtkIdType corner : { a, b, c })
    {
      this->corners_.push_back(static_cast<Index>(corner));
    }
  }

  void cutUp(vtkIdType size, const vtkIdType* ids)
  {
    this->polygon_->Initialize(static_cast<int>(size), ids, this->points_);
    vtkCell& cell = *this->polygon_; // whose interface does not change between versions of VTK
    const bool isCut = cell.Triangulate(0, this->pieces_, this->places_) != 0;
    if (!isCut || this->pieces_->GetNumberOfIds() != 3 * (size - 2))
    {
      for (vtkIdType i = 1; i + 1 < size; ++i)
      {
        this->add(ids[0], ids[i], ids[i + 1]);
      }
      return;
    }
    for (vtkIdType i = 0; i < this->pieces_->GetNumberOfIds(); i += 3)
    {
      const vtkIdType* corners = this->pieces_->GetPointer(i);
      this->add(corners[0], corners[1], corners[2]);
    }
  }

  vtkPoints* points_;
  vtkNew<vtkPolygon> polygon_;
  vtkNew<vtkIdList> pieces_;
  vtkNew<vtkPoints> places_; ///< of the pieces' corners; not used
  std::vector<Index> corners_;
};

} // namespace

SurfaceCells trianglesOf(vtkPolyData* surface, const Execution& execution, unsigned char marks)
{
  SurfaceCells result;
  TriangleList list(surface->GetPoints());
  LeftOutCells leftOut(surface, marks);
  vtkIdType cell = surface->GetNumberOfVerts() + surface->GetNumberOfLines();
  const auto addAll = [&](vtkCellArray* cells, const Execution& ofCells, const auto& add)
  {
    forEachCell(cells, surface->GetNumberOfPoints(), ofCells,
      [&](vtkIdType size, const vtkIdType* ids)
      {
        if (!leftOut.add(cell, size, ids))
        {
          add(size, ids);
          result.cells.resize(list.size(), cell);
        }
        ++cell;
      });
  };
  addAll(surface->GetPolys(), execution.part(0.0, 0.5),
    [&](vtkIdType size, const vtkIdType* ids) { list.addPolygon(size, ids); });
  addAll(surface->GetStrips(), execution.part(0.5, 1.0),
    [&](vtkIdType size, const vtkIdType* ids) { list.addStrip(size, ids); });
  result.triangles = list.result();
  result.leftOut = leftOut.corners();
  return result;
}

} // namespace SurfaceScalars
