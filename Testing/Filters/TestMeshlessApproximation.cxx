// vtkMeshlessApproximation: what it writes for surfaces and volumes, and that the figures are true.

#include "ApproximationTest.h"

#include "vtkFloatArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkRBFEvaluate.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLPolyDataWriter.h"

#include <cstdio>

using namespace SurfaceScalars;
using namespace SurfaceScalars::FilterTest;

namespace
{

/// u at the places, by the model.
Eigen::MatrixXd evaluated(vtkPolyData* model, vtkDataSet* target)
{
  vtkNew<vtkRBFEvaluate> evaluate;
  evaluate->SetInputData(model);
  evaluate->SetTargetData(target);
  evaluate->SetResultArrayName("u");
  expectSilentSuccess(update(evaluate));
  return numbersOf(evaluate->GetOutputDataObject(0), "u");
}

vtkSmartPointer<vtkPolyData> throughFile(vtkPolyData* model)
{
  const std::string name = testing::TempDir() + "approximation.vtp";
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetFileName(name.c_str());
  writer->SetInputData(model);
  writer->SetDataModeToBinary();
  writer->Write();
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(name.c_str());
  reader->Update();
  std::remove(name.c_str());
  return reader->GetOutput();
}

} // namespace

// The arrays and figures say of each other what they should.
TEST(MeshlessApproximation, figuresAreTrue)
{
  const std::array<vtkSmartPointer<vtkDataSet>, 2> inputs{ torusMesh(torusHills()),
    slopeImage(12, 12, 12) };
  for (vtkDataSet* input : inputs)
  {
    SCOPED_TRACE(input->GetClassName());
    const auto filter = approximation(input);
    expectSilentSuccess(update(filter));
    vtkDataObject* output = filter->GetOutputDataObject(0);
    EXPECT_STREQ(output->GetClassName(), input->GetClassName());
    const Eigen::MatrixXd f = numbersOf(output, "f");
    const Eigen::MatrixXd u = numbersOf(output, "fApproximation");
    const Eigen::MatrixXd error = numbersOf(output, "ApproximationError");
    ASSERT_EQ(u.cols(), input->GetNumberOfPoints());
    EXPECT_EQ(error, f - u);
    EXPECT_EQ(figure(filter, "LInfinityError"), error.cwiseAbs().maxCoeff());
    EXPECT_NEAR(figure(filter, "MeanError"), error.cwiseAbs().mean(), 1e-15);
    const double count = figure(filter, "CentreCount");
    EXPECT_EQ(count, model(filter)->GetNumberOfPoints());
    EXPECT_LT(count, 0.6 * static_cast<double>(input->GetNumberOfPoints()));
    EXPECT_EQ(figure(filter, "ModelBytes"), 8.0 * (4.0 * count + 4.0 + 3.0));
    EXPECT_EQ(figure(filter, "ScalarBytes"), 8.0 * static_cast<double>(u.cols()));
    EXPECT_EQ(figure(filter, "SpaceSaving"),
      1.0 - figure(filter, "ModelBytes") / figure(filter, "ScalarBytes"));
    EXPECT_GE(figure(filter, "ConditionNumber"), 1.0);
    EXPECT_EQ(figure(filter, "Missing"), 0.0);
    EXPECT_LT(error.cwiseAbs().maxCoeff(), 0.02 * (f.maxCoeff() - f.minCoeff()));
  }
}

// Each critical point of f is one of u, with its type and multiplicity, and is said to be.
TEST(MeshlessApproximation, keepsCriticalPoints)
{
  const auto mesh = torusMesh(torusHills());
  const auto filter = approximation(mesh);
  expectSilentSuccess(update(filter));
  vtkNew<vtkMeshCriticalPoints> expected;
  expected->SetInputData(mesh);
  expectSilentSuccess(update(expected));
  const auto ids = numbersOf(critical(filter), "PointId");
  const auto types = numbersOf(critical(filter), "CriticalType");
  const auto prescribed = numbersOf(critical(filter), "Prescribed");
  for (vtkIdType i = 0; i < expected->GetOutput(1)->GetNumberOfPoints(); ++i)
  {
    const double id = numbersOf(expected->GetOutput(1), "PointId")(0, i);
    const double type = numbersOf(expected->GetOutput(1), "CriticalType")(0, i);
    const auto found = std::find(ids.data(), ids.data() + ids.size(), id) - ids.data();
    ASSERT_LT(found, ids.size()) << id;
    EXPECT_EQ(types(0, found), type);
    EXPECT_EQ(prescribed(0, found), 1.0);
  }
  EXPECT_EQ(prescribed.sum(), static_cast<double>(expected->GetOutput(1)->GetNumberOfPoints()));
}

