#pragma once
#include <atomic>
#include <ctime>
#include <limits>
#include <memory>

#include "telar/previews.h"

namespace telar {

/// How far a job is: set by the threads that do it, read by whoever waits. And when its picture is good enough before
/// all samples are taken.
class Progress {
 public:
  /// @param part  0..1; one that is below what was said before changes nothing
  void reach(float part) const {
    float said = state_->part.load(std::memory_order_relaxed);
    while (said < part && !state_->part.compare_exchange_weak(said, part, std::memory_order_relaxed)) {
    }
  }
  float part() const { return state_->part.load(std::memory_order_relaxed); }

  /// From now on the picture as it is will do: no pass follows, and none that has begun need end.
  void settle() const { state_->enough = true; }
  /// The same once this process has worked so long on the picture. @param ms  CPU milliseconds, all threads together
  void allowCpu(double ms) const { state_->allowedMs = ms; }
  bool isCpuAllowed() const { return state_->allowedMs < NEVER; }
  /// The same where the standard error is no more than this: a matter of the picture alone.
  /// @param error  PixelMean::standardError()
  void allowError(double error) const { state_->allowedError = error; }
  bool isErrorAllowed() const { return state_->allowedError > 0; }

  /// The drawing begins: its CPU time counts from here.
  void begin() const { state_->begun = cpuMs(); }
  /// CPU milliseconds of this process since then; what else it does meanwhile counts too.
  double spentMs() const { return cpuMs() - state_->begun; }

  bool isEnough() const { return state_->enough || (isCpuAllowed() && spentMs() >= state_->allowedMs); }
  /// The same, at a standard error.
  bool isEnough(double standardError) const { return isEnough() || standardError <= state_->allowedError; }
  /// Whether the picture may end before its last sample, by more than a signal.
  bool mayEnd() const { return isCpuAllowed() || isErrorAllowed(); }

  Previews previews;

 private:
  static constexpr double NEVER = std::numeric_limits<double>::infinity();
  static double cpuMs() { return 1000.0 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

  struct State {
    std::atomic<float> part = 0.0f;
    std::atomic<bool> enough = false;
    std::atomic<double> allowedMs = NEVER, allowedError = 0.0, begun = 0.0;
  };
  std::shared_ptr<State> state_ = std::make_shared<State>();
};

/// How the drawing of a picture ended.
struct Ending {
  bool early = false;  ///< before its last sample, for it was enough as it was
  double standardError = std::numeric_limits<double>::infinity();  ///< PixelMean; infinity = nobody looked
};

}  // namespace telar
