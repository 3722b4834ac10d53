// What vtkScalarFunctionDesign refuses, and how it says so.

#include "DesignTest.h"

#include "vtkAppendPolyData.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkStringArray.h"

#include <gtest/gtest.h>

#include <limits>

using namespace SurfaceScalars;
using namespace SurfaceScalars::FilterTest;

namespace
{

using Filter = vtkScalarFunctionDesign;

void expectRefusal(Filter* filter, std::initializer_list<const char*> parts)
{
  expectFailure(filter, update(filter), "Scalar Function Design", parts);
}

void expectRefusal(const std::vector<Asked>& asked, std::initializer_list<const char*> parts)
{
  expectRefusal(design(plainTorus(), asked), parts);
}

/// The natural requests and one more.
std::vector<Asked> with(const Asked& asked)
{
  std::vector<Asked> all = naturalRequests();
  all.push_back(asked);
  return all;
}

} // namespace

// Nothing to do: no points, none with a type that asks for something, no template.
TEST(ScalarFunctionDesignInput, refusesNothing)
{
  const std::initializer_list<const char*> parts = {
    "needs CriticalPoints with a minimum, saddle or maximum (CriticalType 0, 1 or 3), or a "
    "TemplateArray, found neither"
  };
  expectRefusal(design(plainTorus(), nullptr), parts);
  expectRefusal(design(plainTorus(), vtkSmartPointer<vtkPolyData>::New()), parts);
  expectRefusal(design(plainTorus(), vtkSmartPointer<vtkMultiBlockDataSet>::New()), parts);
  expectRefusal({ { torusPlace(0, 0), 5 }, { torusPlace(3, 3), -1 } }, parts);
}

TEST(ScalarFunctionDesignInput, refusesPointsWithoutAType)
{
  const auto points = criticalPoints(naturalRequests());
  points->GetPointData()->RemoveArray("CriticalType");
  expectRefusal(
    design(plainTorus(), points), { "needs a point array 'CriticalType' of CriticalPoints" });
  vtkNew<vtkStringArray> names;
  names->SetName("CriticalType");
  names->SetNumberOfValues(4);
  points->GetPointData()->AddArray(names);
  expectRefusal(design(plainTorus(), points),
    { "one number per point in the array 'CriticalType' of CriticalPoints", "no numbers" });
}

// A block without the array that others have is missing it.
TEST(ScalarFunctionDesignInput, refusesBlocksWithoutAType)
{
  const auto bare = criticalPoints({ { torusPlace(5, 5), 0 } });
  bare->GetPointData()->Initialize();
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, criticalPoints(naturalRequests()));
  blocks->SetBlock(1, bare);
  expectRefusal(design(plainTorus(), blocks), { "as CriticalType", "nan at point 4" });
}

TEST(ScalarFunctionDesignInput, refusesUnknownTypes)
{
  for (const auto& [type, text] : { std::pair(2.0, "found 2 at point 4 of CriticalPoints"),
         std::pair(17.0, "found 17 at point 4"), std::pair(0.5, "found 0.5 at point 4"),
         std::pair(-2.0, "found -2 at point 4"), std::pair(NaN, "found nan at point 4") })
  {
    expectRefusal(with({ torusPlace(5, 5), type }),
      { "needs 0 (minimum), 1 (saddle) or 3 (maximum) as CriticalType", text });
  }
}

TEST(ScalarFunctionDesignInput, refusesMultiplicitiesThatAreNone)
{
  for (const double multiplicity : { 0.0, -1.0, 1.5, NaN, 1e300 })
  {
    expectRefusal(with({ torusPlace(5, 5), 1, multiplicity }),
      { "needs a whole number from 1 on as Multiplicity of a saddle", "at point 4" });
    const auto maximum = design(plainTorus(), with({ torusPlace(5, 5), 3, multiplicity }));
    EXPECT_TRUE(update(maximum).succeeded);
  }
}

// Quarters of the triangles give a vertex four times the neighbors it has.
TEST(ScalarFunctionDesignInput, refusesMultiplicitiesBeyondARefinedStar)
{
  expectRefusal(with({ torusPlace(5, 5), 1, 12.0 }),
    { "needs saddles of multiplicity at most 11 at vertex 245, which has 6 neighbors and 24 after "
      "its triangles are split in 4, found one that needs 26" });
  EXPECT_TRUE(update(design(plainTorus(), with({ torusPlace(5, 5), 1, 11.0 }))).succeeded);
}

TEST(ScalarFunctionDesignInput, refusesPlacesThatAreNone)
{
  const double infinite = std::numeric_limits<double>::infinity();
  for (const double number : { NaN, infinite })
  {
    expectRefusal(with({ Vector3d(0, number, 0), 3 }), { "finite coordinates", "of point 4" });
  }
  expectRefusal(with({ torusPlace(5, 5), 3, 1.0, infinite }),
    { "finite numbers as ScalarValue", "inf at point 4" });
}

