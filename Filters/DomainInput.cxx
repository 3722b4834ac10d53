#include "DomainInput.h"

#include "DatasetCells.h"
#include "ExplicitPoints.h"
#include "FilterRun.h"
#include "GhostMarks.h"
#include "PointSetInput.h"
#include "Require.h"
#include "ScalarChoice.h"
#include "SolidCells.h"
#include "SurfaceTriangles.h"
#include "VolumeTopology.h"

#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <utility>

namespace SurfaceScalars
{
namespace
{

constexpr double CellShare = 0.6; // of the whole

/// The cells of the triangles of a surface that were kept: some of all, in their order.
std::vector<vtkIdType> cellsOfKept(
  const MeshInput& mesh, vtkPolyData* surface, const Execution& execution)
{
  const SurfaceCells all = trianglesOf(surface, execution);
  const Triangles& kept = mesh.surface.triangles;
  const auto pointOf = [&](Index vertex)
  { return static_cast<Index>(mesh.surface.map.pointOfVertex[vertex]); };
  std::vector<vtkIdType> cells(static_cast<std::size_t>(kept.cols()));
  Eigen::Index next = 0;
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    const auto corners = kept.col(static_cast<Eigen::Index>(i)).unaryExpr(pointOf);
    while (all.triangles.col(next) != corners)
    {
      ++next;
    }
    cells[i] = all.cells[static_cast<std::size_t>(next++)];
  }
  return cells;
}

DomainInput readPolyData(FilterRun& run, const Execution& execution, vtkPolyData* input)
{
  DomainInput domain;
  domain.mesh = readMesh(run, execution.part(0.0, CellShare), input);
  domain.cells = cellsOfKept(domain.mesh, input, execution.part(CellShare, 1.0));
  return domain;
}

DomainInput readFlatCells(FilterRun& run, const Execution& execution, vtkDataSet* input)
{
  const FlatCells flat = flatCellsOf(input, execution.part(0.0, 0.5));
  DomainInput domain = readPolyData(run, execution.part(0.5, 1.0), flat.surface);
  for (vtkIdType& cell : domain.cells)
  {
    cell = flat.cells[static_cast<std::size_t>(cell)];
  }
  return domain;
}

/// Reads the tetrahedra one after the other; corners are ids of points.
class TetrahedronReader
{
public:
  TetrahedronReader(vtkDataSet* input, const CellCounts& counts)
    : pointCount_(input->GetNumberOfPoints())
    , leftOut_(input)
    , tetrahedra_(4, counts.tetrahedra)
  {
    this->cells_.reserve(static_cast<std::size_t>(counts.tetrahedra));
  }

  void add(vtkIdType cell, int type, vtkIdList* corners)
  {
    this->pieces_.clear();
    for (vtkIdType i = 0; i < corners->GetNumberOfIds(); ++i)
    {
      const vtkIdType corner = corners->GetId(i);
      require(corner >= 0 && corner < this->pointCount_,
        "cells whose corners are points 0 to " + std::to_string(this->pointCount_ - 1),
        "a corner " + std::to_string(corner), "Check what made this grid.");
    }
    if (this->leftOut_.add(cell, corners->GetNumberOfIds(), corners->GetPointer(0)))
    {
      return;
    }
    cutIntoTetrahedra(type, corners->GetPointer(0), this->pieces_);
    for (std::array<vtkIdType, 4> piece : this->pieces_)
    {
      std::sort(piece.begin(), piece.end());
      if (std::adjacent_find(piece.begin(), piece.end()) == piece.end())
      {
        const auto place = static_cast<Eigen::Index>(this->cells_.size());
        std::transform(piece.begin(), piece.end(), this->tetrahedra_.col(place).data(),
          [](vtkIdType corner) { return static_cast<Index>(corner); });
        this->cells_.push_back(cell);
      }
    }
    this->readCount_ += static_cast<Eigen::Index>(this->pieces_.size());
  }

