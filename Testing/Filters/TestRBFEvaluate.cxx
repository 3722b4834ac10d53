// vtkRBFEvaluate: the model of vtkRBFExtend, also from a file, gives the same bits; what is no
// model is refused.

#include "FieldTest.h"

#include "vtkRBFEvaluate.h"

#include "vtkCallbackCommand.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLPolyDataWriter.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <limits>
#include <sstream>

using namespace SurfaceScalars;
using namespace SurfaceScalars::FilterTest;

namespace
{

/// Far from the origin, where rounding would show, with some duplicates.
vtkSmartPointer<vtkPolyData> mapSamples()
{
  Points points = 1000.0 * randomCube(400, 1);
  points.rightCols(20) = points.leftCols(20);
  points.colwise() += Vector3d(4.0e6, 5.0e5, 100.0);
  return makeCloud(
    points, [](const Vector3d& p) { return std::sin(0.003 * p.x()) + 0.01 * p.z(); });
}

vtkSmartPointer<vtkPolyData> mapTarget()
{
  Points points = 1200.0 * randomCube(100, 2);
  points.colwise() += Vector3d(4.0e6, 5.0e5, 100.0);
  return makeCloud(points);
}

vtkSmartPointer<vtkPolyData> copyOf(vtkDataObject* data)
{
  const auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(data);
  return copy;
}

vtkSmartPointer<vtkPolyData> makeModel(int scheme = 3)
{
  vtkNew<vtkRBFExtend> filter;
  filter->SetInputData(waveSamples());
  filter->SetScheme(scheme);
  filter->SetGridDimensions(2, 2, 2);
  expectSilentSuccess(update(filter));
  return copyOf(filter->GetOutputDataObject(1));
}

std::string write(vtkDataObject* model, const std::string& name)
{
  const std::string path = std::string(SURFACE_SCALARS_OUTPUT) + "/" + name;
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputData(model);
  writer->SetDataModeToBinary();
  EXPECT_EQ(writer->Write(), 1);
  return path;
}

vtkSmartPointer<vtkPolyData> read(const std::string& path)
{
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutput();
}

template <typename Filter>
void computeAll(Filter* filter, vtkDataObject* target)
{
  filter->SetTargetData(target);
  filter->ComputeGradientOn();
  filter->ComputeHessianOn();
  expectSilentSuccess(update(filter));
}

void expectRefusal(vtkPolyData* model, std::initializer_list<const char*> parts)
{
  vtkNew<vtkRBFEvaluate> filter;
  filter->SetInputData(model);
  filter->SetTargetData(makeCloud(randomCube(10, 1)));
  expectFailure(filter, update(filter), "RBF Evaluate", parts);
}

/// A model whose field data has this number.
template <typename Array>
vtkSmartPointer<vtkPolyData> modelWith(const char* name, double number)
{
  auto model = makeModel();
  vtkNew<Array> array;
  array->SetName(name);
  array->InsertNextTuple1(number);
  model->GetFieldData()->AddArray(array);
  return model;
}

} // namespace

// From memory and from a file, for every scheme: value, gradient, Hessian and validity.
TEST(RBFEvaluate, givesTheSameBits)
{
  for (const int scheme : { 1, 2, 3, 4, 5 })
  {
    SCOPED_TRACE(scheme);
    vtkNew<vtkRBFExtend> extend;
    extend->SetInputData(mapSamples());
    extend->SetScheme(scheme);
    extend->SetMaximumDistance(300.0);
    computeAll(extend.Get(), mapTarget());
    const Eigen::MatrixXd valid = numbersOf(extend->GetOutput(), "Valid");
    EXPECT_GT(valid.sum(), 10.0);
    EXPECT_LT(valid.sum(), 100.0);

    vtkDataObject* model = extend->GetOutputDataObject(1);
    const std::string path = write(model, "model" + std::to_string(scheme) + ".vtp");
    for (const auto& from : { copyOf(model), read(path) })
    {
      vtkNew<vtkRBFEvaluate> evaluate;
      evaluate->SetInputData(from);
      evaluate->SetMaximumDistance(300.0);
      computeAll(evaluate.Get(), mapTarget());
      expectSameResult(extend->GetOutput(), evaluate->GetOutput());
    }
  }
}

