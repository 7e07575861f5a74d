#include "reference/rows.h"

#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace telar::reference {

void forEachRow(int rows, int threads, const std::function<void(int)>& job) {
  std::atomic<int> next = 0;
  std::exception_ptr failure;
  std::mutex mutex;
  const auto work = [&] {
    try {
      for (int row = next++; row < rows; row = next++) job(row);
    } catch (...) {
      next = rows;  // the others stop after their row
      const std::lock_guard lock(mutex);
      if (!failure) failure = std::current_exception();
    }
  };
  std::vector<std::jthread> pool;
  for (int i = 1; i < threads; ++i) pool.emplace_back(work);
  work();
  pool.clear();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace telar::reference
