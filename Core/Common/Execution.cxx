#include "Execution.h"

#include "Error.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace SurfaceScalars
{
namespace
{

std::size_t threadsFor(const Execution& execution, std::size_t blocks)
{
  const std::size_t asked = execution.threadCount > 0
    ? static_cast<std::size_t>(execution.threadCount)
    : std::max(1u, std::thread::hardware_concurrency());
  return std::min(asked, blocks);
}

} // namespace

Execution Execution::part(double from, double to) const
{
  if (!this->progress)
  {
    return *this;
  }
  const Progress whole = this->progress;
  return { this->threadCount,
    [=](double fraction) { return whole(from + fraction * (to - from)); } };
}

void Execution::report(double fraction) const
{
  if (this->progress && !this->progress(fraction))
  {
    throw Aborted();
  }
}

void parallelForEach(std::size_t count, const Execution& execution,
  const std::function<void(std::size_t index, const Poll& poll)>& body)
{
  std::atomic<std::size_t> next{ 0 };
  std::atomic<bool> stop{ false };
  std::exception_ptr failure;
  std::size_t working = 0;
  std::mutex mutex; // for failure and working
  std::condition_variable finished;

  const auto work = [&](bool isCaller)
  {
    try
    {
      for (std::size_t index = next++; index < count && !stop; index = next++)
      {
        const Poll poll = [&, index]()
        {
          if (stop)
          {
            throw Aborted();
          }
          if (isCaller)
          {
            execution.report(static_cast<double>(index) / static_cast<double>(count));
          }
        };
        poll();
        body(index, poll);
      }
    }
    catch (...)
    {
      const std::lock_guard<std::mutex> lock(mutex);
      if (!stop.exchange(true))
      {
        failure = std::current_exception();
      }
    }
  };
  const auto workAndLeave = [&]()
  {
    work(false);
    const std::lock_guard<std::mutex> lock(mutex);
    --working;
    finished.notify_one();
  };

  std::vector<std::thread> others;
  try
  {
    for (std::size_t i = 1; i < threadsFor(execution, count); ++i)
    {
      std::unique_lock<std::mutex> lock(mutex);
      others.emplace_back(workAndLeave);
      ++working;
    }
  }
  catch (const std::system_error&)
  {
    // The system gives no more threads: those there are do the work.
  }
  work(true);
  // The others may be at it for long yet, and an abort is only heard here.
  const auto listen = [&](std::unique_lock<std::mutex>& lock)
  {
    lock.unlock();
    try
    {
      const auto begun = static_cast<double>(std::min<std::size_t>(next, count));
      execution.report(std::max(0.0, begun - 1.0) / static_cast<double>(count));
    }
    catch (...)
    {
      lock.lock();
      failure = std::current_exception();
      stop = true;
      return;
    }
    lock.lock();
  };
  std::unique_lock<std::mutex> lock(mutex);
  while (!finished.wait_for(lock, std::chrono::milliseconds(50), [&]() { return working == 0; }))
  {
    if (!stop)
    {
      listen(lock);
    }
  }
  lock.unlock();
  for (std::thread& other : others)
  {
    other.join();
  }
  if (failure)
  {
    std::rethrow_exception(failure);
  }
  execution.report(1.0);
}

void parallelFor(
  std::size_t count, std::size_t grain, const Execution& execution, const RangeBody& body)
{
  parallelForEach((count + grain - 1) / grain, execution,
    [&](std::size_t block, const Poll&)
    { body(block * grain, std::min(count, (block + 1) * grain)); });
}

} // namespace SurfaceScalars
