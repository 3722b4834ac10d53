// What vtkFuzzyCriticalPoints writes, what its properties do, how it runs. Whether the critical
// points are the right ones is tested in Testing/Core.

#include "CriticalPointTest.h"

#include "vtkCallbackCommand.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

using namespace SurfaceScalars;
using namespace SurfaceScalars::FilterTest;

TEST(FuzzyCriticalPoints, haveTheDefaultsOfTheInterface)
{
  vtkNew<vtkFuzzyCriticalPoints> filter;
  EXPECT_EQ(filter->GetScheme(), 2);
  EXPECT_EQ(filter->GetPolynomialDegree(), 2);
  EXPECT_EQ(filter->GetNeighborCount(), 0);
  EXPECT_EQ(filter->GetSearchRadius(), 0.0);
  EXPECT_EQ(filter->GetKernel(), 3);
  EXPECT_EQ(filter->GetKernelWidth(), 0.0);
  EXPECT_EQ(filter->GetProbabilityModel(), 0);
  EXPECT_EQ(filter->GetVolumeFunction(), nullptr);
  EXPECT_EQ(filter->GetProbabilityThreshold(), 0.0);
  EXPECT_EQ(filter->GetPersistenceThreshold(), 0.0);
  EXPECT_TRUE(filter->GetRefine());
}

// The tilted torus has a minimum, two saddles and a maximum, where its height has them.
TEST(FuzzyCriticalPoints, areVerticesWithArrays)
{
  const auto cloud = tiltedTorus();
  vtkNew<vtkFuzzyCriticalPoints> filter;
  filter->SetInputData(cloud);
  expectSilentSuccess(update(filter));
  EXPECT_EQ(typesOf(filter), TorusTypes);
  EXPECT_EQ(filter->GetOutput(1)->GetNumberOfVerts(), 4);
  EXPECT_EQ(filter->GetOutput(1)->GetPoints()->GetDataType(), VTK_DOUBLE);
  vtkPointData* data = filter->GetOutput(1)->GetPointData();
  EXPECT_NE(vtkIntArray::SafeDownCast(data->GetArray("CriticalType")), nullptr);
  EXPECT_NE(vtkIntArray::SafeDownCast(data->GetArray("Multiplicity")), nullptr);
  EXPECT_NE(vtkIdTypeArray::SafeDownCast(data->GetArray("PointId")), nullptr);

  const double range = cloud->GetPointData()->GetScalars()->GetRange()[1] -
    cloud->GetPointData()->GetScalars()->GetRange()[0];
  for (const CriticalPoint& point : criticalPointsOf(filter))
  {
    EXPECT_EQ(point.multiplicity, 1);
    EXPECT_NEAR(point.value, tiltedHeight(point.position), 1e-2);
    EXPECT_GT(point.probability, 0.3);
    EXPECT_LE(point.probability, 1.0);
    EXPECT_GE(point.residual, 0.0);
    EXPECT_LT(point.residual, 1e-2);
    EXPECT_NEAR(point.persistence, range, 0.01 * range); // all are there for good
    const Vector3d sample(cloud->GetPoint(static_cast<vtkIdType>(point.input)));
    EXPECT_LT((sample - point.position).norm(), 0.05);
    EXPECT_EQ(sampleArray(filter, "CriticalType")->GetTuple1(static_cast<vtkIdType>(point.input)),
      static_cast<double>(point.type));
  }
  for (int port = 0; port < 2; ++port)
  {
    vtkFieldData* field = filter->GetOutput(port)->GetFieldData();
    EXPECT_EQ(field->GetArray("IndexSum")->GetTuple1(0), 0.0);
    EXPECT_GT(field->GetArray("NeighborCount")->GetTuple1(0), 0.0);
  }
}

