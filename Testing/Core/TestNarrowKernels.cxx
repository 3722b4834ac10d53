#include "FieldTruth.h"
#include "KernelWidth.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace SurfaceScalars
{
namespace
{

using namespace Truth;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

const std::vector<KernelType> WidthDependent{ KernelType::Gaussian, KernelType::Exponential,
  KernelType::Multiquadric, KernelType::InverseMultiquadric, KernelType::Wendland, KernelType::Wu };

FieldParameters withWidth(KernelType kernel, double width)
{
  FieldParameters parameters = parametersOf(Scheme::GlobalRBF, kernel);
  parameters.kernelWidth = width;
  return parameters;
}

Values wavesAt(const Points& places)
{
  return (4.0 * places.row(0)).array().sin() * (3.0 * places.row(1)).array().cos();
}

/// Root mean square at random places among the centers.
double errorOf(const Points& centers, const FieldParameters& parameters)
{
  Points places = randomPlaces(1000, 0.95, 5);
  places.row(2) *= centers.row(2).norm() > 0.0 ? 1.0 : 0.0;
  const Values u = Field::fit(centers, wavesAt(centers), parameters).evaluate(places, {}).values;
  return (u - wavesAt(places)).norm() / std::sqrt(1000.0);
}

std::string remark(const Points& centers, const FieldParameters& parameters)
{
  return remarkOnWidth(parameters, PointCloud(centers));
}

/// A square grid, random places in the plane, and in space, all from -1 to 1.
std::vector<Points> centerExamples()
{
  Points grid(3, 400);
  for (Eigen::Index i = 0; i < grid.cols(); ++i)
  {
    grid.col(i) << -1.0 + 2.0 / 19.0 * static_cast<double>(i % 20),
      -1.0 + 2.0 / 19.0 * static_cast<double>(i / 20), 0.0;
  }
  Points plane = randomPlaces(400, 1.0, 3);
  plane.row(2).setZero();
  return { grid, plane, randomPlaces(500, 1.0, 4) };
}

// Between its centers a sum of kernels of a width that is called narrow misses the function by half
// of what nothing but the polynomial does, or more; one that does so by nine tenths is called
// narrow.
TEST(NarrowKernels, missTheFunctionBetweenTheirCenters)
{
  int narrow = 0;
  for (const Points& centers : centerExamples())
  {
    const double alone = errorOf(centers, withWidth(KernelType::Gaussian, 1e-6));
    for (const KernelType kernel : WidthDependent)
    {
      for (const double width : { 0.001, 0.003, 0.01, 0.02, 0.04, 0.06, 0.09, 0.12, 0.15 })
      {
        const FieldParameters parameters = withWidth(kernel, width);
        const double share = errorOf(centers, parameters) / alone;
        const bool isNarrow = !remark(centers, parameters).empty();
        EXPECT_GE(share, isNarrow ? 0.45 : 0.0) << nameOf(kernel) << " " << width;
        EXPECT_LE(share, isNarrow ? 2.0 : 0.9) << nameOf(kernel) << " " << width;
        narrow += isNarrow;
      }
    }
  }
  EXPECT_GT(narrow, 40);
}

// The sentence has the numbers. There is none on widths that are chosen, kernels that have none and
// schemes that have no kernel.
TEST(NarrowKernels, areRemarkedOnInOneSentence)
{
  const Points grid = centerExamples().front();
  const FieldParameters narrow = withWidth(KernelType::Wendland, 0.01);
  EXPECT_THAT(remark(grid, narrow),
    AllOf(HasSubstr("KernelWidth 0.01"), HasSubstr("Wendland"), HasSubstr("0.148"),
      HasSubstr("set it to 0")));
  EXPECT_THAT(remark(grid, withWidth(KernelType::Wendland, 0.0)), IsEmpty());
  EXPECT_THAT(remark(grid, withWidth(KernelType::Cubic, 0.01)), IsEmpty());
  FieldParameters average = narrow;
  average.scheme = Scheme::ExplicitMLS;
  EXPECT_THAT(remark(grid, average), IsEmpty());
  EXPECT_THAT(remark(grid.leftCols(1), narrow), IsEmpty());
}

} // namespace
} // namespace SurfaceScalars