TEST(ScalarFunctionDesignInput, refusesPointsFarFromTheSurface)
{
  expectRefusal(with({ Vector3d(2.0, 0.0, 0.0), 3 }),
    { "needs critical points at most 0.",
      " from a vertex, found point 4 of CriticalPoints at a "
      "distance of 0.6" });
  const auto filter =
    design(plainTorus(), { { Vector3d(-2.0, 0.0, 0.0), 3 }, naturalRequests()[0] });
  filter->SetMaximumDistance(0.61);
  EXPECT_TRUE(update(filter).succeeded);
  filter->SetMaximumDistance(-1.0);
  expectRefusal(filter, { "maximum distance of at least 0, found -1" });
}

// The same point twice, or three maxima for two vertices: some vertex would have to be two.
TEST(ScalarFunctionDesignInput, refusesTwoPointsAtOneVertex)
{
  expectRefusal(with({ torusPlace(0, 0), 3 }),
    { "needs critical points at different vertices, found point 0 of CriticalPoints and point 4 of "
      "CriticalPoints both next to vertex 0" });
  const Vector3d step = torusPlace(6, 5) - torusPlace(5, 5);
  expectRefusal({ { torusPlace(5, 5), 3 }, { torusPlace(5, 5) + 0.4 * step, 3 },
                  { torusPlace(6, 5), 3 }, { torusPlace(24, 0), 0 } },
    { "point 0 of CriticalPoints and point 1 of CriticalPoints both next to vertex 245" });
}

// Two maxima cannot be neighbors, for one is not below the other; nor a minimum above a maximum
// next to it. Both are named.
TEST(ScalarFunctionDesignInput, refusesContradictions)
{
  expectRefusal({ { torusPlace(5, 5), 3 }, { torusPlace(6, 5), 3 }, { torusPlace(24, 0), 0 } },
    { "point 0 of CriticalPoints", "point 1 of CriticalPoints" });
  expectRefusal({ { torusPlace(5, 5), 3, 1.0, 0.0 }, { torusPlace(6, 5), 0, 1.0, 1.0 } },
    { "point 0 of CriticalPoints", "point 1 of CriticalPoints" });
}

// Without a critical point nothing says what a component is to have.
TEST(ScalarFunctionDesignInput, refusesComponentsWithoutAPoint)
{
  const auto other = plainTorus();
  for (vtkIdType point = 0; point < other->GetNumberOfPoints(); ++point)
  {
    const Vector3d place(other->GetPoint(point));
    other->GetPoints()->SetPoint(point, place.x() + 5.0, place.y(), place.z());
  }
  vtkNew<vtkAppendPolyData> both;
  both->AddInputData(plainTorus());
  both->AddInputData(other);
  both->Update();
  expectRefusal(design(both->GetOutput(), naturalRequests()), { "2", "component", "1152" });
}

TEST(ScalarFunctionDesignInput, refusesTemplatesThatAreNone)
{
  const auto mesh = torusMesh(torusHeight());
  const auto filter = design(mesh, nullptr);
  filter->SetTemplateArray("nope");
  expectRefusal(filter, { "the point array 'nope'", "none of this name", "'f'" });
  mesh->GetPointData()->GetArray("f")->SetComponent(7, 0, NaN);
  filter->SetTemplateArray("f");
  expectRefusal(filter, { "finite", "7" });
}

TEST(ScalarFunctionDesignInput, refusesMeshesWithoutTriangles)
{
  expectRefusal(
    design(makeCloud(TorusGrid::points()), naturalRequests()), { "no triangle among 0 cells" });
}

// Every number that names something is checked, and so are fractions and lengths.
TEST(ScalarFunctionDesignInput, refusesNumbersThatNameNothing)
{
  const auto refuses =
    [](void (Filter::*set)(int), int value, std::initializer_list<const char*> parts)
  {
    const auto filter = design(plainTorus(), naturalRequests());
    (filter->*set)(value);
    expectRefusal(filter, parts);
  };
  refuses(&Filter::SetApproach, 2, { "Approach 0 (MeshBased)", "found 2" });
  refuses(&Filter::SetConstraintType, 2, { "ConstraintType 0 (Interpolating)", "found 2" });
  refuses(&Filter::SetEnergy, -1, { "Energy 0 (Harmonic)", "found -1" });
  refuses(&Filter::SetMetric, 3, { "Metric 0 (Identity)", "found 3" });
  refuses(&Filter::SetEpsilonChoice, 0, { "EpsilonChoice 1 (LCurve)", "found 0" });
  refuses(&Filter::SetKernel, 10, { "Kernel 0 (Gaussian)", "found 10" });
}

TEST(ScalarFunctionDesignInput, refusesNumbersOutOfRange)
{
  const auto filter = design(plainTorus(), naturalRequests());
  filter->SetPersistenceThreshold(1.5);
  expectRefusal(filter, { "PersistenceThreshold", "1.5" });
  filter->SetPersistenceThreshold(0.0);
  filter->SetEpsilon(0.0);
  filter->SetConstraintType(Filter::LEAST_SQUARES);
  filter->SetEpsilonChoice(Filter::MANUAL);
  expectRefusal(filter, { "Epsilon above 0" });
  filter->SetEpsilon(1e5);
  filter->SetApproach(Filter::MESHLESS);
  filter->SetKernelWidth(-1.0);
  expectRefusal(filter, { "KernelWidth", "-1" });
}