// Every sample has a probability, the gradient along the surface and the normal of the torus.
TEST(FuzzyCriticalPoints, describeEverySample)
{
  const auto cloud = tiltedTorus();
  vtkNew<vtkFuzzyCriticalPoints> filter;
  filter->SetInputData(cloud);
  expectSilentSuccess(update(filter));
  vtkPolyData* output = filter->GetOutput();
  EXPECT_EQ(output->GetPoints(), cloud->GetPoints());
  EXPECT_STREQ(output->GetPointData()->GetScalars()->GetName(), "f");
  EXPECT_STREQ(output->GetPointData()->GetNormals()->GetName(), "Normals");
  int regular = 0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const double probability = sampleArray(filter, "CriticalProbability")->GetTuple1(i);
    EXPECT_TRUE(probability >= 0.0 && probability <= 1.0);
    const Vector3d normal(sampleArray(filter, "Normals")->GetTuple3(i));
    const Vector3d expected = Truth::torusNormal(Truth::torusAngles(Vector3d(output->GetPoint(i))));
    EXPECT_GT(std::abs(normal.dot(expected)), 0.99);
    const Vector3d gradient(sampleArray(filter, "Gradient")->GetTuple3(i));
    const Vector3d up = Vector3d(0.9, 0.2, 0.4).normalized();
    EXPECT_LT((gradient - (up - up.dot(expected) * expected)).norm(), 0.1);
    EXPECT_NEAR(gradient.dot(normal), 0.0, 1e-6);
    regular += sampleArray(filter, "CriticalType")->GetTuple1(i) == 5.0;
  }
  EXPECT_EQ(regular, output->GetNumberOfPoints() - 4);
}

TEST(FuzzyCriticalPoints, chooseTheArray)
{
  const auto cloud = tiltedTorus();
  Values heights(cloud->GetNumberOfPoints());
  for (vtkIdType i = 0; i < cloud->GetNumberOfPoints(); ++i)
  {
    heights[i] = -tiltedHeight(Vector3d(cloud->GetPoint(i)));
  }
  addArray<vtkDoubleArray>(cloud, "depth", heights);
  vtkNew<vtkFuzzyCriticalPoints> filter;
  filter->SetInputData(cloud);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "depth");
  expectSilentSuccess(update(filter));
  EXPECT_EQ(typesOf(filter), TorusTypes);
  EXPECT_LT(criticalPointsOf(filter).front().value, -0.9);
  EXPECT_STREQ(filter->GetOutput()->GetPointData()->GetScalars()->GetName(), "depth");
}

// Every scheme finds critical points; the averages of (6), biased as they are, not all of them.
TEST(FuzzyCriticalPoints, offerEveryScheme)
{
  for (const int scheme : { 1, 2, 3, 4 })
  {
    SCOPED_TRACE(scheme);
    vtkNew<vtkFuzzyCriticalPoints> filter;
    filter->SetInputData(tiltedTorus());
    filter->SetScheme(scheme);
    expectSilentSuccess(update(filter));
    const std::vector<CriticalType> types = typesOf(filter);
    EXPECT_THAT(types, ::testing::Contains(CriticalType::Saddle));
    if (scheme == 2 || scheme == 3)
    {
      EXPECT_THAT(types, ::testing::Contains(CriticalType::Minimum));
      EXPECT_THAT(types, ::testing::Contains(CriticalType::Maximum));
    }
  }
}

TEST(FuzzyCriticalPoints, offerEveryKernel)
{
  for (int kernel = 0; kernel <= 8; ++kernel)
  {
    SCOPED_TRACE(kernel);
    vtkNew<vtkFuzzyCriticalPoints> filter;
    filter->SetInputData(tiltedTorus(3000));
    filter->SetScheme(3);
    filter->SetKernel(kernel);
    expectSilentSuccess(update(filter));
    EXPECT_THAT(typesOf(filter), ::testing::Contains(CriticalType::Maximum));
  }
}

// Degree, neighbors, radius and width change the fits; the features stay.
TEST(FuzzyCriticalPoints, chooseTheFit)
{
  using Setting = std::function<void(vtkFuzzyCriticalPoints*)>;
  const std::vector<Setting> settings = {
    [](vtkFuzzyCriticalPoints* f) { f->SetPolynomialDegree(3); },
    [](vtkFuzzyCriticalPoints* f) { f->SetNeighborCount(60); },
    [](vtkFuzzyCriticalPoints* f) { f->SetSearchRadius(0.12); },
  };
  vtkNew<vtkFuzzyCriticalPoints> usual;
  usual->SetInputData(tiltedTorus());
  expectSilentSuccess(update(usual));
  for (std::size_t i = 0; i < settings.size(); ++i)
  {
    SCOPED_TRACE(i);
    vtkNew<vtkFuzzyCriticalPoints> filter;
    filter->SetInputData(tiltedTorus());
    settings[i](filter);
    expectSilentSuccess(update(filter));
    EXPECT_EQ(typesOf(filter), TorusTypes);
    EXPECT_NE(sampleArray(filter, "Gradient")->GetComponent(0, 0),
      sampleArray(usual, "Gradient")->GetComponent(0, 0));
  }
  vtkNew<vtkFuzzyCriticalPoints> filter;
  filter->SetInputData(tiltedTorus());
  filter->SetNeighborCount(40);
  expectSilentSuccess(update(filter));
  EXPECT_EQ(filter->GetOutput(1)->GetFieldData()->GetArray("NeighborCount")->GetTuple1(0), 40.0);
  filter->SetSearchRadius(0.12);
  expectSilentSuccess(update(filter));
  EXPECT_EQ(filter->GetOutput(1)->GetFieldData()->GetArray("NeighborCount")->GetTuple1(0), 0.0);
}

