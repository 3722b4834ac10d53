// vtkPointSetContour on inputs of several parts, and with points that belong to others.

#include "ContourInputTest.h"

#include "vtkDataSetAttributes.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

using namespace SurfaceScalars;
using namespace SurfaceScalars::FilterTest;

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

/// Expects the two circles in which the height 0.2 cuts the torus, to `tolerance` times the radius.
void expectTwoCircles(const std::vector<Curve>& curves, double tolerance = 2e-3)
{
  ASSERT_THAT(curves, ::testing::SizeIs(2));
  const double half = std::sqrt(Truth::MinorRadius * Truth::MinorRadius - 0.04);
  std::vector<double> radii;
  for (const Curve& curve : curves)
  {
    EXPECT_TRUE(curve.closed);
    radii.push_back(curve.length / (2.0 * Pi));
  }
  std::sort(radii.begin(), radii.end());
  EXPECT_NEAR(radii[0], 1.0 - half, tolerance);
  EXPECT_NEAR(radii[1], 1.0 + half, tolerance);
}

/// The cloud without some of its points, all arrays kept.
vtkSmartPointer<vtkPolyData> part(
  vtkPolyData* cloud, const std::function<bool(const Vector3d&)>& keep)
{
  std::vector<Vector3d> places;
  std::vector<double> values;
  vtkDataArray* f = cloud->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < cloud->GetNumberOfPoints(); ++i)
  {
    const Vector3d p(cloud->GetPoint(i));
    if (keep(p))
    {
      places.push_back(p);
      values.push_back(f->GetTuple1(i));
    }
  }
  const auto count = static_cast<Eigen::Index>(places.size());
  return makeCloud(Points(Eigen::Map<const Points>(places.front().data(), 3, count)),
    Values(Eigen::Map<const Values>(values.data(), count)));
}

/// The torus in two tiles that meet at x = 0.
std::vector<vtkSmartPointer<vtkPolyData>> torusTiles()
{
  const auto cloud = makeCloud(torusPoints(), z);
  return { part(cloud, [](const Vector3d& p) { return p.x() < 0.0; }),
    part(cloud, [](const Vector3d& p) { return p.x() >= 0.0; }) };
}

} // namespace

// Curves cross the seams between tiles, whatever holds these.
TEST(ContourTiles, mergesTiles)
{
  const auto tiles = torusTiles();
  vtkNew<vtkMultiBlockDataSet> blocks;
  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetBlock(0, nullptr);
  inner->SetBlock(1, tiles[0]);
  blocks->SetBlock(0, inner);
  blocks->SetBlock(1, tiles[1]);
  blocks->SetBlock(2, vtkNew<vtkPolyData>()); // empty, without arrays
  expectTwoCircles(contour(blocks, 0.2));

  vtkNew<vtkPartitionedDataSet> partitions;
  partitions->SetPartition(0, tiles[0]);
  partitions->SetPartition(1, tiles[1]);
  expectTwoCircles(contour(partitions, 0.2));
  vtkNew<vtkPartitionedDataSetCollection> collection;
  collection->SetPartitionedDataSet(0, partitions);
  expectTwoCircles(contour(collection, 0.2));
}

// Tiles that overlap in the same points are one surface.
TEST(ContourTiles, mergesOverlappingTiles)
{
  const auto cloud = makeCloud(torusPoints(), z);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, part(cloud, [](const Vector3d& p) { return p.x() < 0.2; }));
  blocks->SetBlock(1, part(cloud, [](const Vector3d& p) { return p.x() > -0.2; }));
  expectSame(contour(blocks, 0.2), contour(cloud, 0.2), 1e-9);
}

// Ghost points belong to another tile: with wrong values they do no harm, and no warning counts
// them.
TEST(ContourTiles, leavesGhostPointsOut)
{
  const Points points = torusPoints();
  Values values = heights(points);
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfValues(points.cols());
  ghosts->FillValue(0);
  for (vtkIdType i = 0; i < points.cols(); i += 7)
  {
    ghosts->SetValue(
      i, i % 2 ? vtkDataSetAttributes::DUPLICATEPOINT : vtkDataSetAttributes::HIDDENPOINT);
    values[i] = i % 3 ? NaN : 1000.0;
  }
  const auto cloud = makeCloud(points, values);
  cloud->GetPointData()->AddArray(ghosts);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, cloud);
  expectTwoCircles(contour(cloud, 0.2));
  expectTwoCircles(contour(blocks, 0.2));
}

// A tile without f counts as missing.
TEST(ContourTiles, leavesTilesWithoutTheArrayOut)
{
  const auto tiles = torusTiles();
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, tiles[0]);
  blocks->SetBlock(1, makeCloud(Truth::randomSphere(500, 1)));
  vtkNew<vtkPointSetContour> filter;
  filter->SetInputData(blocks);
  filter->SetContourValues(0, 0.2);
  expectWarning(update(filter), { "Left out 500 of " });
  expectSame(curvesOf(filter), contour(tiles[0], 0.2));
}
