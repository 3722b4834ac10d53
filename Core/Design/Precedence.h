#pragma once

#include "Basics.h"

#include <unordered_map>
#include <vector>

namespace SurfaceScalars
{

/// Which vertices must come before which neighbors of theirs in an order; most are free.
class Precedence
{
public:
  void add(Index first, Index next) { this->before_[next].push_back(first); }

  const std::vector<Index>& before(Index vertex) const
  {
    static const std::vector<Index> none;
    const auto found = this->before_.find(vertex);
    return found == this->before_.end() ? none : found->second;
  }

private:
  std::unordered_map<Index, std::vector<Index>> before_;
};

} // namespace SurfaceScalars
