#pragma once
#include <chrono>
#include <ctime>

namespace telar::test {

/// CPU time of this process with all of its threads: however much other processes compute, it tells the same.
struct CpuClock {
  using duration = std::chrono::duration<double>;
  using rep = duration::rep;
  using period = duration::period;
  using time_point = std::chrono::time_point<CpuClock>;
  static constexpr bool is_steady = true;

  static time_point now() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return time_point(duration(static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec)));
  }
};

}  // namespace telar::test
