#pragma once

#include "vtkObject.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace SurfaceScalars
{

// What SetNumberOfX(), SetX() and GetX() of a filter's list X do; `name` is X.

template <typename Entry>
void setListSize(vtkObject& filter, std::vector<Entry>& list, int size)
{
  const auto entries = static_cast<std::size_t>(std::max(0, size));
  if (list.size() != entries)
  {
    list.resize(entries);
    filter.Modified();
  }
}

/// Lengthens the list if the index is beyond its end.
template <typename Entry>
void setListEntry(
  vtkObject& filter, const char* name, std::vector<Entry>& list, int i, const Entry& entry)
{
  if (i < 0)
  {
    vtkErrorWithObjectMacro(
      &filter, << "Set" << name << ": needs an index of at least 0, found " << i << ".");
    return;
  }
  const auto index = static_cast<std::size_t>(i);
  if (index < list.size() && list[index] == entry)
  {
    return;
  }
  list.resize(std::max(list.size(), index + 1));
  list[index] = entry;
  filter.Modified();
}

template <typename Entry>
Entry listEntry(vtkObject& filter, const char* name, const std::vector<Entry>& list, int i)
{
  if (i < 0 || static_cast<std::size_t>(i) >= list.size())
  {
    vtkErrorWithObjectMacro(&filter, << "Get" << name << ": needs an index from 0 to "
                                     << static_cast<int>(list.size()) - 1 << ", found " << i
                                     << ".");
    return {};
  }
  return list[static_cast<std::size_t>(i)];
}

} // namespace SurfaceScalars
