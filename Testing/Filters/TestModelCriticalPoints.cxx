// What vtkMeshCriticalPoints makes of a model.

#include "FieldTest.h"
#include "MeshTest.h"

#include "vtkMeshCriticalPoints.h"
#include "vtkRBFEvaluate.h"
#include "vtkRBFExtend.h"

#include "Functions.h"
#include "Sampling.h"

#include "vtkMultiBlockDataSet.h"
#include "vtkTable.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

using namespace SurfaceScalars;
using namespace SurfaceScalars::FilterTest;
using ::testing::ElementsAre;

namespace
{

/// The second output of vtkRBFExtend.
vtkSmartPointer<vtkPolyData> modelOf(vtkDataObject* samples, int kernel = vtkRBFExtend::CUBIC,
  int scheme = vtkRBFExtend::GLOBAL_RBF, double radius = 0.0)
{
  vtkNew<vtkRBFExtend> extend;
  extend->SetInputDataObject(samples);
  extend->SetTargetData(makeCloud(1.4 * Vector3d::UnitX()));
  extend->SetScheme(scheme);
  extend->SetKernel(kernel);
  extend->SetKernelWidth(kernel == vtkRBFExtend::CUBIC ? 0.0 : 0.6);
  extend->SetSearchRadius(radius);
  extend->Update();
  vtkSmartPointer<vtkPolyData> model = vtkPolyData::SafeDownCast(extend->GetOutputDataObject(1));
  return model;
}

/// At random places of the torus.
vtkSmartPointer<vtkPolyData> samplesOf(const std::function<double(const Vector3d&)>& function)
{
  const Points centers = Truth::randomTorus(300, Truth::Torus::Closed, 1);
  return makeCloud(centers, Truth::valuesOf(function, centers));
}

vtkSmartPointer<vtkPolyData> smoothModel()
{
  return modelOf(samplesOf(Truth::saddleWithLogarithm().value));
}

/// The model and its gradient at places.
vtkSmartPointer<vtkDataObject> evaluated(vtkPolyData* model, const Points& places)
{
  vtkNew<vtkRBFEvaluate> evaluate;
  evaluate->SetInputDataObject(model);
  evaluate->SetTargetData(makeCloud(places));
  evaluate->ComputeGradientOn();
  evaluate->Update();
  return evaluate->GetOutputDataObject(0);
}

/// The torus without an array.
vtkSmartPointer<vtkPolyData> bareTorus()
{
  const auto mesh = torusMesh(torusHeight());
  mesh->GetPointData()->RemoveArray("f");
  return mesh;
}

/// The same moved along x.
vtkSmartPointer<vtkPolyData> shiftedTorus(double distance)
{
  const auto mesh = bareTorus();
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const Vector3d place(mesh->GetPoint(i));
    mesh->GetPoints()->SetPoint(i, place.x() + distance, place.y(), place.z());
  }
  return mesh;
}

vtkSmartPointer<vtkMeshCriticalPoints> critical(vtkDataObject* input, vtkDataObject* model)
{
  auto filter = vtkSmartPointer<vtkMeshCriticalPoints>::New();
  filter->SetInputDataObject(input);
  filter->SetModelData(model);
  return filter;
}

double count(vtkMeshCriticalPoints* filter, const char* name)
{
  return fieldData(filter, name).at(0);
}

} // namespace