  /// Hands over what was read. What has a corner twice is counted in a note.
  /// @returns the points that nobody misses
  std::vector<char> finish(FilterRun& run, DomainInput& domain)
  {
    const auto count = static_cast<Eigen::Index>(this->cells_.size());
    require(this->readCount_ > 0, "cells that are not hidden", "none", "Check what is upstream.");
    if (count < this->readCount_)
    {
      run.note(std::to_string(this->readCount_ - count) + " of " +
        std::to_string(this->readCount_) +
        " tetrahedra have the same corner twice and are ignored.");
    }
    this->tetrahedra_.conservativeResize(4, count);
    domain.tetrahedra = std::move(this->tetrahedra_);
    domain.cells = std::move(this->cells_);
    return pointsLeftOut(this->leftOut_.corners(), domain.tetrahedra);
  }

private:
  vtkIdType pointCount_;
  LeftOutCells leftOut_;
  Tetrahedra tetrahedra_;
  Eigen::Index readCount_ = 0;
  std::vector<vtkIdType> cells_;
  std::vector<std::array<vtkIdType, 4>> pieces_; ///< of one cell
};

void checkSize(const CellCounts& counts, vtkIdType pointCount)
{
  constexpr Eigen::Index most = VolumeTopology::MostTetrahedra;
  require(counts.tetrahedra <= most && pointCount < std::numeric_limits<Index>::max(),
    "at most " + std::to_string(most) +
      " tetrahedra (6 per voxel), for indices are numbers of 32 "
      "bits",
    std::to_string(counts.tetrahedra), "Extract a part (Extract Subset), or every other voxel.");
}

/// Drops the tetrahedra around points without a finite position or value.
/// @param leftOut points that nobody misses
/// @returns how many points these are
Eigen::Index dropMissing(FilterRun& run, const Points& points, const Values& values,
  const std::vector<char>& leftOut, DomainInput& domain)
{
  const std::vector<char> missing = missingPoints(points, values, leftOut);
  const Eigen::Index missingCount = std::count(missing.begin(), missing.end(), 1);
  if (missingCount == 0)
  {
    return 0;
  }
  Tetrahedra& tetrahedra = domain.tetrahedra;
  const Eigen::Index total = tetrahedra.cols();
  Eigen::Index count = 0;
  for (Eigen::Index i = 0; i < total; ++i)
  {
    const auto corners = tetrahedra.col(i);
    if (std::none_of(corners.begin(), corners.end(), [&](Index corner) { return missing[corner]; }))
    {
      domain.cells[static_cast<std::size_t>(count)] = domain.cells[static_cast<std::size_t>(i)];
      tetrahedra.col(count++) = corners;
    }
  }
  tetrahedra.conservativeResize(4, count);
  domain.cells.resize(static_cast<std::size_t>(count));
  run.note("Left out " + std::to_string(missingCount) + " of " + std::to_string(points.cols()) +
    " points whose position or value is NaN or infinite, with " + std::to_string(total - count) +
    " of " + std::to_string(total) + " tetrahedra: the volume has holes there.");
  require(count > 0, "tetrahedra between points with a finite position and value", "none",
    "Choose another array or another input.");
  return missingCount;
}

DomainInput readSolidCells(
  FilterRun& run, const Execution& execution, vtkDataSet* input, const CellCounts& counts)
{
  checkSize(counts, input->GetNumberOfPoints());
  const vtkSmartPointer<vtkPointSet> pointSet = withExplicitPoints(input);
  const ScalarChoice choice = chooseScalars(run.filter(), { pointSet });
  DomainInput domain;
  TetrahedronReader reader(input, counts);
  forEachCell(input, execution.part(0.0, CellShare),
    [&](vtkIdType cell, int type, vtkIdList* corners)
    {
      if (tetrahedronCount(type) > 0)
      {
        reader.add(cell, type, corners);
      }
    });
  const std::vector<char> leftOut = reader.finish(run, domain);
  const Points points = readPoints(pointSet->GetPoints(), execution.part(CellShare, 0.8));
  Values values(points.cols());
  copyNumbers(choice.arrays.front(), values.data(), execution.part(0.8, 0.9));
  const Eigen::Index missing = dropMissing(run, points, values, leftOut, domain);
  domain.mesh.surface.map = allPoints(points.cols());
  VertexMap& map = domain.mesh.surface.map;
  keepCorners(domain.tetrahedra, map);
  noteOutside(run, map, missing + std::count(leftOut.begin(), leftOut.end(), 1), "tetrahedron");
  domain.mesh.surface.vertices = points(Eigen::all, map.pointOfVertex);
  domain.mesh.values = values(map.pointOfVertex);
  domain.mesh.valueName = choice.name;
  execution.report(1.0);
  return domain;
}

void noteIgnored(FilterRun& run, vtkIdType ignored, vtkIdType total, const std::string& cells)
{
  if (ignored > 0)
  {
    run.note(std::to_string(ignored) + " of " + std::to_string(total) + " cells are " + cells +
      " and ignored.");
  }
}

} // namespace

DomainInput readDomain(FilterRun& run, const Execution& execution, vtkDataSet* input)
{
  require(input && input->GetNumberOfPoints() > 0, "a surface or volume", "no points",
    "Check what is upstream.");
  if (auto* surface = vtkPolyData::SafeDownCast(input))
  {
    return readPolyData(run, execution, surface);
  }
  const vtkIdType total = input->GetNumberOfCells();
  const CellCounts counts = countCells(input);
  require(counts.flat + counts.solid > 0, "triangles, quads or polygons, or cells of a volume",
    "none among " + std::to_string(total) + " cells",
    "Use Fuzzy Critical Points, Point Set Contour, RBF Extend or another point-set filter for "
    "points without cells.");
  if (counts.solid == 0)
  {
    noteIgnored(run, counts.other, total, "vertices or lines");
    return readFlatCells(run, execution, input);
  }
  noteIgnored(run, counts.flat + counts.other, total, "flat, lines or vertices");
  return readSolidCells(run, execution, input, counts);
}

} // namespace SurfaceScalars