// The model is u: on the input's points to rounding, and through a file to the same bits.
TEST(MeshlessApproximation, modelIsTheFunction)
{
  const auto mesh = torusMesh(torusHills());
  const auto filter = approximation(mesh);
  expectSilentSuccess(update(filter));
  const Eigen::MatrixXd u = numbersOf(filter->GetOutputDataObject(0), "fApproximation");
  const Eigen::MatrixXd direct = evaluated(model(filter), mesh);
  EXPECT_LT((direct - u).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_EQ(evaluated(throughFile(model(filter)), mesh), direct);
}

// An image is approximated as the grid of tetrahedra that it is cut into.
TEST(MeshlessApproximation, takesTetrahedraAndImagesAlike)
{
  const auto image = slopeImage(8, 7, 6);
  const auto byImage = approximation(image);
  const auto byGrid = approximation(tetrahedraOf(image));
  expectSilentSuccess(update(byImage));
  expectSilentSuccess(update(byGrid));
  EXPECT_STREQ(byGrid->GetOutputDataObject(0)->GetClassName(), "vtkUnstructuredGrid");
  EXPECT_EQ(numbersOf(byImage->GetOutputDataObject(0), "fApproximation"),
    numbersOf(byGrid->GetOutputDataObject(0), "fApproximation"));
}

// A flat image is a surface: a picture.
TEST(MeshlessApproximation, takesPictures)
{
  const auto filter = approximation(slopeImage(20, 15, 1));
  expectSilentSuccess(update(filter));
  EXPECT_EQ(numbersOf(filter->GetOutputDataObject(0), "fApproximation").cols(), 300);
  EXPECT_EQ(figure(filter, "Missing"), 0.0);
}

// Linear functions cost nothing: the polynomial of the cubic kernel is f.
TEST(MeshlessApproximation, reproducesLinearFunctions)
{
  const auto filter = approximation(squareMesh(20));
  expectSilentSuccess(update(filter));
  EXPECT_LT(figure(filter, "LInfinityError"), 1e-10);
}

// f's bytes are those of its array.
TEST(MeshlessApproximation, countsBytesAsTheyAreStored)
{
  const auto mesh = torusMesh(torusHills());
  addArray<vtkFloatArray>(mesh, "single", torusHills());
  const auto filter = approximation(mesh);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "single");
  expectSilentSuccess(update(filter));
  EXPECT_EQ(figure(filter, "ScalarBytes"), 4.0 * 1152.0);
  EXPECT_EQ(numbersOf(filter->GetOutputDataObject(0), "singleApproximation").cols(), 1152);
}

// The result can have any name; arrays of the names needed are renamed.
TEST(MeshlessApproximation, namesTheResult)
{
  const auto filter = approximation(torusMesh(torusHills()));
  filter->SetResultArrayName("f");
  expectWarning(update(filter), { "'fInput'" });
  filter->SetResultArrayName("ApproximationError");
  expectWarning(update(filter), { "'ApproximationErrorInput'" });
  filter->SetResultArrayName("u");
  expectSilentSuccess(update(filter));
  EXPECT_EQ(numbersOf(filter->GetOutputDataObject(0), "u").cols(), 1152);
}

// Other choices of centers and constraints keep the critical points, too.
TEST(MeshlessApproximation, offersThePapersChoices)
{
  const std::array<vtkSmartPointer<vtkDataSet>, 2> inputs{ torusMesh(torusHills()),
    slopeImage(12, 12, 12) };
  for (std::size_t choice = 0; choice < 12; ++choice)
  {
    SCOPED_TRACE(choice);
    const auto filter = approximation(inputs[choice / 6]);
    filter->SetCentreSelection(static_cast<int>(choice % 2));
    filter->SetLevelSetConstraints(static_cast<int>(choice / 2 % 3));
    expectSilentSuccess(update(filter));
    EXPECT_EQ(figure(filter, "Missing"), 0.0);
    EXPECT_LT(figure(filter, "LInfinityError"), 0.1);
  }
}

// Blocks are worked on one by one.
TEST(MeshlessApproximation, worksOnBlocks)
{
  const auto mesh = torusMesh(torusHills());
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, mesh);
  blocks->SetBlock(1, slopeImage(8, 8, 8));
  const auto filter = approximation(blocks);
  expectSilentSuccess(update(filter));
  const auto alone = approximation(mesh);
  expectSilentSuccess(update(alone));
  auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  ASSERT_TRUE(output);
  EXPECT_EQ(numbersOf(output->GetBlock(0), "fApproximation"),
    numbersOf(alone->GetOutputDataObject(0), "fApproximation"));
  EXPECT_EQ(numbersOf(output->GetBlock(1), "fApproximation").cols(), 512);
  auto* models = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(1));
  ASSERT_TRUE(models);
  EXPECT_GT(vtkPolyData::SafeDownCast(models->GetBlock(1))->GetNumberOfPoints(), 0);
}
