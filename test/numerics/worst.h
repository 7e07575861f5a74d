#pragma once
#include <cstdint>
#include <limits>

namespace telar::numerics {

/// The largest value seen, and at which point.
struct Worst {
  double value = 0;
  std::uint64_t point = 0;

  /// NaN is the worst of all.
  void see(double candidate, std::uint64_t at) {
    if (!(candidate <= value))
      value = candidate == candidate ? candidate : std::numeric_limits<double>::infinity(), point = at;
  }
  void see(const Worst& other) { see(other.value, other.point); }
};

}  // namespace telar::numerics
