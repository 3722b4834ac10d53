#pragma once

#include "SaddleFan.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace SurfaceScalars
{

/// A branch of one of several saddles.
struct BranchId
{
  std::size_t fan;
  std::size_t branch;
};

/// The saddles of a level: those whose branches are the ends of curves, and those found while
/// curves are traced without knowing them.
class LevelSaddles
{
public:
  LevelSaddles(SaddleFinder& finder, double level)
    : finder_(finder)
    , level_(level)
  {
  }

  const std::vector<SaddleFan>& known() const { return this->known_; }

  /// The end of a curve at a saddle of the model close to a station: none if that is none of the
  /// level, or one that is known, to be entered along a branch.
  std::optional<Vector3d> endAt(const Saddle& saddle, const Station& station);

  /// The branch along which the way from a station to the next leads into a known saddle, or the
  /// nearest one if it leads past them, among them.
  std::optional<BranchId> entered(const Station& from, const Station& next) const;

  /// Makes the saddles found known. @returns whether there are any
  bool learn();

private:
  SaddleFinder& finder_;
  double level_;
  std::vector<SaddleFan> known_;
  std::vector<SaddleFan> found_;
  std::vector<Vector3d> rejected_; ///< saddles of the model that are none of the level
};

} // namespace SurfaceScalars
