// How the sources and constraints of vtkPointSetScalarFunction are chosen, and what is refused.

#include "SurfaceFunctionTest.h"

#include "vtkCellArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkUnstructuredGrid.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace SurfaceScalars;
using namespace SurfaceScalars::FilterTest;

namespace
{

using Filter = vtkPointSetScalarFunction;

/// @param field vtkSelectionNode::POINT or CELL
vtkSmartPointer<vtkSelectionNode> selectIds(int field, std::initializer_list<vtkIdType> ids)
{
  vtkNew<vtkIdTypeArray> list;
  for (const vtkIdType id : ids)
  {
    list->InsertNextValue(id);
  }
  const auto node = vtkSmartPointer<vtkSelectionNode>::New();
  node->SetContentType(vtkSelectionNode::INDICES);
  node->SetFieldType(field);
  node->SetSelectionList(list);
  return node;
}

vtkSmartPointer<vtkSelection> selectionOf(vtkSelectionNode* node)
{
  const auto selection = vtkSmartPointer<vtkSelection>::New();
  selection->AddNode(node);
  return selection;
}

vtkSmartPointer<Filter> selectingFilter(vtkDataObject* input, int function, vtkSelectionNode* node)
{
  const auto filter = functionOn(input, function);
  filter->SetSourceType(Filter::SELECTION);
  filter->SetSelectionData(selectionOf(node));
  return filter;
}

/// The distance from points given by their ids.
Values distanceFrom(vtkDataObject* input, std::initializer_list<vtkIdType> ids)
{
  const auto filter = functionOn(input, Filter::GEODESIC);
  setSources(filter, ids);
  return silentResultOf(filter);
}

vtkSmartPointer<vtkPolyData> sphere()
{
  return makeCloud(Truth::randomSphere(500, 1));
}

} // namespace

TEST(PointChoice, takesSelectedPoints)
{
  const auto cloud = sphere();
  const auto filter =
    selectingFilter(cloud, Filter::GEODESIC, selectIds(vtkSelectionNode::POINT, { 44, 3, 3 }));
  EXPECT_TRUE(silentResultOf(filter) == distanceFrom(cloud, { 3, 44 }));
  filter->SetFunction(Filter::DIFFUSION);
  EXPECT_GT(silentResultOf(filter).minCoeff(), -1e-6);
}

// All points but the selected ones.
TEST(PointChoice, takesTheInverse)
{
  const auto cloud = sphere();
  const auto node = selectIds(vtkSelectionNode::POINT, { 3 });
  node->GetProperties()->Set(vtkSelectionNode::INVERSE(), 1);
  const Values values = silentResultOf(selectingFilter(cloud, Filter::GEODESIC, node));
  EXPECT_GT(values[3], 0.0);
  EXPECT_EQ((values.array() == 0.0).count(), 499);
}

TEST(PointChoice, takesThePointsOfSelectedCells)
{
  const auto cloud = sphere();
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 1 });
  lines->InsertNextCell({ 7, 9, 11 });
  cloud->SetLines(lines);
  const auto filter =
    selectingFilter(cloud, Filter::GEODESIC, selectIds(vtkSelectionNode::CELL, { 1 }));
  EXPECT_TRUE(silentResultOf(filter) == distanceFrom(cloud, { 7, 9, 11 }));
}

// A selection in one block counts through all.
TEST(PointChoice, takesSelectedPointsOfBlocks)
{
  const Points points = Truth::randomSphere(600, 1);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, makeCloud(Points(points.leftCols(200))));
  blocks->SetBlock(1, vtkNew<vtkPolyData>());
  blocks->SetBlock(2, makeCloud(Points(points.rightCols(400))));
  const auto node = selectIds(vtkSelectionNode::POINT, { 5 });
  node->GetProperties()->Set(vtkSelectionNode::COMPOSITE_INDEX(), 3);
  const Values expected = distanceFrom(makeCloud(points), { 205 });
  EXPECT_TRUE(silentResultOf(selectingFilter(blocks, Filter::GEODESIC, node)) == expected);

  vtkNew<vtkPartitionedDataSetCollection> collection;
  collection->SetPartition(0, 0, blocks->GetBlock(0));
  collection->SetPartition(1, 0, blocks->GetBlock(2));
  node->GetProperties()->Set(vtkSelectionNode::COMPOSITE_INDEX(), 4);
  EXPECT_TRUE(silentResultOf(selectingFilter(collection, Filter::GEODESIC, node)) == expected);
}

