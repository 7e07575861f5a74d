#pragma once
#include <atomic>
#include <memory>

#include "telar/previews.h"

namespace telar {

/// How far a job is: set by the threads that do it, read by whoever waits.
class Progress {
 public:
  /// @param part  0..1; one that is below what was said before changes nothing
  void reach(float part) const {
    float said = part_->load(std::memory_order_relaxed);
    while (said < part && !part_->compare_exchange_weak(said, part, std::memory_order_relaxed)) {
    }
  }
  float part() const { return part_->load(std::memory_order_relaxed); }

  /// From now on the picture as it is will do: no pass follows, and none that has begun need end.
  void settle() const { enough_->store(true, std::memory_order_relaxed); }
  bool isEnough() const { return enough_->load(std::memory_order_relaxed); }

  Previews previews;

 private:
  std::shared_ptr<std::atomic<float>> part_ = std::make_shared<std::atomic<float>>(0.0f);
  std::shared_ptr<std::atomic<bool>> enough_ = std::make_shared<std::atomic<bool>>(false);
};

}  // namespace telar
