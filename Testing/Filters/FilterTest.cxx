#include "FilterTest.h"

#include "vtkPointSetContour.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkPoints.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace SurfaceScalars::FilterTest
{
namespace
{

/// Appends the text of an ErrorEvent or WarningEvent to a list.
vtkSmartPointer<vtkCallbackCommand> appendTo(std::vector<std::string>& texts)
{
  const auto command = vtkSmartPointer<vtkCallbackCommand>::New();
  command->SetClientData(&texts);
  command->SetCallback(
    [](vtkObject*, unsigned long, void* list, void* text) {
      static_cast<std::vector<std::string>*>(list)->emplace_back(static_cast<const char*>(text));
    });
  return command;
}

/// Observes an object's messages as long as it lives.
class Listener
{
public:
  Listener(vtkObject* object, unsigned long event, std::vector<std::string>& texts)
    : object_(object)
    , tag_(object->AddObserver(event, appendTo(texts)))
  {
  }
  ~Listener() { this->object_->RemoveObserver(this->tag_); }
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

private:
  vtkObject* object_;
  unsigned long tag_;
};

void expectParts(const std::string& text, std::initializer_list<const char*> parts)
{
  for (const char* part : parts)
  {
    EXPECT_THAT(text, ::testing::HasSubstr(part));
  }
}

} // namespace

vtkSmartPointer<vtkPolyData> makeCloud(const PointsRef& points)
{
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  places->SetNumberOfPoints(points.cols());
  for (Eigen::Index i = 0; i < points.cols(); ++i)
  {
    places->SetPoint(i, points.col(i).data());
  }
  const auto cloud = vtkSmartPointer<vtkPolyData>::New();
  cloud->SetPoints(places);
  return cloud;
}

vtkSmartPointer<vtkPolyData> makeCloud(
  const PointsRef& points, const Values& values, const char* name)
{
  const auto cloud = makeCloud(points);
  addArray<vtkDoubleArray>(cloud, name, values);
  cloud->GetPointData()->SetActiveScalars(name);
  return cloud;
}

vtkSmartPointer<vtkPolyData> makeCloud(
  const PointsRef& points, const std::function<double(const Vector3d&)>& function)
{
  Values values(points.cols());
  for (Eigen::Index i = 0; i < points.cols(); ++i)
  {
    values[i] = function(points.col(i));
  }
  return makeCloud(points, values);
}

Outcome update(vtkAlgorithm* filter)
{
  Outcome outcome;
  const Listener errors(filter, vtkCommand::ErrorEvent, outcome.errors);
  const Listener warnings(filter, vtkCommand::WarningEvent, outcome.warnings);
  const Listener failures(filter->GetExecutive(), vtkCommand::ErrorEvent, outcome.pipeline);
  outcome.succeeded = filter->GetExecutive()->Update() != 0;
  return outcome;
}

void expectSilentSuccess(const Outcome& outcome)
{
  EXPECT_TRUE(outcome.succeeded);
  EXPECT_THAT(outcome.errors, ::testing::IsEmpty());
  EXPECT_THAT(outcome.warnings, ::testing::IsEmpty());
}

void expectWarning(const Outcome& outcome, std::initializer_list<const char*> parts)
{
  EXPECT_TRUE(outcome.succeeded);
  EXPECT_THAT(outcome.errors, ::testing::IsEmpty());
  ASSERT_THAT(outcome.warnings, ::testing::SizeIs(1));
  expectParts(outcome.warnings.front(), parts);
}

void expectFailure(vtkAlgorithm* filter, const Outcome& outcome, const std::string& speaker,
  std::initializer_list<const char*> parts)
{
  EXPECT_FALSE(outcome.succeeded);
  EXPECT_THAT(outcome.warnings, ::testing::IsEmpty());
  expectEmptyOutputs(filter);
  ASSERT_THAT(outcome.errors, ::testing::SizeIs(1));
  EXPECT_THAT(outcome.errors.front(), ::testing::HasSubstr("): " + speaker + ": "));
  expectParts(outcome.errors.front(), parts);
}

void expectNothingWhenStopped(vtkAlgorithm* filter, double fraction)
{
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&fraction);
  observer->SetCallback(
    [](vtkObject* running, unsigned long, void* limit, void* progress)
    {
      if (*static_cast<double*>(progress) >= *static_cast<double*>(limit))
      {
        vtkAlgorithm::SafeDownCast(running)->SetAbortExecute(1);
      }
    });
  const unsigned long tag = filter->AddObserver(vtkCommand::ProgressEvent, observer);
  const Outcome stopped = update(filter);
  EXPECT_TRUE(stopped.succeeded);
  EXPECT_THAT(stopped.errors, ::testing::IsEmpty());
  EXPECT_THAT(stopped.warnings, ::testing::IsEmpty());
  expectEmptyOutputs(filter);

  filter->RemoveObserver(tag);
  filter->SetAbortExecute(0);
  filter->Modified();
}

void expectEmptyOutputs(vtkAlgorithm* filter)
{
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    vtkDataObject* output = filter->GetOutputDataObject(port);
    ASSERT_NE(output, nullptr);
    for (const int kind : { vtkDataObject::POINT, vtkDataObject::CELL })
    {
      EXPECT_EQ(output->GetNumberOfElements(kind), 0);
      if (vtkFieldData* data = output->GetAttributesAsFieldData(kind)) // a composite has none
      {
        EXPECT_EQ(data->GetNumberOfArrays(), 0);
      }
    }
    EXPECT_EQ(output->GetFieldData()->GetNumberOfArrays(), 0);
  }
}

std::vector<Curve> curvesOf(vtkPointSetContour* filter)
{
  std::vector<Curve> curves;
  vtkPolyData* output = filter->GetOutput();
  vtkCellData* data = output->GetCellData();
  for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
  {
    Curve curve;
    curve.isoValue = data->GetArray("IsoValue")->GetTuple1(cell);
    curve.component = static_cast<int>(data->GetArray("ComponentId")->GetTuple1(cell));
    curve.closed = data->GetArray("Closed")->GetTuple1(cell) != 0.0;
    curve.length = data->GetArray("Length")->GetTuple1(cell);
    vtkPoints* points = output->GetCell(cell)->GetPoints();
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    {
      curve.points.emplace_back(points->GetPoint(i));
    }
    curves.push_back(curve);
  }
  return curves;
}

} // namespace SurfaceScalars::FilterTest
