#pragma once

#include "Execution.h"

#include <chrono>
#include <functional>
#include <string>

class vtkAlgorithm;
class vtkInformationVector;

namespace SurfaceScalars
{

/**
 * One execution of a filter, as its work sees it: how to run, and how to speak to the user.
 *
 * Threads: a number given to vtkSMPTools::Initialize() or LocalScope() is used, at most one thread
 * per core; else, with a backend other than Sequential or one chosen by VTK_SMP_BACKEND_IN_USE, as
 * many threads as that backend would use; else all cores, or VTK_SMP_MAX_THREADS of them.
 * (Sequential is what many VTK builds start with, so it is no choice by itself.)
 */
class FilterRun
{
public:
  FilterRun(vtkAlgorithm& filter, std::string speaker);
  FilterRun(const FilterRun&) = delete;
  FilterRun& operator=(const FilterRun&) = delete;

  vtkAlgorithm& filter() const { return this->filter_; }
  /// All threads the user allows, progress and abort of the filter.
  const Execution& execution() const { return this->execution_; }

  /// A warning, introduced by the filter's name.
  void warn(const std::string& sentence) const;
  /// A sentence about the input: a warning if the work succeeds, the end of the error if not.
  void note(const std::string& sentence);

private:
  friend int runFilter(vtkAlgorithm&, const std::string&, vtkInformationVector*,
    const std::function<void(FilterRun&)>&);

  bool proceed(double fraction);

  vtkAlgorithm& filter_;
  std::string speaker_;
  std::string note_;
  double shown_ = 0.0; ///< the progress last shown
  Execution execution_;
  std::chrono::steady_clock::time_point shownAt_ = std::chrono::steady_clock::now();
};

/**
 * Does the work of a RequestData() and keeps what every filter promises: a failure gives one error
 * that starts with `speaker` (the filter's name in the menu), an abort gives none, and both leave
 * all outputs empty.
 *
 * @returns what RequestData() has to return: 0 after a failure, else 1
 */
int runFilter(vtkAlgorithm& filter, const std::string& speaker, vtkInformationVector* outputs,
  const std::function<void(FilterRun&)>& work);

} // namespace SurfaceScalars