TEST(PointChoice, takesThePointNearestToAPlace)
{
  Points points = Truth::randomSphere(500, 1);
  points.col(3).setConstant(NaN);
  const auto cloud = makeCloud(points);
  const auto filter = functionOn(cloud, Filter::GEODESIC);
  filter->SetSourceType(Filter::POINT);
  filter->SetSourcePoint(0.0, 0.0, 5.0);
  expectWarning(update(filter), { "1 of 500 points" });
  Eigen::Index highest = 0;
  points.row(2).array().isNaN().select(-2.0, points.row(2)).maxCoeff(&highest);
  EXPECT_EQ(resultOf(filter)[highest], 0.0);
}

TEST(PointChoice, constrainsThePointsNearestToPlaces)
{
  const Points points = Truth::randomSphere(500, 1);
  Eigen::Index lowest = 0;
  Eigen::Index highest = 0;
  points.row(2).minCoeff(&lowest);
  points.row(2).maxCoeff(&highest);
  const auto filter = functionOn(makeCloud(points), Filter::HARMONIC);
  filter->SetSourceType(Filter::POINT);
  filter->SetConstraintPoint1(0.0, 0.0, -2.0);
  filter->SetConstraintPoint2(0.0, 0.0, 2.0);
  Values values = silentResultOf(filter);
  EXPECT_NEAR(values[lowest], 0.0, 1e-9);
  EXPECT_NEAR(values[highest], 1.0, 1e-9);
  setConstraints(filter, {}, { 5.0, 3.0, 99.0 });
  values = silentResultOf(filter);
  EXPECT_NEAR(values[lowest], 5.0, 1e-9);
  EXPECT_NEAR(values[highest], 3.0, 1e-9);
}

// Selected points get the values in the order of their ids, or values from 0 to 1.
TEST(PointChoice, constrainsSelectedPoints)
{
  const auto filter = selectingFilter(
    sphere(), Filter::HARMONIC, selectIds(vtkSelectionNode::POINT, { 90, 10, 400 }));
  Values values = silentResultOf(filter);
  EXPECT_NEAR(values[10], 0.0, 1e-9);
  EXPECT_NEAR(values[90], 0.5, 1e-9);
  EXPECT_NEAR(values[400], 1.0, 1e-9);
  setConstraints(filter, {}, { 1.0, 3.0, 2.0 });
  values = silentResultOf(filter);
  EXPECT_NEAR(values[10], 1.0, 1e-9);
  EXPECT_NEAR(values[90], 3.0, 1e-9);
  EXPECT_NEAR(values[400], 2.0, 1e-9);
  setConstraints(filter, {}, { 1.0, 3.0 });
  expectFunctionRefusal(
    filter, { "needs as many ConstraintValues as constrained points (3), found 2." });
}

TEST(PointChoice, refusesNoPoints)
{
  const auto filter = functionOn(sphere(), Filter::GEODESIC);
  expectFunctionRefusal(filter,
    { "needs SourceIds, the points to start from, found none.", "SourceType Selection or Point" });
  filter->SetFunction(Filter::DIFFUSION);
  expectFunctionRefusal(filter, { "needs SourceIds, the points to start from, found none." });
  filter->SetFunction(Filter::HARMONIC);
  expectFunctionRefusal(
    filter, { "needs ConstraintIds, the points whose values are given, found none." });
  filter->SetSourceType(Filter::SELECTION);
  expectFunctionRefusal(filter, { "needs a Selection of points, found none." });
  filter->SetSelectionData(selectionOf(selectIds(vtkSelectionNode::POINT, { 5000 })));
  expectFunctionRefusal(
    filter, { "needs a Selection of points, found one of no points of the input." });
  filter->RemoveSelection();
  expectFunctionRefusal(filter, { "needs a Selection of points, found none." });
}

TEST(PointChoice, refusesQueries)
{
  vtkNew<vtkSelectionNode> node;
  node->SetContentType(vtkSelectionNode::QUERY);
  node->SetFieldType(vtkSelectionNode::POINT);
  node->SetQueryString("f > 0");
  expectFunctionRefusal(selectingFilter(sphere(), Filter::GEODESIC, node),
    { "needs a Selection of points or cells, found one of type QUERY." });
}