// The height is the function of a plane: where its gradient is the normal, the probability is 1.
TEST(FuzzyCriticalPoints, compareWithAVolumeFunction)
{
  vtkNew<vtkPlane> plane;
  const Vector3d up = Vector3d(0.9, 0.2, 0.4).normalized();
  plane->SetNormal(up.x(), up.y(), up.z());
  vtkNew<vtkFuzzyCriticalPoints> filter;
  filter->SetInputData(tiltedTorus());
  filter->SetProbabilityModel(vtkFuzzyCriticalPoints::NORMAL_ANGLE);
  filter->SetVolumeFunction(plane);
  expectSilentSuccess(update(filter));
  EXPECT_EQ(typesOf(filter), TorusTypes);
  double error = 0.0;
  for (vtkIdType i = 0; i < filter->GetOutput()->GetNumberOfPoints(); ++i)
  {
    const Vector3d p(filter->GetOutput()->GetPoint(i));
    const double cosine = std::abs(up.dot(Truth::torusNormal(Truth::torusAngles(p))));
    error =
      std::max(error, std::abs(sampleArray(filter, "CriticalProbability")->GetTuple1(i) - cosine));
  }
  EXPECT_LT(error, 0.05);

  const vtkMTimeType before = filter->GetMTime();
  plane->SetNormal(0.0, 0.0, 1.0);
  EXPECT_GT(filter->GetMTime(), before);
  filter->SetVolumeFunction(nullptr);
  expectFailure(filter, update(filter), "Fuzzy Critical Points", { "needs", "VolumeFunction" });
}

// Small bumps on a slope vanish above their persistence.
TEST(FuzzyCriticalPoints, leaveOutWhatDoesNotPersist)
{
  const auto bumps = [](const Vector3d& p)
  { return p.x() + 0.2 * std::sin(8.0 * p.x()) * std::sin(8.0 * p.y()); };
  vtkNew<vtkFuzzyCriticalPoints> filter;
  filter->SetInputData(makeCloud(Truth::randomPlane(20000, 1), bumps));
  expectSilentSuccess(update(filter));
  const std::vector<CriticalPoint> all = criticalPointsOf(filter);
  EXPECT_GT(all.size(), 8u);
  filter->SetPersistenceThreshold(0.05);
  expectSilentSuccess(update(filter));
  const std::vector<CriticalPoint> kept = criticalPointsOf(filter);
  EXPECT_LT(kept.size(), all.size());
  vtkDataArray* f = filter->GetOutput()->GetPointData()->GetScalars();
  for (const CriticalPoint& point : kept)
  {
    EXPECT_GE(point.persistence, 0.05 * (f->GetRange()[1] - f->GetRange()[0]));
  }
}

// None has the probability 1 at a sample, off which it lies.
TEST(FuzzyCriticalPoints, leaveOutWhatIsNotProbable)
{
  vtkNew<vtkFuzzyCriticalPoints> filter;
  filter->SetInputData(tiltedTorus());
  filter->SetProbabilityThreshold(1.0);
  expectSilentSuccess(update(filter));
  EXPECT_THAT(typesOf(filter), ::testing::IsEmpty());
  filter->SetProbabilityThreshold(0.1);
  expectSilentSuccess(update(filter));
  EXPECT_EQ(typesOf(filter), TorusTypes);
}

