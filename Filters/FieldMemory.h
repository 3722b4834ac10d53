#pragma once

#include "Field.h"
#include "PointSetInput.h"

#include <optional>

namespace SurfaceScalars
{

/**
 * The field that was made last and what it was made of, for filters that run again with another
 * target or time step: what has not changed is not computed again (design paper, sec. 6.3).
 *
 * Points and values are compared by content, for a time step brings new arrays of the same points.
 */
class FieldMemory
{
public:
  /// f~ through these samples, exactly as Field::fit() makes it. Valid until the next call.
  const Field& fieldOf(
    Samples&& samples, const FieldParameters& parameters, const Execution& execution);

private:
  bool hasPoints(const Points& points, const FieldParameters& parameters) const;

  Samples samples_;
  FieldParameters parameters_;
  std::optional<Field> field_;
};

} // namespace SurfaceScalars
