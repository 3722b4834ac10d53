#include "VertexOrder.h"

#include <algorithm>
#include <cstdint>

namespace SurfaceScalars
{
namespace
{

constexpr std::size_t RunLength = 65536; // sorted at once, so that an abort is heard

struct Entry
{
  double value;
  std::int64_t tie; ///< vertex - sign * 2^32

  bool operator<(const Entry& other) const
  {
    return this->value < other.value || (this->value == other.value && this->tie < other.tie);
  }
};

/// Merges the sorted runs of a length in pairs.
void mergeRuns(const std::vector<Entry>& from, std::vector<Entry>& to, std::size_t length,
  const Execution& execution)
{
  const auto at = [&](std::size_t entry)
  { return static_cast<std::ptrdiff_t>(std::min(entry, from.size())); };
  parallelForEach((from.size() + 2 * length - 1) / (2 * length), execution,
    [&](std::size_t pair, const Poll&)
    {
      const std::ptrdiff_t first = at(2 * pair * length);
      const std::ptrdiff_t second = at((2 * pair + 1) * length);
      const std::ptrdiff_t end = at((2 * pair + 2) * length);
      std::merge(from.begin() + first, from.begin() + second, from.begin() + second,
        from.begin() + end, to.begin() + first);
    });
}

void sort(std::vector<Entry>& entries, const Execution& execution)
{
  const Execution polling = execution.part(0.0, 0.0);
  parallelFor(entries.size(), RunLength, polling,
    [&](std::size_t begin, std::size_t end)
    {
      std::sort(entries.begin() + static_cast<std::ptrdiff_t>(begin),
        entries.begin() + static_cast<std::ptrdiff_t>(end));
    });
  std::vector<Entry> merged(entries.size());
  for (std::size_t length = RunLength; length < entries.size(); length *= 2)
  {
    mergeRuns(entries, merged, length, polling);
    entries.swap(merged);
  }
}

} // namespace

VertexOrder orderByValue(
  const ValuesRef& values, const ExtremumSigns& signs, const Execution& execution)
{
  std::vector<Entry> entries(signs.size());
  for (std::size_t vertex = 0; vertex < entries.size(); ++vertex)
  {
    entries[vertex] = { values[static_cast<Eigen::Index>(vertex)],
      static_cast<std::int64_t>(vertex) - signs[vertex] * (std::int64_t(1) << 32) };
  }
  sort(entries, execution);
  std::vector<Index> ascending(entries.size());
  std::transform(entries.begin(), entries.end(), ascending.begin(),
    [](const Entry& entry) { return static_cast<Index>(entry.tie); });
  return VertexOrder(std::move(ascending));
}

} // namespace SurfaceScalars