// Each kernel and every parameter comes back as it was.
TEST(RBFEvaluate, keepsAllParameters)
{
  for (int kernel = 0; kernel <= 8; ++kernel)
  {
    SCOPED_TRACE(kernel);
    vtkNew<vtkRBFExtend> extend;
    extend->SetInputData(waveSamples());
    extend->SetKernel(kernel);
    extend->SetKernelWidth(0.3);
    extend->SetNeighborCount(20);
    extend->SetRegularization(1e-3);
    computeAll(extend.Get(), makeCloud(randomCube(100, 2)));
    vtkNew<vtkRBFEvaluate> evaluate;
    evaluate->SetInputData(copyOf(extend->GetOutputDataObject(1)));
    computeAll(evaluate.Get(), makeCloud(randomCube(100, 2)));
    expectSameResult(extend->GetOutput(), evaluate->GetOutput());
  }
}

// A model has a vertex at each distinct sample and field data without NaN or infinity.
TEST(RBFEvaluate, modelIsPlainPolydata)
{
  vtkNew<vtkRBFExtend> extend;
  extend->SetInputData(mapSamples());
  extend->SetGridDimensions(2, 2, 2);
  expectSilentSuccess(update(extend));
  auto* model = vtkPolyData::SafeDownCast(extend->GetOutputDataObject(1));
  ASSERT_NE(model, nullptr);
  EXPECT_EQ(model->GetNumberOfPoints(), 380);
  EXPECT_EQ(model->GetNumberOfVerts(), 380);
  EXPECT_EQ(numbersOf(model, "Coefficient").cols(), 380);
  vtkFieldData* data = model->GetFieldData();
  EXPECT_EQ(data->GetArray("ModelVersion")->GetTuple1(0), 1.0);
  EXPECT_EQ(data->GetArray("Scheme")->GetTuple1(0), 3.0);
  EXPECT_EQ(data->GetArray("Kernel")->GetTuple1(0), 3.0);
  EXPECT_EQ(data->GetAbstractArray("ValueName")->GetVariantValue(0).ToString(), "f");
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    if (vtkDataArray* array = data->GetArray(i))
    {
      EXPECT_TRUE(std::isfinite(array->GetRange(0)[0]) && std::isfinite(array->GetRange(0)[1]))
        << array->GetName();
    }
  }
}

// The output is the target, of any type, with the arrays named after f or as asked for.
TEST(RBFEvaluate, followsTheTarget)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(3, 4, 5);
  image->SetSpacing(0.1, 0.1, 0.1);
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(makeCloud(randomCube(20, 2))->GetPoints());
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(1, image);
  vtkNew<vtkRBFEvaluate> filter;
  filter->SetInputData(makeModel());
  for (vtkDataObject* target : std::vector<vtkDataObject*>{ image, grid, blocks })
  {
    SCOPED_TRACE(target->GetClassName());
    filter->SetTargetData(target);
    expectSilentSuccess(update(filter));
    EXPECT_STREQ(filter->GetOutputDataObject(0)->GetClassName(), target->GetClassName());
  }
  auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  EXPECT_EQ(numbersOf(output->GetBlock(1), "f").cols(), 60);

  filter->SetTargetData(image);
  filter->SetResultArrayName("height");
  expectSilentSuccess(update(filter));
  EXPECT_STREQ(filter->GetOutput()->GetPointData()->GetScalars()->GetName(), "height");
}

// The range of the samples is part of the model.
TEST(RBFEvaluate, clampsToTheRange)
{
  const auto samples = waveSamples();
  vtkNew<vtkRBFEvaluate> filter;
  filter->SetInputData(makeModel());
  filter->SetTargetData(makeCloud(3.0 * randomCube(300, 7)));
  filter->ClampToRangeOn();
  expectSilentSuccess(update(filter));
  const Eigen::MatrixXd values = numbersOf(filter->GetOutput(), "f");
  EXPECT_EQ(values.maxCoeff(), numbersOf(samples, "f").maxCoeff());
  EXPECT_EQ(values.minCoeff(), numbersOf(samples, "f").minCoeff());
}

TEST(RBFEvaluate, refusesWhatIsNoModel)
{
  expectRefusal(vtkNew<vtkPolyData>(), { "needs a Model with the field data 'ModelVersion'" });
  expectRefusal(waveSamples(),
    { "needs a Model with the field data 'ModelVersion', found none of this name.", "RBF Extend" });
}

