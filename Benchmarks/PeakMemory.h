#pragma once

/// Resident memory of this process beyond what it had when this was made, as the kernel counts it.
class PeakMemory
{
public:
  PeakMemory();
  double bytes() const; ///< the largest so far; 0 where memory of earlier work was reused

private:
  double before_;
};
