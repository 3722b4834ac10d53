#include "ConstrainedSmoothing.h"
#include "Error.h"
#include "Meshes.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>

namespace SurfaceScalars::Truth
{
namespace
{

class SmoothingInput : public testing::Test
{
protected:
  /// The sentence with which a change of the input is refused.
  std::string refusal(const std::function<void(Values&, SmoothingParameters&)>& change) const
  {
    Values values = this->sphere_.points.row(0);
    SmoothingParameters parameters;
    change(values, parameters);
    try
    {
      smoothFunction(this->mesh_, values, parameters);
    }
    catch (const InvalidInput& error)
    {
      return error.what();
    }
    return {};
  }

  void expectRefused(
    const std::string& part, const std::function<void(Values&, SmoothingParameters&)>& change) const
  {
    const std::string sentence = this->refusal(change);
    EXPECT_NE(sentence.find(part), std::string::npos) << sentence;
  }

  const TriangleMesh sphere_ = subdividedSphere(3);
  const SmoothingMesh mesh_{ sphere_.points, trianglesOf(sphere_), {},
    [](Index vertex) { return vertex + 1000; } };
};

// Whatever cannot be worked on is refused with a sentence that says what was found.
TEST_F(SmoothingInput, isRefused)
{
  EXPECT_EQ(refusal([](Values&, SmoothingParameters&) {}), "");
  expectRefused("nan at vertex 1007",
    [](Values& values, SmoothingParameters&)
    { values[7] = std::numeric_limits<double>::quiet_NaN(); });
  expectRefused("inf at vertex 1009",
    [](Values& values, SmoothingParameters&)
    { values[9] = std::numeric_limits<double>::infinity(); });
  expectRefused("257 values for 258 vertices",
    [](Values& values, SmoothingParameters&) { values.conservativeResize(257); });
  expectRefused("-1e+308 to 1e+308",
    [](Values& values, SmoothingParameters&)
    {
      values[1] = 1e308;
      values[2] = -1e308;
    });
  for (const double outside : { -0.1, 1.1, std::numeric_limits<double>::quiet_NaN() })
  {
    expectRefused("PersistenceThreshold between 0 and 1",
      [=](Values&, SmoothingParameters& parameters) { parameters.persistenceThreshold = outside; });
    expectRefused("Delta between 0 and 1",
      [=](Values&, SmoothingParameters& parameters) { parameters.delta = outside; });
  }
  for (const double epsilon : { 0.0, -1.0, std::numeric_limits<double>::infinity() })
  {
    expectRefused("Epsilon above 0",
      [=](Values&, SmoothingParameters& parameters)
      {
        parameters.epsilonChoice = EpsilonChoice::Manual;
        parameters.epsilon = epsilon;
      });
  }
}

TEST_F(SmoothingInput, masksHaveToFit)
{
  for (const SmoothingMethod method : { SmoothingMethod::FeaturePreserving,
         SmoothingMethod::InterpolatingConstraints, SmoothingMethod::LeastSquaresConstraints })
  {
    expectRefused("3 for 258 vertices",
      [=](Values&, SmoothingParameters& parameters)
      {
        parameters.method = method;
        parameters.constraints = ConstraintChoice::MaskArray;
        parameters.mask = { 1, 1, 1 };
      });
    expectRefused("at least 1 vertex",
      [=](Values&, SmoothingParameters& parameters)
      {
        parameters.method = method;
        parameters.constraints = ConstraintChoice::MaskArray;
        parameters.mask.assign(258, 0);
      });
  }
}

// Thresholds above which nothing is are refused where a vertex has to be constrained.
TEST_F(SmoothingInput, someCriticalPointHasToBeChosen)
{
  for (const SmoothingMethod method :
    { SmoothingMethod::InterpolatingConstraints, SmoothingMethod::LeastSquaresConstraints })
  {
    for (const ConstraintChoice choice :
      { ConstraintChoice::DeltaSimplified, ConstraintChoice::Persistent })
    {
      expectRefused("at least one chosen critical point",
        [=](Values&, SmoothingParameters& parameters)
        {
          parameters.method = method;
          parameters.constraints = choice;
          parameters.delta = 1.0;
          parameters.persistenceThreshold = 1.0;
        });
    }
  }
}

// Constraints that leave a component without any are refused, its first vertex named;
// FeaturePreserving keeps the lowest and the highest vertex there.
TEST_F(SmoothingInput, everyComponentNeedsAConstraint)
{
  const TriangleMesh both = besideEachOther(sphere_, sphere_);
  const SmoothingMesh mesh(both.points, trianglesOf(both));
  const Values values = both.points.row(1);
  SmoothingParameters parameters;
  parameters.constraints = ConstraintChoice::MaskArray;
  parameters.mask.assign(516, 0);
  parameters.mask[5] = 1;
  for (const SmoothingMethod method :
    { SmoothingMethod::InterpolatingConstraints, SmoothingMethod::LeastSquaresConstraints })
  {
    parameters.method = method;
    try
    {
      smoothFunction(mesh, values, parameters);
      ADD_FAILURE() << "accepted";
    }
    catch (const InvalidInput& error)
    {
      EXPECT_NE(std::string(error.what()).find("258"), std::string::npos) << error.what();
    }
  }
  parameters.method = SmoothingMethod::FeaturePreserving;
  const SmoothedFunction result = smoothFunction(mesh, values, parameters);
  EXPECT_EQ(result.outputCounts.minima, 2u);
  EXPECT_EQ(result.outputCounts.maxima, 2u);
}

// A run stops as soon as the progress function says so, wherever it is.
TEST_F(SmoothingInput, stopsWhenAsked)
{
  const Values values = sphere_.points.row(0);
  for (const double until : { 0.0, 0.3, 0.65, 0.9 })
  {
    double last = 0.0;
    Execution execution;
    execution.progress = [&](double fraction)
    {
      EXPECT_GE(fraction, last);
      last = fraction;
      return fraction < until;
    };
    EXPECT_THROW(smoothFunction(mesh_, values, {}, execution), Aborted);
  }
}

} // namespace
} // namespace SurfaceScalars::Truth
