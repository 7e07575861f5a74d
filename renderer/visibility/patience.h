#pragma once
#include <cstdint>

#include "telar/cancel.h"

namespace telar::visibility {

/// Counts what is looked at, and looks at a cancel token now and then.
class Patience {
 public:
  explicit Patience(const CancelToken& cancel) : cancel_(cancel) {}
  /// Pixels so far, and what takes as long as one.
  std::int64_t steps = 0;
  /// For each triangle.
  void spend() {
    steps += TRIANGLE;
    if (steps - checked_ < MOST) return;
    checked_ = steps;
    cancel_.check();
  }

 private:
  static constexpr std::int64_t TRIANGLE = 16;   ///< what a triangle costs besides its pixels
  static constexpr std::int64_t MOST = 1 << 22;  ///< some 20 ms
  const CancelToken& cancel_;
  std::int64_t checked_ = 0;
};

}  // namespace telar::visibility
