// vtkRBFExtend: what the samples say about kernel and width.

#include "FieldTest.h"

#include "vtkDataObject.h"

using namespace SurfaceScalars;
using namespace SurfaceScalars::FilterTest;

namespace
{

/// The prediction at a place from all columns of points but one.
double predictionWithout(const Points& points, Eigen::Index leftOut, int kernel)
{
  const Eigen::Index last = points.cols() - 1;
  Points others = points;
  others.col(leftOut) = points.col(last);
  const vtkNew<vtkRBFExtend> filter;
  filter->SetInputData(makeCloud(Points(others.leftCols(last)), wave));
  filter->SetTargetData(makeCloud(Points(points.col(leftOut))));
  filter->SetScheme(vtkRBFExtend::GLOBAL_RBF);
  filter->SetKernel(kernel);
  expectSilentSuccess(update(filter));
  return numbersOf(filter->GetOutputDataObject(0), "f")(0, 0);
}

} // namespace

// The closed form equals f less the prediction of a filter that never saw the sample.
TEST(LeaveOneOut, equalsPredictionsWithoutTheSample)
{
  const Points points = randomCube(40, 7);
  for (const int kernel : { vtkRBFExtend::CUBIC, vtkRBFExtend::LINEAR, vtkRBFExtend::THIN_PLATE })
  {
    const vtkNew<vtkRBFExtend> filter;
    filter->SetInputData(makeCloud(points, wave));
    filter->SetTargetData(makeCloud(points));
    filter->SetScheme(vtkRBFExtend::GLOBAL_RBF);
    filter->SetKernel(kernel);
    filter->ComputeLeaveOneOutErrorsOn();
    expectSilentSuccess(update(filter));
    auto* model = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(1));
    const Eigen::MatrixXd errors = numbersOf(model, "LeaveOneOutError");
    ASSERT_EQ(errors.cols(), points.cols());
    for (vtkIdType center = 0; center < model->GetNumberOfPoints(); ++center)
    {
      const Vector3d place(model->GetPoint(center));
      Eigen::Index sample = 0;
      (points.colwise() - place).colwise().squaredNorm().minCoeff(&sample);
      EXPECT_NEAR(errors(0, center), wave(place) - predictionWithout(points, sample, kernel), 1e-9);
    }
  }
}

// A local scheme has none, and a sparse system is refused in a sentence.
TEST(LeaveOneOut, needsADenseGlobalSystem)
{
  const vtkNew<vtkRBFExtend> filter;
  filter->SetInputData(waveSamples(2000));
  filter->SetTargetData(makeCloud(randomCube(3, 1)));
  filter->ComputeLeaveOneOutErrorsOn();
  expectSilentSuccess(update(filter));
  EXPECT_EQ(numbersOf(filter->GetOutputDataObject(1), "LeaveOneOutError").size(), 0);

  filter->SetScheme(vtkRBFExtend::GLOBAL_RBF);
  filter->SetKernel(vtkRBFExtend::WENDLAND);
  filter->SetKernelWidth(0.2);
  expectFailure(filter, update(filter), "RBF Extend", { "Wendland", "dense" });
}
