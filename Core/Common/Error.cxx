#include "Error.h"

namespace SurfaceScalars
{

Error::~Error() = default;
InvalidInput::~InvalidInput() = default;
Aborted::~Aborted() = default;

InvalidInput::InvalidInput(
  const std::string& expected, const std::string& found, const std::string& remedy)
  : Error("needs " + expected + ", found " + found + ". " + remedy)
{
}

const char* Aborted::what() const noexcept
{
  return "stopped on request";
}

} // namespace SurfaceScalars
