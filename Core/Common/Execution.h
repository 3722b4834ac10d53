#pragma once

#include "SurfaceScalarsCoreExport.h"

#include <cstddef>
#include <functional>

namespace SurfaceScalars
{

/// Told the finished fraction (0 to 1, never falling); returns false to stop. Called from the
/// calling thread only.
using Progress = std::function<bool(double)>;

/// How to run: with how many threads, and whom to tell. Results do not depend on either.
struct SURFACESCALARSCORE_EXPORT Execution
{
  int threadCount = 0; ///< 0 = all cores
  Progress progress;   ///< may be empty

  /// The same, its progress mapped onto [from, to] of the whole.
  Execution part(double from, double to) const;

  /// Says how far the work is. @throws Aborted if the progress function returns false
  void report(double fraction) const;
};

/// Work on the half-open range [begin, end).
using RangeBody = std::function<void(std::size_t begin, std::size_t end)>;

/**
 * Calls body for blocks of at most `grain` that cover [0, count), in any order and from several
 * threads. Progress is reported between blocks; the first exception of a body stops the others and
 * is thrown here.
 *
 * @throws Aborted if the progress function returns false
 */
SURFACESCALARSCORE_EXPORT void parallelFor(
  std::size_t count, std::size_t grain, const Execution& execution, const RangeBody& body);

/// To be called now and then by a body that runs for long. @throws Aborted once the work is to stop
using Poll = std::function<void()>;

/// Calls body once for each index below count, in any order and from several threads; otherwise as
/// parallelFor().
SURFACESCALARSCORE_EXPORT void parallelForEach(std::size_t count, const Execution& execution,
  const std::function<void(std::size_t index, const Poll& poll)>& body);

} // namespace SurfaceScalars
