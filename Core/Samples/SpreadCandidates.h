#pragma once

#include "PointTree.h"

#include <vector>

namespace SurfaceScalars
{

/// Vertices, the most wanted first, of which some are chosen that are apart from each other.
class SpreadCandidates
{
public:
  /// Both must outlive this.
  SpreadCandidates(const Points& vertices, const std::vector<Index>& candidates);

  /// Appends to `chosen` until it has `count`: no closer than `apart` to those from `first` on, and
  /// than `apartFromOthers` to those before.
  void choose(std::vector<Index>& chosen, std::size_t first, double apart, double apartFromOthers,
    std::size_t count) const;

private:
  void take(Index vertex, double radius, std::vector<char>& isTaken) const;

  const Points& vertices_;
  const std::vector<Index>& candidates_;
  Points places_;
  PointTree tree_;
};

} // namespace SurfaceScalars