TEST(PointChoice, refusesIdsThatDoNotExist)
{
  const auto filter = functionOn(sphere(), Filter::GEODESIC);
  setSources(filter, { 3, 500 });
  expectFunctionRefusal(filter, { "needs SourceIds from 0 to 499, found 500." });
  setSources(filter, { -1 });
  expectFunctionRefusal(filter, { "needs SourceIds from 0 to 499, found -1." });
  filter->SetFunction(Filter::HARMONIC);
  setConstraints(filter, { 3, 500 }, { 1.0, 2.0 });
  expectFunctionRefusal(filter, { "needs ConstraintIds from 0 to 499, found 500." });
}

TEST(PointChoice, refusesMissingPoints)
{
  Points points = Truth::randomSphere(500, 1);
  points(1, 3) = NaN;
  const auto filter = functionOn(makeCloud(points), Filter::GEODESIC);
  setSources(filter, { 3 });
  expectFunctionRefusal(filter,
    { "needs SourceIds of points on the surface, found point 3, which has a NaN or infinite "
      "coordinate." });
  filter->SetSourceType(Filter::SELECTION);
  filter->SetSelectionData(selectionOf(selectIds(vtkSelectionNode::POINT, { 3 })));
  expectFunctionRefusal(filter, { "found point 3, which has a NaN" });
}

TEST(PointChoice, refusesContradictions)
{
  Points points = Truth::randomSphere(500, 1);
  points.col(7) = points.col(3);
  const auto filter = functionOn(makeCloud(points), Filter::HARMONIC);
  setConstraints(filter, { 3, 7 }, { 1.0, 2.0 });
  expectFunctionRefusal(filter,
    { "needs one value at each place, found 1 at point 3 and 2 at point 7, which is at the same "
      "place." });
  setConstraints(filter, { 3, 4, 3 }, { 1.0, 2.0, 5.0 });
  expectFunctionRefusal(filter, { "found 1 at point 3 and 5 at point 3." });
  filter->SetSourceType(Filter::POINT);
  filter->SetNumberOfConstraintValues(0);
  filter->SetConstraintPoint1(0.0, 0.0, 2.0);
  filter->SetConstraintPoint2(0.0, 0.0, 2.0);
  expectFunctionRefusal(filter, { "needs one value at each place, found 0 at point" });
}

TEST(PointChoice, refusesOtherNumbersOfValues)
{
  const auto filter = functionOn(sphere(), Filter::HARMONIC);
  setConstraints(filter, { 3, 7 }, { 1.0 });
  expectFunctionRefusal(
    filter, { "needs as many ConstraintValues as constrained points (2), found 1." });
  setConstraints(filter, { 3, 7 }, {});
  expectFunctionRefusal(filter, { "(2), found 0." });
  setConstraints(filter, { 3, 7 }, { 1.0, NaN });
  expectFunctionRefusal(
    filter, { "needs finite numbers as ConstraintValues, found nan at index 1." });
}

TEST(PointChoice, refusesAComponentWithoutConstraint)
{
  const auto filter = functionOn(makeCloud(twoSpheres()), Filter::HARMONIC);
  setConstraints(filter, { 3, 4 }, { 1.0, 2.0 });
  expectFunctionRefusal(filter,
    { "needs a constraint in each of the 2 connected components of the surface, found 1 without "
      "one, among them that of point 500 (500 points)." });
  setConstraints(filter, { 3, 4, 700 }, { 1.0, 2.0, 7.0 });
  const Values values = silentResultOf(filter);
  EXPECT_NEAR(values[999], 7.0, 1e-9);
}

TEST(PointChoice, refusesPlacesThatAreNone)
{
  const auto filter = functionOn(sphere(), Filter::GEODESIC);
  filter->SetSourceType(Filter::POINT);
  filter->SetSourcePoint(NaN, 0.0, 0.0);
  expectFunctionRefusal(filter, { "needs a finite SourcePoint, found (nan, 0, 0)." });
}