// Whichever part is missing, the error names it.
TEST(RBFEvaluate, namesThePartThatIsMissing)
{
  const auto complete = makeModel();
  ASSERT_EQ(complete->GetFieldData()->GetNumberOfArrays(), 13);
  for (int i = 0; i < complete->GetFieldData()->GetNumberOfArrays(); ++i)
  {
    const auto model = copyOf(complete);
    const std::string name = model->GetFieldData()->GetAbstractArray(i)->GetName();
    SCOPED_TRACE(name);
    model->GetFieldData()->RemoveArray(i);
    expectRefusal(model, { ("'" + name + "'").c_str(), "found none of this name." });
  }
  complete->GetPointData()->RemoveArray("Coefficient");
  expectRefusal(complete, { "the point array 'Coefficient'", "found none of this name." });
}

TEST(RBFEvaluate, refusesOtherVersions)
{
  expectRefusal(
    modelWith<vtkIntArray>("ModelVersion", 2), { "needs a Model of version 1, found version 2." });
  expectRefusal(modelWith<vtkDoubleArray>("ModelVersion", 1.5), { "whole number", "1.5" });
}

TEST(RBFEvaluate, refusesUnknownSchemesAndKernels)
{
  expectRefusal(modelWith<vtkIntArray>("Scheme", 0), { "Scheme 1 to 5, found 0." });
  expectRefusal(modelWith<vtkIntArray>("Scheme", 6), { "Scheme 1 to 5, found 6." });
  expectRefusal(modelWith<vtkIntArray>("Kernel", 9), { "Kernel 0 to 8, found 9." });
}

TEST(RBFEvaluate, refusesInconsistentCounts)
{
  const auto coefficients = makeModel();
  coefficients->GetPointData()->GetArray("Coefficient")->SetNumberOfTuples(499);
  expectRefusal(coefficients, { "one Coefficient at each center, found 499 for 500" });

  const auto centers = makeModel();
  centers->GetPoints()->SetNumberOfPoints(10);
  expectRefusal(centers, { "found 500 for 10 centers" });

  expectRefusal(modelWith<vtkDoubleArray>("Tail", 1.0), { "'Tail' of 4 numbers, found 1." });
}

TEST(RBFEvaluate, refusesNumbersThatAreNotFinite)
{
  for (const double number :
    { std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() })
  {
    expectRefusal(modelWith<vtkDoubleArray>("KernelWidth", number),
      { "'KernelWidth' of finite numbers, found NaN or infinity." });
    expectRefusal(modelWith<vtkDoubleArray>("Scheme", number), { "'Scheme'", "NaN or infinity." });
    const auto center = makeModel();
    center->GetPoints()->SetPoint(3, 0.0, number, 0.0);
    expectRefusal(center, { "a model of finite numbers, found NaN or infinity." });
    const auto coefficient = makeModel();
    coefficient->GetPointData()->GetArray("Coefficient")->SetTuple1(3, number);
    expectRefusal(coefficient, { "a model of finite numbers, found NaN or infinity." });
  }
}

// Of a file that ends too early nothing is evaluated.
TEST(RBFEvaluate, refusesTruncatedFiles)
{
  const std::string path = write(makeModel(), "whole.vtp");
  std::stringstream text;
  text << std::ifstream(path).rdbuf();
  for (const double part : { 0.3, 0.6, 0.9 })
  {
    SCOPED_TRACE(part);
    const std::string cut = std::string(SURFACE_SCALARS_OUTPUT) + "/truncated.vtp";
    const auto length = static_cast<std::size_t>(part * static_cast<double>(text.str().size()));
    std::ofstream(cut) << text.str().substr(0, length);
    vtkNew<vtkCallbackCommand> ignore;
    ignore->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetParserErrorObserver(ignore);
    reader->SetReaderErrorObserver(ignore);
    reader->SetFileName(cut.c_str());
    update(reader);
    expectRefusal(reader->GetOutput(), { "needs a Model" });
  }
}

TEST(RBFEvaluate, anEmptyTarget)
{
  vtkNew<vtkRBFEvaluate> filter;
  filter->SetInputData(makeModel());
  filter->SetTargetData(vtkNew<vtkPolyData>());
  expectWarning(update(filter), { "RBF Evaluate: The target has no points" });
  EXPECT_TRUE(filter->GetPolyDataOutput()->GetPointData()->HasArray("f"));
}

TEST(RBFEvaluate, asksForATarget)
{
  vtkNew<vtkRBFEvaluate> filter;
  filter->SetInputData(makeModel());
  expectFailure(filter, update(filter), "RBF Evaluate", { "needs a Target", "none" });
}
