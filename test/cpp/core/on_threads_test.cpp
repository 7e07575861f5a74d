#include "core/on_threads.h"

#include <gtest/gtest.h>

#include <condition_variable>
#include <set>
#include <stdexcept>

namespace telar::on_threads_test {
namespace {

TEST(OnThreads, DoEachOnce) {
  for (const std::size_t threads : {0, 1, 2, 7}) {
    for (const int count : {0, 1, 5, 1000}) {
      std::vector<std::atomic<int>> done(static_cast<std::size_t>(count));
      onThreads(count, threads, [&](int i) { ++done[static_cast<std::size_t>(i)]; });
      for (const auto& times : done) EXPECT_EQ(times, 1) << threads << " threads, " << count;
    }
  }
}

TEST(OnThreads, WorkAtOnceAndNoMoreThanAreAskedFor) {
  std::mutex mutex;
  std::condition_variable met;
  std::set<std::thread::id> seen;
  onThreads(50, 3, [&](int) {
    std::unique_lock lock(mutex);
    seen.insert(std::this_thread::get_id());
    met.notify_all();
    // Ends where three are at work at once.
    EXPECT_TRUE(met.wait_for(lock, std::chrono::seconds(20), [&] { return seen.size() == 3; }));
  });
  EXPECT_EQ(seen.size(), 3u);
  EXPECT_TRUE(seen.contains(std::this_thread::get_id()));
}

TEST(OnThreads, EndWithWhatOneThrows) {
  for (const std::size_t threads : {1, 2, 4}) {
    std::atomic<int> begun = 0;
    const auto work = [&](int i) {
      ++begun;
      if (i == 3) throw std::out_of_range("the third");
    };
    EXPECT_THROW(onThreads(1 << 20, threads, work), std::out_of_range) << threads;
    EXPECT_LT(begun, 1 << 20) << threads;
  }
}

}  // namespace
}  // namespace telar::on_threads_test
