#pragma once
#include <atomic>
#include <memory>

#include "telar/error.h"

namespace telar {

/// Shared flag by which the caller stops a job. Every stage calls check() at least each few milliseconds of work.
class CancelToken {
 public:
  void cancel() const { flag_->store(true, std::memory_order_relaxed); }
  bool cancelled() const { return flag_->load(std::memory_order_relaxed); }
  /// @throws Error{X_CANCELLED}
  void check() const {
    if (cancelled()) throw Error("X_CANCELLED", "the caller cancelled this job");
  }

 private:
  std::shared_ptr<std::atomic<bool>> flag_ = std::make_shared<std::atomic<bool>>(false);
};

}  // namespace telar
