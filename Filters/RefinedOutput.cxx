#include "RefinedOutput.h"

#include "OutputArrays.h"
#include "SurfaceTriangles.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <map>
#include <utility>

namespace SurfaceScalars
{
namespace
{

/// Of which cell each triangle of the surface is a part: triangles were left out of those of the
/// input, and kept their order.
std::vector<vtkIdType> cellsOf(vtkPolyData* input, const MeshedSurface& surface)
{
  const SurfaceCells all = trianglesOf(input, {});
  std::vector<vtkIdType> result;
  for (Eigen::Index next = 0; next < all.triangles.cols(); ++next)
  {
    const auto found = static_cast<Eigen::Index>(result.size());
    const auto isCorner = [&](int corner) {
      return surface.map.vertexOf(all.triangles(corner, next)) == surface.triangles(corner, found);
    };
    if (found < surface.triangles.cols() && isCorner(0) && isCorner(1) && isCorner(2))
    {
      result.push_back(all.cells[static_cast<std::size_t>(next)]);
    }
  }
  return result;
}

/// Cells of the output, and what is to be known of each.
struct NewCells
{
  vtkNew<vtkCellArray> cells;
  std::vector<vtkIdType> origins; ///< cells of the input
  std::vector<char> isSplit;

  template <typename... Cell>
  void add(vtkIdType origin, bool split, const Cell&... cell)
  {
    this->cells->InsertNextCell(cell...);
    this->origins.push_back(origin);
    this->isSplit.push_back(split);
  }
};

/// Puts the parts of split triangles in place of the cells that these belong to.
class CellReplacement
{
public:
  CellReplacement(vtkPolyData* input, const MeshedSurface& surface, const RefinedMesh& refined,
    const VertexMap& map)
    : input_(input)
    , cellOfTriangle_(cellsOf(input, surface))
    , refined_(refined)
    , map_(map)
  {
  }

  void run(vtkPolyData* output)
  {
    const vtkIdType other = this->input_->GetNumberOfVerts() + this->input_->GetNumberOfLines();
    NewCells polygons;
    NewCells strips;
    this->replace(this->input_->GetPolys(), other, polygons, polygons);
    this->replace(
      this->input_->GetStrips(), other + this->input_->GetNumberOfPolys(), strips, polygons);
    output->SetVerts(this->input_->GetVerts());
    output->SetLines(this->input_->GetLines());
    output->SetPolys(polygons.cells);
    output->SetStrips(strips.cells);

    std::vector<vtkIdType> origins(static_cast<std::size_t>(other));
    for (vtkIdType cell = 0; cell < other; ++cell)
    {
      origins[static_cast<std::size_t>(cell)] = cell;
    }
    this->isSplit_.assign(origins.size(), 0);
    for (const NewCells* part : { &polygons, &strips })
    {
      origins.insert(origins.end(), part->origins.begin(), part->origins.end());
      this->isSplit_.insert(this->isSplit_.end(), part->isSplit.begin(), part->isSplit.end());
    }
    this->copyData(origins, output->GetCellData());
  }

  const std::vector<char>& isSplit() const { return this->isSplit_; }

private:
  /// @param first the id of the first of these cells
  void replace(vtkCellArray* cells, vtkIdType first, NewCells& unchanged, NewCells& triangles)
  {
    vtkNew<vtkIdList> corners;
    for (vtkIdType cell = first; cell < first + cells->GetNumberOfCells(); ++cell)
    {
      const std::size_t begin = this->next_;
      bool isAnySplit = false;
      for (; this->next_ < this->refined_.origins.size() && this->cellOf(this->next_) == cell;
           ++this->next_)
      {
        isAnySplit |= this->refined_.isSplit[this->next_] != 0;
      }
      if (!isAnySplit)
      {
        cells->GetCellAtId(cell - first, corners);
        unchanged.add(cell, false, corners.GetPointer());
        continue;
      }
      for (std::size_t part = begin; part < this->next_; ++part)
      {
        this->addPart(cell, part, triangles);
      }
    }
  }

  vtkIdType cellOf(std::size_t part) const
  {
    return this->cellOfTriangle_[this->refined_.origins[part]];
  }

  void addPart(vtkIdType cell, std::size_t part, NewCells& triangles) const
  {
    vtkIdType ids[3];
    for (int corner = 0; corner < 3; ++corner)
    {
      ids[corner] =
        this->map_.pointOfVertex[this->refined_.triangles(corner, static_cast<Eigen::Index>(part))];
    }
    triangles.add(cell, this->refined_.isSplit[part] != 0, vtkIdType{ 3 }, ids);
  }

