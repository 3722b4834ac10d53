#include "vtkOsculatingParaboloid.h"

#include "Error.h"
#include "Field.h"
#include "FilterRun.h"
#include "OutputArrays.h"
#include "PointSetInput.h"
#include "PropertyChoice.h"

#include "vtkClipPolyData.h"
#include "vtkDoubleArray.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkReverseSense.h"
#include "vtkSphere.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

vtkStandardNewMacro(vtkOsculatingParaboloid);

using namespace SurfaceScalars;

namespace
{

// The shares of the whole that reading, fitting and sampling take.
constexpr double ReadShare = 0.05;
constexpr double FitShare = 0.4;
constexpr double SampleShare = 0.95;

constexpr std::size_t Grain = 256; // places per block of a parallel loop
constexpr const char* NormalsName = "Normals";

void checkGrid(vtkOsculatingParaboloid& filter)
{
  checkGridDimensions(filter.GetGridDimensions(), 2, "48 48 48 is smooth to the eye.");
  if (!(filter.GetRadius() >= 0.0) || !std::isfinite(filter.GetRadius()))
  {
    throw InvalidInput(
      "a Radius of 0 (automatic) or more", std::to_string(filter.GetRadius()), "It is a length.");
  }
}

/// The position of a point of the input, counted through its blocks.
Vector3d positionOf(vtkIdType id, vtkDataObject* input)
{
  vtkIdType first = 0;
  for (vtkPointSet* block : pointSetsOf(input))
  {
    const vtkIdType count = block->GetNumberOfPoints();
    if (id >= first && id < first + count)
    {
      return Vector3d(block->GetPoint(id - first));
    }
    first += count;
  }
  throw InvalidInput("a PointId from 0 to " + std::to_string(first - 1), std::to_string(id),
    "Choose a point of the input.");
}

/// F around one of the samples: the field with the neighborhood of that sample everywhere.
class FrozenField
{
public:
  FrozenField(const Field& field, const Vector3d& center)
    : approximation_(field.approximation())
    , center_(center)
  {
    if (!this->approximation_->center(center))
    {
      throw InvalidInput("a neighborhood that determines the function",
        "too few samples around the point", "Raise NeighborCount or SearchRadius.");
    }
  }

  FieldJet at(const Vector3d& offset, Derivatives derivatives) const
  {
    return this->approximation_->jet(this->center_ + offset, derivatives);
  }

private:
  std::unique_ptr<FieldApproximation> approximation_;
  Vector3d center_;
};

/// A sample, relative to the origin of the cloud. @throws InvalidInput if the cloud has no point
/// at this position, which may differ by rounding
Vector3d sampleAt(const Vector3d& position, vtkIdType id, const PointCloud& cloud)
{
  Neighborhood near;
  if (position.allFinite())
  {
    cloud.nearest(position - cloud.origin(), 1, near);
    const double rounding = 1e-12 * position.cwiseAbs().maxCoeff();
    if (near.squaredDistances.front() <= rounding * rounding)
    {
      return cloud.points().col(near.indices.front());
    }
  }
  throw InvalidInput("a PointId of a point with a finite position and value",
    "point " + std::to_string(id) + ", which has none", "Choose another point.");
}

/// The distance to the farthest sample of a neighborhood.
double neighborhoodRadius(const Field& field, const Vector3d& center)
{
  constexpr int defaultCount = 32; // where the scheme has no number of its own
  const FieldParameters& parameters = field.model().parameters;
  Neighborhood near;
  if (parameters.searchRadius > 0.0)
  {
    field.cloud().within(center, parameters.searchRadius, near);
  }
  else
  {
    field.cloud().nearest(
      center, parameters.neighborCount > 0 ? parameters.neighborCount : defaultCount, near);
  }
  const double radius = std::sqrt(near.squaredDistances.back());
  if (!(radius > 0.0))
  {
    throw InvalidInput("at least 2 different points", "1", "Set Radius or choose a larger input.");
  }
  return radius;
}

/// F - F(p) at the corners of voxels, in coordinates about p.
vtkSmartPointer<vtkImageData> sample(const Field& field, const Vector3d& center, double radius,
  const int* size, const Execution& execution)
{
  auto grid = vtkSmartPointer<vtkImageData>::New();
  const Eigen::Array3d spacing =
    2.0 * radius / (Eigen::Map<const Eigen::Array3i>(size).cast<double>() - 1.0);
  grid->SetDimensions(size);
  grid->SetOrigin(-radius, -radius, -radius);
  grid->SetSpacing(spacing.data());
  const auto values = makeDoubles("F", grid->GetNumberOfPoints());
  parallelFor(static_cast<std::size_t>(values->GetNumberOfValues()), Grain, execution,
    [&](std::size_t begin, std::size_t end)
    {
      const FrozenField frozen(field, center);
      const double isoValue = frozen.at(Vector3d::Zero(), Derivatives::None).value;
      for (auto id = static_cast<vtkIdType>(begin); id < static_cast<vtkIdType>(end); ++id)
      {
        const vtkIdType row = id / size[0];
        const vtkIdType layer = row / size[1];
        const Eigen::Array3d place(static_cast<double>(id % size[0]),
          static_cast<double>(row % size[1]), static_cast<double>(layer));
        const Vector3d offset = spacing * place - radius;
        values->SetValue(id, frozen.at(offset, Derivatives::None).value - isoValue);
      }
    });
  grid->GetPointData()->SetScalars(values);
  return grid;
}

/// Whether the values are more than rounding errors of a constant function.
bool changes(vtkImageData* grid, const FieldModel& model)
{
  const double* range = grid->GetScalarRange();
  const double rounding = 1e-12 * std::max(std::abs(model.lowest), std::abs(model.highest));
  return std::max(-range[0], range[1]) > rounding;
}

/// The zero of the values inside the ball, its sides seen from where the values are larger.
vtkSmartPointer<vtkPolyData> zeroSurface(vtkImageData* grid, double radius)
{
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(grid);
  contour->SetValue(0, 0.0);
  contour->ComputeNormalsOff();
  contour->ComputeScalarsOff();
  vtkNew<vtkReverseSense> outwards; // the contour faces the smaller values
  outwards->SetInputConnection(contour->GetOutputPort());
  vtkNew<vtkSphere> ball;
  ball->SetRadius(radius);
  vtkNew<vtkClipPolyData> clip;
  clip->SetInputConnection(outwards->GetOutputPort());
  clip->SetClipFunction(ball);
  clip->InsideOutOn();
  clip->Update();
  return clip->GetOutput();
}

/// Unit gradients of F at the points of the surface.
vtkSmartPointer<vtkDoubleArray> normalsOf(
  vtkPolyData* surface, const Field& field, const Vector3d& center, const Execution& execution)
{
  auto normals = makeDoubles(NormalsName, surface->GetNumberOfPoints(), 3);
  parallelFor(static_cast<std::size_t>(surface->GetNumberOfPoints()), Grain, execution,
    [&](std::size_t begin, std::size_t end)
    {
      const FrozenField frozen(field, center);
      for (auto id = static_cast<vtkIdType>(begin); id < static_cast<vtkIdType>(end); ++id)
      {
        Vector3d offset;
        surface->GetPoint(id, offset.data());
        const Vector3d normal =
          frozen.at(offset, Derivatives::Gradient).gradient.stableNormalized();
        normals->SetTypedTuple(id, normal.data());
      }
    });
  return normals;
}

/// The surface, moved to its place.
void write(vtkPolyData* surface, const Vector3d& position, vtkPolyData* output)
{
  const vtkIdType count = surface->GetNumberOfPoints();
  const auto positions = makeDoubles("Points", count, 3);
  for (vtkIdType id = 0; id < count; ++id)
  {
    const Vector3d place = position + Vector3d(surface->GetPoint(id));
    positions->SetTypedTuple(id, place.data());
  }
  vtkNew<vtkPoints> points;
  points->SetData(positions);
  output->SetPoints(points);
  output->SetPolys(surface->GetPolys());
}

} // namespace

