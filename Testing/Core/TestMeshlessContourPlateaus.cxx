#include "ModelExamples.h"
#include "Polyline.h"
#include "UniformContour.h"

#include <gtest/gtest.h>

#include <cmath>

namespace SurfaceScalars
{
namespace
{

using namespace Truth;

constexpr double Width = 0.4;

Field oneTerm(double height, KernelType kernel, double tail = 0.0)
{
  FieldModel model = termsInThePlane(1, Width, Values::Constant(1, height), kernel);
  model.centers.col(0) << 0.03, -0.02, 0.0;
  model.tail[0] = tail;
  return Field(model);
}

// A plateau at the level belongs to the upper side: it has a border, the circle at which the kernel
// ends, with smaller values and none with larger ones; at levels other than 0, too, and where the
// polynomial is the level but for rounding.
TEST(MeshlessContourPlateaus, endWhereSmallerValuesBegin)
{
  const Mesh mesh = centeredSquare(9, 1.9, 0.2);
  for (const KernelType kernel : { KernelType::Wendland, KernelType::Wu })
  {
    for (const double level : { 0.0, 1.0 })
    {
      EXPECT_TRUE(contoursOf(oneTerm(0.7, kernel, level), mesh, { level }).sets.curves.empty());
      for (const double rounding : { -1e-15, 0.0, 1e-15 })
      {
        const Field field = oneTerm(-0.7, kernel, level + rounding);
        const MeshlessContours contours = contoursOf(field, mesh, { level }, 1e-5, 12);
        ASSERT_EQ(contours.sets.curves.size(), 1U) << level << " " << rounding;
        const LevelSetCurve& curve = contours.sets.curves.front();
        EXPECT_TRUE(curve.closed);
        EXPECT_LE(contours.largestDeviation, 1e-5);
        const Vector3d center = field.model().centers.col(0);
        for (const LevelSetPoint& point : curve.points)
        {
          EXPECT_NEAR((point.position - center).norm(), Width, 1e-12);
        }
        EXPECT_NEAR(curve.length, 2.0 * Pi * Width, 1e-4);
      }
    }
  }
}

// A level beside the plateau, however close in terms of a large offset, has a curve of its own: the
// circle where the term has that value.
TEST(MeshlessContourPlateaus, areNotLevelsBesideThem)
{
  constexpr double offset = 1048576.0;
  constexpr double height = 1.0 / 1024.0;
  const Mesh mesh = centeredSquare(9, 1.9, 0.2);
  for (const double sign : { -1.0, 1.0 })
  {
    FieldModel model = oneTerm(sign * height, KernelType::Wendland, offset).model();
    model.lowest = offset - height;
    model.highest = offset + height;
    const Field field(model);
    const double share = 1.0 / 1024.0;
    const MeshlessContours contours =
      contoursOf(field, mesh, { offset + sign * share * height }, 1e-4, 12);
    ASSERT_EQ(contours.sets.curves.size(), 1U) << sign;
    const Vector3d center = model.centers.col(0);
    const RadialKernel kernel(KernelType::Wendland, Width);
    for (const LevelSetPoint& point : contours.sets.curves.front().points)
    {
      EXPECT_NEAR(kernel.value((point.position - center).norm()), share * kernel.value(0.0), 1e-6);
    }
  }
}

// Of many terms: each point of a curve is at the end of a negative term where no other term is, or
// a zero where terms of both signs are; and there are all components that marching through the
// triangles finds. It does not take long.
TEST(MeshlessContourPlateaus, areBorderedByManyTerms)
{
  const Mesh mesh = centeredSquare(60, 1.9, 0.1);
  const Mesh finest = subdivided(mesh, 2);
  for (const KernelType kernel : { KernelType::Wendland, KernelType::Wu })
  {
    const Field field(termsInThePlane(100, Width / 4, Values::LinSpaced(100, -1.0, 1.0), kernel));
    const FieldModel& model = field.model();
    const MeshlessContours contours = contoursOf(field, mesh, { 0.0 });
    EXPECT_EQ(contours.sets.curves.size(),
      uniformContour(finest, field.evaluate(finest.vertices, {}).values, 0.0).size());
    EXPECT_LT(contours.evaluations, 1000000U); // 20 million without knowing of plateaus
    for (const LevelSetCurve& curve : contours.sets.curves)
    {
      const Points places = positionsOf(curve.points);
      const Values values = field.evaluate(places, {}).values;
      for (Eigen::Index i = 0; i < places.cols(); ++i)
      {
        const Eigen::ArrayXd depths = Width / 4 -
          (model.centers.colwise() - places.col(i)).colwise().norm().transpose().array();
        const auto isWithin = depths > 1e-12;
        const bool isPositive = (isWithin && model.coefficients.array() > 0.0).any();
        const bool isNegative = (isWithin && model.coefficients.array() < 0.0).any();
        EXPECT_EQ(isPositive, isNegative);
        EXPECT_LE(isPositive ? std::abs(values[i]) : depths.abs().minCoeff(), 1e-12);
      }
    }
  }
}

} // namespace
} // namespace SurfaceScalars