// Port 0 has u at the points and what they are to it; port 1 the places on the torus where the
// tangential gradient of u vanishes, with u there. No array is needed.
TEST(ModelCriticalPointsFilter, refinesTheCriticalPointsOfAModel)
{
  const auto model = smoothModel();
  const auto filter = critical(bareTorus(), model);
  expectSilentSuccess(update(filter));

  const Points points = TorusGrid::points();
  EXPECT_EQ(numbersOf(filter->GetOutput(), "f"), numbersOf(evaluated(model, points), "f"));
  EXPECT_STREQ(filter->GetOutput()->GetPointData()->GetScalars()->GetName(), "f");

  const auto found = criticalPointsOf(filter);
  const auto residuals = numbersOf(pointArray(filter, "Residual", 1));
  const auto refined = numbersOf(pointArray(filter, "Refined", 1));
  const auto iterations = numbersOf(pointArray(filter, "Iterations", 1));
  const auto ends = numbersOf(pointArray(filter, "RefinementEnd", 1));
  ASSERT_EQ(residuals.size(), found.size());
  Points places(3, static_cast<Eigen::Index>(found.size()));
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    places.col(static_cast<Eigen::Index>(i)) = found[i].position;
  }
  const auto there = evaluated(model, places);
  const Eigen::MatrixXd gradients = numbersOf(there, "fGradient");
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    EXPECT_EQ(refined[i], 1.0);
    EXPECT_EQ(ends[i], 0.0);
    EXPECT_LE(iterations[i], 10.0);
    EXPECT_LE(residuals[i], 1e-10 * count(filter, "GradientScale"));
    const auto column = static_cast<Eigen::Index>(i);
    EXPECT_NEAR(found[i].value, numbersOf(there, "f")(0, column), 1e-12);
    const Vector3d gradient = gradients.col(column);
    const Vector3d normal = Truth::torusNormal(Truth::torusAngles(found[i].position));
    EXPECT_LT((gradient - gradient.dot(normal) * normal).norm(), 0.02);
    const double distance = (points.colwise() - found[i].position).colwise().norm().minCoeff();
    EXPECT_DOUBLE_EQ(
      (points.col(static_cast<Eigen::Index>(found[i].input)) - found[i].position).norm(), distance);
  }
  for (const int port : { 0, 1 })
  {
    EXPECT_THAT(fieldData(filter, "IndexSum", port), ElementsAre(0.0));
    const auto counts = fieldData(filter, "CriticalCounts", port);
    EXPECT_EQ(counts[0] - counts[1] + counts[2], 0.0);
  }
  EXPECT_EQ(count(filter, "RefinedCount"), static_cast<double>(found.size()));
  EXPECT_EQ(count(filter, "CandidateCount"),
    count(filter, "RefinedCount") + count(filter, "MergedCount") + count(filter, "VanishedCount"));
}

// Without a model, or after it is removed, everything is as if there had never been one.
TEST(ModelCriticalPointsFilter, isAsBeforeWithoutOne)
{
  const auto filter = critical(torusMesh(torusHeight()), smoothModel());
  EXPECT_TRUE(update(filter).succeeded);
  EXPECT_TRUE(pointArray(filter, "Refined", 1));
  filter->RemoveModel();
  expectSilentSuccess(update(filter));
  EXPECT_FALSE(pointArray(filter, "Refined", 1));
  EXPECT_FALSE(filter->GetOutput()->GetFieldData()->HasArray("IndexSum"));
  EXPECT_EQ(criticalPointsOf(filter).size(), 4U);
}

// An array of the mesh with the model's name makes room, with a warning.
TEST(ModelCriticalPointsFilter, keepsTheArraysOfTheMesh)
{
  const auto filter = critical(torusMesh(torusHeight()), smoothModel());
  expectWarning(update(filter), { "fInput" });
  EXPECT_TRUE(pointArray(filter, "fInput"));
  EXPECT_STREQ(filter->GetOutput()->GetPointData()->GetScalars()->GetName(), "f");
}

// Pairs join points of port 1, and thresholds hold.
TEST(ModelCriticalPointsFilter, drawsPairsAndHeedsThresholds)
{
  const auto filter = critical(bareTorus(),
    modelOf(
      samplesOf([](const Vector3d& p) { return std::sin(5.0 * p.x()) * std::cos(4.0 * p.y()); })));
  filter->SetPersistenceThreshold(0.05);
  filter->Update();
  const auto points = criticalPointsOf(filter, 2);
  const auto all = criticalPointsOf(filter, 1);
  ASSERT_EQ(points.size(), all.size());
  EXPECT_GT(filter->GetOutput(2)->GetNumberOfLines(), 3);
  vtkNew<vtkIdList> ends;
  for (vtkIdType line = 0; line < filter->GetOutput(2)->GetNumberOfLines(); ++line)
  {
    filter->GetOutput(2)->GetCellPoints(line, ends);
    EXPECT_NE(points[static_cast<std::size_t>(ends->GetId(0))].type, CriticalType::Saddle);
    EXPECT_EQ(points[static_cast<std::size_t>(ends->GetId(1))].type, CriticalType::Saddle);
  }
  EXPECT_THAT(fieldData(filter, "IndexSum"), ElementsAre(0.0));
  for (const CriticalPoint& point : all)
  {
    EXPECT_GE(point.persistence, 0.05);
  }
}

