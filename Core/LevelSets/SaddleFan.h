#pragma once

#include "LevelSetWalker.h"

#include <optional>
#include <vector>

namespace SurfaceScalars
{

/// A saddle of a level's value and where the level set leaves it: 2 + 2 m branches for
/// multiplicity m.
struct SaddleFan
{
  Station center;                  ///< its direction is of no meaning
  double radius = 0.0;             ///< of the circle around it on which the branches begin
  std::vector<Station> branches;   ///< round the center, one way or the other; directions outwards
  bool firstSectorIsAbove = false; ///< larger values lie between branches 0 and 1, smaller ones
                                   ///< between 1 and 2, and so on

  /// The branch at the other side of the larger values beside a branch.
  std::size_t acrossLarger(std::size_t branch) const
  {
    const std::size_t count = this->branches.size();
    const bool isBefore = (branch % 2 == 0) == this->firstSectorIsAbove;
    return (branch + (isBefore ? 1 : count - 1)) % count;
  }
};

/**
 * Finds the saddles of a level and their branches (sec. 5.2), of any multiplicity up to 4, on a
 * polynomial of degree 5 over the tangent plane. The multiplicity m is that of the 2 + 2 m changes
 * of the sign of F - level on circles. The place is where the derivatives of order m vanish: by
 * Newton's method for m = 1, in the mean of squares (Gauss-Newton) if the saddle is degenerate.
 */
class SaddleFinder
{
public:
  SaddleFinder(LevelSetModel& model, LevelSetWalker& walker, const SampledFunction& function,
    double level, const Poll& poll);

  /// @param candidate a saddle of the model, near the level's @param nearby a station close to it
  /// @returns none if there is no saddle of the level, or its branches are not clear
  std::optional<SaddleFan> find(const Saddle& candidate, const Station& nearby);

private:
  /// Where the sign of F - level changes on a circle.
  struct Ring
  {
    double radius = 0.0;
    std::vector<double> angles;
    bool firstSectorIsAbove = false; ///< between the first two angles
    double amplitude = 0.0;          ///< the least of the largest |F - level| of the sectors
  };

  bool fitAt(const Vector3d& place);
  double polynomial(const Vector2d& place) const;
  Vector2d stepToZero(int order) const;
  Ring ringOf(double radius) const;
  std::optional<Ring> clearRing(double radius) const;
  int orderHere(double step) const;
  bool refine(Vector3d& center, double step);
  std::optional<SaddleFan> fanOf(const Vector3d& center, const Ring& ring, const Station& nearby);

  LevelSetModel& model_;
  LevelSetWalker& walker_;
  const SampledFunction& function_;
  double level_;
  const Poll& poll_;

  // The polynomial:
  Vector3d center_ = Vector3d::Zero();
  Eigen::Matrix<double, 3, 2> axes_ = Eigen::Matrix<double, 3, 2>::Zero();
  double scale_ = 1.0;     ///< length that coordinates are divided by
  Values coefficients_;    ///< of F - level: u^(d - j) v^j by degree d, then by j
  double deviation_ = 0.0; ///< of the samples from it, root mean square
  Neighborhood near_;      ///< scratch
};

} // namespace SurfaceScalars
