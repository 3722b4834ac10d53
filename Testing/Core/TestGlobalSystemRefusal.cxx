// What a system of radial functions is refused for, and in which words.

#include "Error.h"
#include "GlobalSystemTest.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace SurfaceScalars
{
namespace
{

using testing::HasSubstr;

std::string refusalOf(const PointCloud& cloud, const FieldParameters& parameters)
{
  const Values values = Truth::valuesOf(Truth::wave, cloud.points());
  try
  {
    GlobalSystem({ cloud, values }, parameters, {}).solve(values, {});
  }
  catch (const InvalidInput& refusal)
  {
    return refusal.what();
  }
  return "nothing";
}

// Too many points for a kernel without end: the sentence says how many may be, how many are, and
// what to do. Too wide a support likewise.
TEST(GlobalSystemRefusal, refusesTooManyPoints)
{
  const PointCloud cloud(Truth::randomBox(6001, 12));
  EXPECT_THAT(refusalOf(cloud, parametersOf(KernelType::Cubic, 0.0)),
    AllOf(HasSubstr("6000"), HasSubstr("6001"), HasSubstr("Cubic"), HasSubstr("Wendland")));
  const PointCloud many(Truth::randomBox(20000, 13));
  EXPECT_THAT(refusalOf(many, parametersOf(KernelType::Wendland, 50.0)),
    AllOf(HasSubstr("10000"), HasSubstr("20000"), HasSubstr("KernelWidth")));
}

// A width that makes the system singular: the sentence names kernel, width, condition and remedy.
TEST(GlobalSystemRefusal, refusesSingularWidths)
{
  const PointCloud cloud(Truth::randomBox(200, 14));
  EXPECT_THAT(refusalOf(cloud, parametersOf(KernelType::Gaussian, 17.0)),
    AllOf(HasSubstr("Gaussian"), HasSubstr("17"), HasSubstr("condition"),
      HasSubstr("Lower KernelWidth"), HasSubstr("Regularization")));
  EXPECT_EQ(refusalOf(cloud, parametersOf(KernelType::Gaussian, 17.0, 1e-6)), "nothing");
}

// A kernel without a width is not tried with others: a singular system is factored once, and the
// sentence speaks of the samples, not of a width that nobody set.
TEST(GlobalSystemRefusal, refusesSingularSamplesAtOnce)
{
  Points points = Truth::randomBox(200, 19);
  points.col(1) = points.col(0) + Vector3d(1e-9, 0.0, 0.0);
  const PointCloud pair(points);
  const Values values = Truth::valuesOf(Truth::wave, pair.points());
  const auto callsUntilRefused = [&](double width)
  {
    int calls = 0;
    const Execution execution{ 1, [&](double) { return ++calls > 0; } };
    EXPECT_THROW(GlobalSystem({ pair, values }, parametersOf(KernelType::Cubic, width), execution),
      InvalidInput);
    return calls;
  };
  EXPECT_EQ(callsUntilRefused(0.0), callsUntilRefused(1.0));

  points.col(1) = Vector3d(1e6, 0.0, 0.0);
  for (const Points& samples : { points, pair.points() })
  {
    EXPECT_THAT(refusalOf(PointCloud(samples), parametersOf(KernelType::Cubic, 0.0)),
      AllOf(HasSubstr("Cubic kernel (condition"), HasSubstr("far from the others"),
        HasSubstr("nearly coincide"), Not(HasSubstr("idth"))));
  }
}

// Where no width makes the system well conditioned, the cause is named: a pair that nearly
// coincides. With the remedy that is named there is a width.
TEST(GlobalSystemRefusal, refusesPairsForEveryWidth)
{
  Points points = Truth::randomBox(200, 20);
  points.col(1) = points.col(0) + Vector3d(1e-9, 0.0, 0.0);
  const PointCloud cloud(points);
  for (const KernelType kernel : { KernelType::Gaussian, KernelType::Wu })
  {
    EXPECT_THAT(refusalOf(cloud, parametersOf(kernel, 0.0)),
      AllOf(HasSubstr(nameOf(kernel)), HasSubstr("1e-09 apart"), HasSubstr("is typical"),
        HasSubstr("Regularization to 1e-10"), HasSubstr("nearly coincide")));
    EXPECT_EQ(refusalOf(cloud, parametersOf(kernel, 0.0, 1e-10)), "nothing");
  }
}

// What a sparse system is refused with has a condition too, and what to change.
TEST(GlobalSystemRefusal, refusesSingularSparseSystems)
{
  Points points = Truth::randomBox(1500, 24);
  for (const auto& [distance, condition] :
    { std::pair(1e-8, "condition about"), std::pair(1e-10, "condition infinite") })
  {
    for (Eigen::Index i = 0; i < 20; i += 2)
    {
      points.col(i + 1) = points.col(i) + Vector3d(distance, 0.0, 0.0);
    }
    const PointCloud cloud(points);
    EXPECT_THAT(refusalOf(cloud, parametersOf(KernelType::Wu, supportOf(cloud, 30))),
      AllOf(HasSubstr("Wu"), HasSubstr(condition), HasSubstr("Lower KernelWidth"),
        HasSubstr("Regularization"), HasSubstr("nearly coincide"), Not(HasSubstr("Cubic"))));
  }
}

} // namespace
} // namespace SurfaceScalars
