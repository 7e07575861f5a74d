#pragma once
#include <atomic>
#include <chrono>
#include <memory>
#include <optional>

#include "telar/error.h"

namespace telar {

/// Stops a job: when its caller cancels it, or when it has worked longer than allowed. Every stage calls check() after
/// at most a few milliseconds of work. All copies of a token act as one.
class CancelToken {
  using Clock = std::chrono::steady_clock;
  static constexpr Clock::time_point NEVER = Clock::time_point::max();

  struct State {
    std::atomic<bool> cancelled = false;
    std::atomic<Clock::time_point> deadline = NEVER;  ///< while a thread works on the job
    std::optional<Clock::duration> allowed;  ///< for the whole job; none = any time. Of one thread at a time, as `used`
    Clock::duration used{};
  };

 public:
  CancelToken() = default;
  /// @param allowed  wall-clock time that threads may work on the job; waiting for its turn does not count
  explicit CancelToken(std::chrono::milliseconds allowed) { state_->allowed = allowed; }

  void cancel() const { state_->cancelled.store(true, std::memory_order_relaxed); }
  bool cancelled() const { return state_->cancelled.load(std::memory_order_relaxed); }
  /// Whether check() would throw: for those who must not.
  bool isOver() const { return cancelled() || isLate(); }
  /// @throws Error{X_CANCELLED, X_TIMEOUT}
  void check() const {
    if (cancelled()) throw Error("X_CANCELLED", "the caller cancelled this job");
    if (isLate()) throw timeout();
  }
  /// The job may take any time from here on. To be called while no Work lives.
  void allowAnyTime() const { state_->allowed.reset(); }

  /// Counts the time that a thread works on the job, while this lives.
  class Work {
   public:
    explicit Work(const CancelToken& token) : state_(token.state_), begin_(Clock::now()) {
      if (state_->allowed) state_->deadline = begin_ + (*state_->allowed - state_->used);
    }
    ~Work() {
      state_->used += Clock::now() - begin_;
      state_->deadline = NEVER;
    }
    Work(const Work&) = delete;
    Work& operator=(const Work&) = delete;

   private:
    const std::shared_ptr<State> state_;
    const Clock::time_point begin_;
  };

 private:
  bool isLate() const {
    const Clock::time_point deadline = state_->deadline.load(std::memory_order_relaxed);
    return deadline != NEVER && Clock::now() > deadline;
  }

  Error timeout() const {
    const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(*state_->allowed).count();
    return {"X_TIMEOUT", "the work took longer than the " + std::to_string(ms) +
                             " ms that timeoutMs allows; reduce the model, the size or the quality, or allow more"};
  }

  std::shared_ptr<State> state_ = std::make_shared<State>();
};

}  // namespace telar