vtkOsculatingParaboloid::vtkOsculatingParaboloid() = default;

vtkOsculatingParaboloid::~vtkOsculatingParaboloid() = default;

int vtkOsculatingParaboloid::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return runFilter(*this, "Osculating Paraboloid", outputs,
    [&](FilterRun& run)
    {
      checkGrid(*this);
      const Execution& execution = run.execution();
      vtkDataObject* input = vtkDataObject::GetData(inputs[0]);
      const Vector3d position = positionOf(this->PointId, input);
      Samples samples = readSamples(run, execution.part(0.0, ReadShare), input);
      const std::string valueName = freeName(run, samples.valueName, { NormalsName });
      const Field& field =
        this->FieldOf(std::move(samples), run, execution.part(ReadShare, FitShare));

      const Vector3d center = sampleAt(position, this->PointId, field.cloud());
      const double radius = this->Radius > 0.0 ? this->Radius : neighborhoodRadius(field, center);
      const double isoValue =
        FrozenField(field, center).at(Vector3d::Zero(), Derivatives::None).value;
      const auto grid =
        sample(field, center, radius, this->GridDimensions, execution.part(FitShare, SampleShare));
      auto surface = vtkSmartPointer<vtkPolyData>::New();
      if (changes(grid, field.model()))
      {
        surface = zeroSurface(grid, radius);
        if (surface->GetNumberOfPolys() == 0)
        {
          run.warn("There is no surface within Radius: raise GridDimensions or change Radius.");
        }
      }
      else
      {
        run.warn("The function is constant around point " + std::to_string(this->PointId) +
          ": there is no surface.");
      }
      const auto normals = normalsOf(surface, field, center, execution.part(SampleShare, 1.0));
      const auto values = makeDoubles(valueName, surface->GetNumberOfPoints());
      values->Fill(isoValue);

      vtkPolyData* output = vtkPolyData::GetData(outputs);
      write(surface, position, output);
      output->GetPointData()->SetScalars(values);
      output->GetPointData()->SetNormals(normals);
    });
}

void vtkOsculatingParaboloid::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PointId: " << this->PointId << "\n";
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "GridDimensions: " << this->GridDimensions[0] << " " << this->GridDimensions[1]
     << " " << this->GridDimensions[2] << "\n";
}
