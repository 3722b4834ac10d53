#include "Error.h"
#include "Execution.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

namespace SurfaceScalars
{
namespace
{

// The blocks partition [0, count): every index belongs to exactly one, whatever count, grain and
// threads are.
TEST(Execution, coversEachIndexOnce)
{
  for (const std::size_t count : { 0, 1, 7, 64, 1000 })
  {
    for (const std::size_t grain : { 1, 7, 64, 2000 })
    {
      for (const int threadCount : { 0, 1, 2, 5 })
      {
        std::vector<std::atomic<int>> visits(count);
        parallelFor(count, grain, Execution{ threadCount, {} },
          [&](std::size_t begin, std::size_t end)
          {
            ASSERT_LT(begin, end);
            ASSERT_LE(end - begin, grain);
            for (std::size_t i = begin; i < end; ++i)
            {
              ++visits[i];
            }
          });
        for (const auto& visit : visits)
        {
          ASSERT_EQ(visit, 1) << count << " in blocks of " << grain << " on " << threadCount;
        }
      }
    }
  }
}

// What a body throws reaches the caller, from whichever thread.
TEST(Execution, passesOnExceptions)
{
  for (const int threadCount : { 1, 2, 4 })
  {
    for (const std::size_t bad : { 0, 500, 999 })
    {
      const auto body = [=](std::size_t begin, std::size_t end)
      {
        if (begin <= bad && bad < end)
        {
          throw std::out_of_range("here");
        }
      };
      EXPECT_THROW(parallelFor(1000, 10, Execution{ threadCount, {} }, body), std::out_of_range);
    }
  }
}

// A progress function that returns false ends the work with Aborted, and part of it is never
// started.
TEST(Execution, abortsOnRequest)
{
  for (const int threadCount : { 1, 2 })
  {
    std::atomic<std::size_t> done{ 0 };
    const Execution execution{ threadCount, [](double fraction) { return fraction < 0.3; } };
    const auto body = [&](std::size_t begin, std::size_t end) { done += end - begin; };
    EXPECT_THROW(parallelFor(100000, 1, execution, body), Aborted);
    if (threadCount == 1)
    {
      EXPECT_NEAR(static_cast<double>(done), 30000.0, 1.0);
    }
  }
}

// Progress lies in [0, 1], never falls and ends at 1; it is reported by the calling thread only.
TEST(Execution, reportsMonotoneProgress)
{
  for (const int threadCount : { 1, 2, 4 })
  {
    std::vector<double>
      reported; // unguarded on purpose: a second thread here is a data race the sanitizers see
    const Execution execution{ threadCount,
      [&](double fraction)
      {
        reported.push_back(fraction);
        return true;
      } };
    parallelFor(1000, 3, execution, [](std::size_t, std::size_t) {});
    ASSERT_FALSE(reported.empty());
    EXPECT_GE(reported.front(), 0.0);
    EXPECT_EQ(reported.back(), 1.0);
    EXPECT_TRUE(std::is_sorted(reported.begin(), reported.end()));
  }
}

// part(a, b) maps fractions affinely onto [a, b]; parts of parts compose.
TEST(Execution, partsCompose)
{
  double last = -1.0;
  const Execution whole{ 1,
    [&](double fraction)
    {
      last = fraction;
      return fraction < 0.9;
    } };
  whole.part(0.5, 1.0).part(0.0, 0.5).report(0.5);
  EXPECT_DOUBLE_EQ(last, 0.625);
  EXPECT_THROW(whole.part(0.0, 1.0).report(0.95), Aborted);
  EXPECT_NO_THROW(Execution().part(0.2, 0.4).report(1.0));
  EXPECT_EQ(whole.part(0.1, 0.2).threadCount, 1);
}

} // namespace
} // namespace SurfaceScalars
