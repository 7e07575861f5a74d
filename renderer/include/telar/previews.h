#pragma once
#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include "telar/image.h"

namespace telar {

/// A picture as far as it is drawn.
struct Preview {
  Frame frame;      ///< as the finished one, without layers
  int samples = 0;  ///< of the pixel that has taken most
};

/// The last preview of a job: put by the thread that draws, taken by whoever waits.
class Previews {
 public:
  /// From now on the job makes previews. Without this it spends no time on them.
  void ask() const { state_->asked = true; }
  bool asked() const { return state_->asked; }
  /// Replaces one that was not taken.
  void put(Preview preview) const {
    const std::lock_guard lock(state_->mutex);
    state_->last = std::move(preview);
  }
  std::optional<Preview> take() const {
    const std::lock_guard lock(state_->mutex);
    return std::exchange(state_->last, std::nullopt);
  }

 private:
  struct State {
    std::atomic<bool> asked = false;
    std::mutex mutex;
    std::optional<Preview> last;
  };
  std::shared_ptr<State> state_ = std::make_shared<State>();
};

}  // namespace telar
