#pragma once

#include "SurfaceScalarsCoreExport.h"

#include <stdexcept>
#include <string>

namespace SurfaceScalars
{

/// Whatever the core refuses; what() is one sentence that can be shown to a user after the name of
/// who speaks.
class SURFACESCALARSCORE_EXPORT Error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
  ~Error() override;
};

/// The input cannot be worked on: says what was expected, what was found and what to do.
class SURFACESCALARSCORE_EXPORT InvalidInput : public Error
{
public:
  InvalidInput(const std::string& expected, const std::string& found, const std::string& remedy);
  ~InvalidInput() override;
};

/// The caller's progress function asked to stop. Not an Error: there is nothing to report.
class SURFACESCALARSCORE_EXPORT Aborted : public std::exception
{
public:
  ~Aborted() override;
  const char* what() const noexcept override;
};

} // namespace SurfaceScalars
