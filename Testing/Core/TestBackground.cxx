#include "Background.h"
#include "Error.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace SurfaceScalars
{
namespace
{

// What the work returns or throws comes back, with and without somebody who listens.
TEST(Background, returnsWhatTheWorkReturns)
{
  for (const Progress& progress : { Progress(), Progress([](double) { return true; }) })
  {
    EXPECT_EQ(inBackground({ 0, progress }, []() { return 42; }), 42);
    EXPECT_THROW(inBackground({ 0, progress }, []() -> int { throw std::runtime_error("no"); }),
      std::runtime_error);
  }
}

// Once the listener says no, nobody waits for the work, which may still be at it: here until the
// test is over.
TEST(Background, isAbandonedOnAbort)
{
  std::promise<int> never;
  const auto waited = std::make_shared<std::future<int>>(never.get_future());
  EXPECT_THROW(
    inBackground({ 0, [](double) { return false; } }, [waited]() { return waited->get(); }),
    Aborted);
  never.set_value(0);
}

} // namespace
} // namespace SurfaceScalars