TEST(SurfaceFunctionRefusal, eigenIndexOutOfRange)
{
  const auto filter = functionOn(sphere(), Filter::LAPLACIAN_EIGENFUNCTION);
  filter->SetEigenIndex(499);
  expectFunctionRefusal(filter, { "needs an EigenIndex from 0 to 299, found 499." });
  filter->SetEigenIndex(-1);
  expectFunctionRefusal(filter, { "needs an EigenIndex from 0 to 299, found -1." });
}

TEST(SurfaceFunctionRefusal, weightsOfTrianglesWithoutTriangles)
{
  const auto cloud = sphere();
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(cloud->GetPoints());
  for (vtkDataObject* input : std::initializer_list<vtkDataObject*>{ cloud, grid })
  {
    for (const int weights : { 3, 4, 5 })
    {
      const auto filter = functionOn(input, Filter::DIFFUSION);
      setSources(filter, { 0 });
      filter->SetWeights(weights);
      expectFunctionRefusal(filter,
        { "needs a mesh of triangles, quads or strips for these Weights, found no triangle" });
    }
  }
}

// Eigenfunctions need a symmetric operator.
TEST(SurfaceFunctionRefusal, eigenfunctionsOfMeanValueWeights)
{
  const auto mesh = makeCloud(Truth::squareGrid(2, 1.0));
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ 0, 1, 3, 2 });
  mesh->SetPolys(cells);
  const auto filter = functionOn(mesh, Filter::LAPLACIAN_EIGENFUNCTION);
  filter->SetWeights(Filter::MEAN_VALUE);
  expectFunctionRefusal(filter, { "needs", "symmetric" });
}

TEST(SurfaceFunctionRefusal, choicesThatDoNotExist)
{
  const auto filter = functionOn(sphere(), Filter::DIFFUSION);
  setSources(filter, { 0 });
  filter->SetWeights(6);
  expectFunctionRefusal(filter, { "needs Weights from 0 (Gaussian) to 5 (MeanValue)", "found 6." });
  filter->SetWeights(2);
  filter->SetSourceType(3);
  expectFunctionRefusal(
    filter, { "needs SourceType 0 (Ids), 1 (Selection) or 2 (Point), found 3." });
}

TEST(SurfaceFunctionRefusal, numbersOutOfTheirRange)
{
  using Setting = std::function<void(Filter*)>;
  const std::vector<Setting> settings = {
    [](Filter* f) { f->SetNeighborCount(-1); },
    [](Filter* f) { f->SetSearchRadius(-1.0); },
    [](Filter* f) { f->SetSearchRadius(NaN); },
    [](Filter* f) { f->SetKernelWidth(-1.0); },
    [](Filter* f) { f->SetDiffusionTime(-1.0); },
    [](Filter* f) { f->SetDiffusionTime(NaN); },
  };
  for (std::size_t i = 0; i < settings.size(); ++i)
  {
    SCOPED_TRACE(i);
    const auto filter = functionOn(sphere(), Filter::DIFFUSION);
    setSources(filter, { 0 });
    settings[i](filter);
    expectFunctionRefusal(filter, { "needs", "found", "0 " });
  }
}

TEST(SurfaceFunctionRefusal, tooFewPoints)
{
  for (const int function : { 3, 4, 5, 6 })
  {
    SCOPED_TRACE(function);
    Points points = Points::Zero(3, 50);
    const auto filter = functionOn(makeCloud(points), function);
    setSources(filter, { 0 });
    setConstraints(filter, { 0 }, { 1.0 });
    expectFunctionRefusal(filter, { "needs at least 2 different points" });
    points.setConstant(NaN);
    filter->SetInputData(makeCloud(points));
    expectFunctionRefusal(filter, { "needs points with a finite position, found none among 50." });
    filter->SetInputData(vtkNew<vtkPolyData>());
    expectFunctionRefusal(filter, { "needs points, found none." });
  }
}

// Two points are a surface, of a kind.
TEST(SurfaceFunctionRefusal, doesNotStopAtTwoPoints)
{
  const Points points = (Points(3, 2) << 0, 3, 0, 4, 0, 0).finished();
  for (const int function : { 3, 4, 5, 6 })
  {
    SCOPED_TRACE(function);
    const auto filter = functionOn(makeCloud(points), function);
    filter->SetEigenIndex(0);
    setSources(filter, { 0 });
    setConstraints(filter, { 0 }, { 1.0 });
    EXPECT_TRUE(silentResultOf(filter).allFinite());
  }
}
