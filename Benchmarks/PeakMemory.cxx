#include "PeakMemory.h"

#include <fstream>
#include <string>

namespace
{

/// What the kernel counts for this process, in bytes: VmHWM is the largest VmRSS since the last
/// reset.
double memoryOf(const std::string& field)
{
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
  {
    if (line.rfind(field, 0) == 0)
    {
      return 1024.0 * std::stod(line.substr(field.size() + 1));
    }
  }
  return 0.0;
}

} // namespace

PeakMemory::PeakMemory()
{
  std::ofstream("/proc/self/clear_refs") << "5";
  this->before_ = memoryOf("VmRSS:");
}

double PeakMemory::bytes() const
{
  return memoryOf("VmHWM:") - this->before_;
}