  void copyData(const std::vector<vtkIdType>& origins, vtkCellData* output) const
  {
    vtkCellData* given = this->input_->GetCellData();
    const auto count = static_cast<vtkIdType>(origins.size());
    output->CopyAllocate(given, count);
    for (vtkIdType cell = 0; cell < count; ++cell)
    {
      output->CopyData(given, origins[static_cast<std::size_t>(cell)], cell);
    }
  }

  vtkPolyData* input_;
  const std::vector<vtkIdType> cellOfTriangle_;
  const RefinedMesh& refined_;
  const VertexMap& map_;
  std::size_t next_ = 0; ///< of the parts, which follow the order of the cells
  std::vector<char> isSplit_;
};

/// How much of each point of the input there is in an added one.
using Shares = std::map<vtkIdType, double>;

std::vector<Shares> sharesOf(const RefinedMesh& refined, const VertexMap& map)
{
  std::vector<Shares> shares;
  const auto firstAdded =
    static_cast<Index>(refined.vertices.cols() - static_cast<Eigen::Index>(refined.added.size()));
  for (const EdgeVertex& place : refined.added)
  {
    Shares own;
    for (const auto& [end, share] :
      { std::pair(place.from, 1.0 - place.fraction), std::pair(place.to, place.fraction) })
    {
      const Shares ofEnd =
        end < firstAdded ? Shares{ { map.pointOfVertex[end], 1.0 } } : shares[end - firstAdded];
      for (const auto& [point, part] : ofEnd)
      {
        own[point] += share * part;
      }
    }
    shares.push_back(std::move(own));
  }
  return shares;
}

void addPoints(
  vtkPolyData* input, const RefinedMesh& refined, const VertexMap& map, vtkPolyData* output)
{
  const vtkIdType given = input->GetNumberOfPoints();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(map.pointCount());
  vtkPointData* data = output->GetPointData();
  data->InterpolateAllocate(input->GetPointData(), map.pointCount());
  for (vtkIdType point = 0; point < given; ++point)
  {
    points->SetPoint(point, input->GetPoint(point));
    data->CopyData(input->GetPointData(), point, point);
  }
  vtkIdType point = given;
  vtkNew<vtkIdList> ids;
  for (const Shares& shares : sharesOf(refined, map))
  {
    std::vector<double> weights;
    ids->Reset();
    for (const auto& [id, share] : shares)
    {
      ids->InsertNextId(id);
      weights.push_back(share);
    }
    points->SetPoint(point, refined.vertices.col(map.vertexOf(point)).data());
    data->InterpolatePoint(input->GetPointData(), point++, ids, weights.data());
  }
  output->SetPoints(points);
}

void addSplit(const FilterRun& run, const std::vector<char>& isSplit, vtkPolyData* output)
{
  vtkNew<vtkUnsignedCharArray> split;
  split->SetName("Split");
  split->SetNumberOfValues(output->GetNumberOfCells());
  std::copy(isSplit.begin(), isSplit.end(), split->GetPointer(0));
  makeRoom(run, output->GetCellData(), "Split");
  output->GetCellData()->AddArray(split);
}

} // namespace

MeshedSurface refinedSurface(const MeshedSurface& surface, const RefinedMesh& refined)
{
  MeshedSurface result{ refined.vertices, refined.triangles, surface.map };
  for (auto vertex = surface.vertices.cols(); vertex < refined.vertices.cols(); ++vertex)
  {
    result.map.pointOfVertex.push_back(result.map.pointCount());
    result.map.vertexOfPoint.push_back(static_cast<Index>(vertex));
  }
  return result;
}

Values refinedValues(const Values& values, const RefinedMesh& refined)
{
  Values result = values;
  result.conservativeResize(refined.vertices.cols());
  Eigen::Index next = values.size();
  for (const EdgeVertex& place : refined.added)
  {
    result(next++) =
      (1.0 - place.fraction) * result(place.from) + place.fraction * result(place.to);
  }
  return result;
}

void passRefined(const FilterRun& run, vtkPolyData* input, const MeshedSurface& surface,
  const RefinedMesh& refined, vtkPolyData* output)
{
  if (refined.added.empty())
  {
    output->ShallowCopy(input);
    addSplit(run, std::vector<char>(static_cast<std::size_t>(input->GetNumberOfCells())), output);
    return;
  }
  const VertexMap map = refinedSurface(surface, refined).map;
  CellReplacement replacement(input, surface, refined, map);
  addPoints(input, refined, map, output);
  replacement.run(output);
  output->GetFieldData()->ShallowCopy(input->GetFieldData());
  addSplit(run, replacement.isSplit(), output);
}

} // namespace SurfaceScalars