// Without refinement critical points are samples.
TEST(FuzzyCriticalPoints, stayAtSamplesUnlessRefined)
{
  const auto cloud = tiltedTorus();
  vtkNew<vtkFuzzyCriticalPoints> filter;
  filter->SetInputData(cloud);
  filter->RefineOff();
  expectSilentSuccess(update(filter));
  EXPECT_EQ(typesOf(filter), TorusTypes);
  for (const CriticalPoint& point : criticalPointsOf(filter))
  {
    const Vector3d sample(cloud->GetPoint(static_cast<vtkIdType>(point.input)));
    EXPECT_LT((point.position - sample).norm(), 1e-12);
  }
}

TEST(FuzzyCriticalPoints, areNoneOfAConstant)
{
  vtkNew<vtkFuzzyCriticalPoints> filter;
  filter->SetInputData(
    makeCloud(Truth::randomSphere(1000, 1), [](const Vector3d&) { return 3.0; }));
  expectWarning(update(filter),
    { "Fuzzy Critical Points: 'f' is 3 everywhere: a constant function has no critical points." });
  EXPECT_THAT(criticalPointsOf(filter), ::testing::IsEmpty());
  EXPECT_NE(filter->GetOutput(1)->GetPointData()->GetArray("PointId"), nullptr);
  for (vtkIdType i = 0; i < 1000; ++i)
  {
    EXPECT_EQ(sampleArray(filter, "CriticalType")->GetTuple1(i), 5.0);
  }
}

TEST(FuzzyCriticalPoints, areTheSameForEveryNumberOfThreads)
{
  const auto cloud = tiltedTorus(20000);
  std::vector<std::vector<CriticalPoint>> points;
  std::vector<std::vector<double>> probabilities;
  for (const int threads : { 1, 2 })
  {
    vtkSMPTools::Initialize(threads);
    vtkNew<vtkFuzzyCriticalPoints> filter;
    filter->SetInputData(cloud);
    expectSilentSuccess(update(filter));
    points.push_back(criticalPointsOf(filter));
    auto* array = vtkDoubleArray::SafeDownCast(sampleArray(filter, "CriticalProbability"));
    probabilities.emplace_back(array->GetPointer(0), array->GetPointer(array->GetNumberOfTuples()));
  }
  vtkSMPTools::Initialize(0);
  EXPECT_EQ(probabilities[0], probabilities[1]);
  ASSERT_EQ(points[0].size(), points[1].size());
  for (std::size_t i = 0; i < points[0].size(); ++i)
  {
    EXPECT_EQ(points[0][i].position, points[1][i].position);
    EXPECT_EQ(points[0][i].residual, points[1][i].residual);
  }
}

// Progress never falls, comes in many steps and ends at 1.
TEST(FuzzyCriticalPoints, showProgress)
{
  std::vector<double> shown;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&shown);
  observer->SetCallback([](vtkObject*, unsigned long, void* list, void* fraction)
    { static_cast<std::vector<double>*>(list)->push_back(*static_cast<double*>(fraction)); });
  vtkNew<vtkFuzzyCriticalPoints> filter;
  filter->SetInputData(tiltedTorus(100000));
  filter->AddObserver(vtkCommand::ProgressEvent, observer);
  expectSilentSuccess(update(filter));
  EXPECT_TRUE(std::is_sorted(shown.begin(), shown.end()));
  EXPECT_GT(shown.size(), 20u);
  EXPECT_EQ(shown.back(), 1.0);
}

// Stopped anywhere, the filter leaves nothing and says nothing; run again, it does all its work.
TEST(FuzzyCriticalPoints, leaveNothingWhenStopped)
{
  const auto cloud = tiltedTorus(100000);
  for (const double fraction : { 0.01, 0.2, 0.45, 0.7, 0.9 })
  {
    SCOPED_TRACE(fraction);
    vtkNew<vtkFuzzyCriticalPoints> filter;
    filter->SetInputData(cloud);
    expectNothingWhenStopped(filter, fraction);
    expectSilentSuccess(update(filter));
    EXPECT_EQ(typesOf(filter), TorusTypes);
  }
}

TEST(FuzzyCriticalPoints, arePrinted)
{
  vtkNew<vtkFuzzyCriticalPoints> filter;
  std::ostringstream text;
  filter->Print(text);
  EXPECT_THAT(text.str(), ::testing::HasSubstr("ProbabilityModel: 0"));
  EXPECT_THAT(text.str(), ::testing::HasSubstr("Refine: 1"));
}