// What is no model is refused in one sentence, and the outputs are empty.
TEST(ModelCriticalPointsFilter, refusesWhatIsNoModel)
{
  const std::vector<vtkSmartPointer<vtkDataObject>> inputs{ vtkSmartPointer<vtkTable>::New(),
    bareTorus(), vtkSmartPointer<vtkPolyData>::New() };
  for (const auto& wrong : inputs)
  {
    const auto filter = critical(bareTorus(), wrong);
    expectFailure(filter, update(filter), "Mesh Critical Points", { "a Model", "RBF Extend" });
  }
}

// Constant models, kernels with tips at their centers and places far from all centers are told of.
TEST(ModelCriticalPointsFilter, saysWhatItCannotDo)
{
  const auto constant =
    critical(bareTorus(), modelOf(samplesOf([](const Vector3d&) { return 3.0; })));
  expectWarning(update(constant), { "The model is constant on the mesh" });
  EXPECT_THAT(fieldData(constant, "IndexSum"), ElementsAre(0.0));

  const auto tips = critical(bareTorus(), modelOf(noisyTorus(), vtkRBFExtend::EXPONENTIAL));
  expectWarning(update(tips), { "Refined 0", "Exponential has no second derivatives" });
  EXPECT_THAT(fieldData(tips, "IndexSum"), ElementsAre(0.0));

  const auto far = critical(shiftedTorus(3.5), smoothModel());
  expectWarning(update(far), { "1152 of 1152 points are outside of the model's extent" });
}

// Where a model of local neighborhoods has no value the mesh has holes, as with missing values.
TEST(ModelCriticalPointsFilter, leavesOutWhereThereIsNoModel)
{
  const auto filter = critical(shiftedTorus(0.8),
    modelOf(samplesOf(Truth::saddleWithLogarithm().value), vtkRBFExtend::CUBIC,
      vtkRBFExtend::LOCAL_RBF, 0.4));
  expectWarning(update(filter), { "is NaN or infinite" });
  const auto types = numbersOf(pointArray(filter, "CriticalType"));
  EXPECT_GT(std::count(types.begin(), types.end(), -1.0), 20);
  EXPECT_EQ(fieldData(filter, "IndexSum"), fieldData(filter, "EulerCharacteristic"));
}

// The blocks of a composite dataset are meshes of their own, the model is one for all.
TEST(ModelCriticalPointsFilter, takesOneModelForAllBlocks)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, bareTorus());
  blocks->SetBlock(1, bareTorus());
  const auto filter = critical(blocks, smoothModel());
  EXPECT_TRUE(update(filter).errors.empty());
  auto* points = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(1));
  ASSERT_TRUE(points);
  const auto alone = critical(bareTorus(), smoothModel());
  alone->Update();
  for (unsigned block = 0; block < 2; ++block)
  {
    EXPECT_EQ(vtkPolyData::SafeDownCast(points->GetBlock(block))->GetNumberOfPoints(),
      alone->GetOutput(1)->GetNumberOfPoints());
  }
}

// It can be stopped while u is evaluated and while its points are refined.
TEST(ModelCriticalPointsFilter, stops)
{
  const auto filter = critical(bareTorus(), smoothModel());
  for (const double fraction : { 0.3, 0.72, 0.9 })
  {
    expectNothingWhenStopped(filter, fraction);
  }
}
