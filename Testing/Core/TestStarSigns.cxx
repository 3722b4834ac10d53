#include "Sampling.h"
#include "StarSigns.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

namespace SurfaceScalars
{
namespace
{

using Truth::Random;

int changesOf(const std::vector<int>& signs, bool isClosed)
{
  int changes = 0;
  for (std::size_t i = 1; i < signs.size(); ++i)
  {
    changes += signs[i] != signs[i - 1] ? 1 : 0;
  }
  return changes + (isClosed && signs.front() != signs.back() ? 1 : 0);
}

bool areAllowed(const std::vector<int>& signs, const std::vector<int>& forced)
{
  for (std::size_t i = 0; i < signs.size(); ++i)
  {
    if (forced[i] == -signs[i])
    {
      return false;
    }
  }
  return true;
}

double agreement(const std::vector<int>& signs, const std::vector<double>& wanted)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < signs.size(); ++i)
  {
    sum += signs[i] * wanted[i];
  }
  return sum;
}

/// The largest agreement of all signs there are, if any are allowed.
std::optional<double> bestByTrying(
  const std::vector<double>& wanted, const std::vector<int>& forced, bool isClosed, int changes)
{
  std::optional<double> best;
  std::vector<int> signs(wanted.size());
  for (unsigned bits = 0; bits < 1U << wanted.size(); ++bits)
  {
    for (std::size_t i = 0; i < signs.size(); ++i)
    {
      signs[i] = (bits >> i) % 2 == 0 ? -1 : 1;
    }
    if (areAllowed(signs, forced) && changesOf(signs, isClosed) == changes)
    {
      best = std::max(best.value_or(-INFINITY), agreement(signs, wanted));
    }
  }
  return best;
}

// The signs change as often as asked, respect those that are forced, and no others agree better:
// all 2^n are tried.
TEST(StarSigns, agreeAsWellAsAny)
{
  Random random(1);
  int found = 0;
  for (int trial = 0; trial < 2000; ++trial)
  {
    const auto size = static_cast<std::size_t>(1 + random.uniform() * 9);
    const bool isClosed = random.uniform() < 0.5;
    const int changes = static_cast<int>(random.uniform() * 5) * (isClosed ? 2 : 1);
    std::vector<double> wanted(size);
    std::vector<int> forced(size);
    for (std::size_t i = 0; i < size; ++i)
    {
      wanted[i] = random.uniform(-1.0, 1.0);
      forced[i] = random.uniform() < 0.8 ? 0 : random.uniform() < 0.5 ? 1 : -1;
    }
    const std::vector<int> signs = closestSigns(wanted, forced, isClosed, changes);
    const std::optional<double> best = bestByTrying(wanted, forced, isClosed, changes);
    ASSERT_EQ(signs.empty(), !best.has_value());
    if (best)
    {
      ++found;
      ASSERT_EQ(signs.size(), size);
      ASSERT_EQ(changesOf(signs, isClosed), changes);
      ASSERT_TRUE(areAllowed(signs, forced));
      ASSERT_NEAR(agreement(signs, wanted), *best, 1e-12);
    }
  }
  EXPECT_GT(found, 500);
}

} // namespace
} // namespace SurfaceScalars
