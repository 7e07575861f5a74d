#pragma once
#include <algorithm>
#include <cstdint>
#include <limits>

namespace telar::asset {

/// Nearest float; values beyond its range become the largest one (a plain cast would be undefined).
inline float toFloat(double value) {
  constexpr double MAX = std::numeric_limits<float>::max();
  return static_cast<float>(std::clamp(value, -MAX, MAX));
}

/// Whether `count` elements of `elementBytes`, `stride` bytes apart, the first at `offset`, lie within `available`
/// bytes. Exact for all 64-bit values: nothing wraps. count 0 fits where offset <= available.
inline bool fits(std::uint64_t available, std::uint64_t offset, std::uint64_t count, std::uint64_t stride,
                 std::uint64_t elementBytes) {
  if (offset > available) return false;
  if (count == 0) return true;
  std::uint64_t bytes = 0;
  if (__builtin_mul_overflow(count - 1, stride, &bytes)) return false;
  if (__builtin_add_overflow(bytes, elementBytes, &bytes)) return false;
  return bytes <= available - offset;
}

}  // namespace telar::asset
