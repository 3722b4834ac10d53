#pragma once

#include "Basics.h"

#include <cstddef>

namespace SurfaceScalars
{

/// What a place is to a function. The numbers are fixed: output arrays and files keep them.
enum class CriticalType : signed char
{
  Excluded = -1, ///< no value there
  Minimum = 0,
  Saddle = 1,    ///< of multiplicity m: f crosses its value 2 + 2 m times around it
  TwoSaddle = 2, ///< in volumes
  Maximum = 3,
  Uncertain = 4, ///< critical, but noise or degeneracy hide of what type
  Regular = 5
};

/// For messages.
constexpr const char* nameOf(CriticalType type)
{
  switch (type)
  {
    case CriticalType::Minimum:
      return "minimum";
    case CriticalType::Saddle:
      return "saddle";
    case CriticalType::TwoSaddle:
      return "2-saddle";
    case CriticalType::Maximum:
      return "maximum";
    case CriticalType::Uncertain:
      return "uncertain point";
    case CriticalType::Regular:
      return "regular point";
    case CriticalType::Excluded:
      break;
  }
  return "excluded point";
}

/// A critical point of a function on a surface, sampled or meshed.
struct CriticalPoint
{
  Vector3d position; ///< in the caller's coordinates
  CriticalType type = CriticalType::Uncertain;
  int multiplicity = 1;     ///< m of a saddle; 1 for others
  double value = 0.0;       ///< of f
  std::size_t input = 0;    ///< index of the nearest input point
  double persistence = 0.0; ///< in f's unit; f's range if it is never cancelled
  double probability = 1.0; ///< largest among the samples of its cluster, 0 to 1
  double residual = 0.0;    ///< norm of the tangential gradient of f~, f's unit per length
};

/// The index of Poincare and Hopf: 1 for extrema, -m for saddles, 0 for others. Over a closed
/// surface they sum to its Euler characteristic.
constexpr int indexOf(CriticalType type, int multiplicity)
{
  switch (type)
  {
    case CriticalType::Minimum:
    case CriticalType::Maximum:
      return 1;
    case CriticalType::Saddle:
      return -multiplicity;
    default:
      return 0;
  }
}

constexpr int indexOf(const CriticalPoint& point)
{
  return indexOf(point.type, point.multiplicity);
}

} // namespace SurfaceScalars
