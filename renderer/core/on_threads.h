#pragma once
#include <algorithm>
#include <atomic>
#include <concepts>
#include <cstddef>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace telar {

/// Calls work(i) for each i below `count`, in their order, on this thread and on others beside it. Where one throws, no
/// more are begun, and what that one threw is thrown.
/// @param threads  at most, this one with them; where the machine has none to give, those that there are do it all
template <std::integral Index, class Work>
void onThreads(Index count, std::size_t threads, const Work& work) {
  std::atomic<Index> next = 0;
  std::exception_ptr failure;
  std::mutex mutex;
  const auto run = [&] {
    try {
      for (Index i = next++; i < count; i = next++) work(i);
    } catch (...) {
      next = count;
      const std::lock_guard lock(mutex);
      if (!failure) failure = std::current_exception();
    }
  };
  std::vector<std::jthread> others;
  try {
    while (others.size() + 1 < std::min(threads, static_cast<std::size_t>(count))) others.emplace_back(run);
  } catch (const std::system_error&) {
    // The machine has no thread to give.
  }
  run();
  others.clear();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace telar
