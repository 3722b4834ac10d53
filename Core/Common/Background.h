#pragma once

#include "Execution.h"

#include <chrono>
#include <future>
#include <memory>
#include <system_error>
#include <thread>
#include <utility>

namespace SurfaceScalars
{

/**
 * Does work that cannot be interrupted, such as a factorization, in a thread of its own while this
 * one listens for an abort.
 *
 * @param work must own whatever it uses: after an abort nobody waits for it, and what it returns
 * later is thrown away
 * @throws what work throws; Aborted
 */
template <class Work>
auto inBackground(const Execution& execution, Work work) -> decltype(work())
{
  using Task = std::packaged_task<decltype(work())()>;
  const auto task = std::make_shared<Task>(std::move(work));
  auto result = task->get_future();
  try
  {
    if (execution.progress)
    {
      std::thread([task]() { (*task)(); }).detach();
    }
    else
    {
      (*task)();
    }
  }
  catch (const std::system_error&)
  {
    (*task)(); // the system gives no more threads
  }
  while (result.wait_for(std::chrono::milliseconds(50)) != std::future_status::ready)
  {
    execution.report(0.0);
  }
  execution.report(1.0);
  return result.get();
}

} // namespace SurfaceScalars
