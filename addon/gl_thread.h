#pragma once
#include <functional>
#include <memory>

#include "task_threads.h"
#include "telar/renderer.h"

namespace telar::addon {

/// One renderer and the thread that its GL context is current on: made, used and destroyed there.
class GlThread {
 public:
  using Task = std::function<void(std::unique_ptr<Renderer>&)>;

  /// @param onExit run by the thread after the renderer is destroyed
  GlThread(std::size_t maxQueued, std::function<void()> onExit)
      : GlThread(std::make_shared<Slot>(), maxQueued, std::move(onExit)) {}

  /// The first task makes the renderer, later ones use it. @return false: the queue is full, or the thread is ending
  bool post(Task task) { return thread_.post(bind(std::move(task))); }

  /// Ends the thread after what waits and `last`. @return false: it was ending already, `last` will not run
  bool finish(Task last) { return thread_.finish(bind(std::move(last))); }
  void finish() { thread_.finish(); }
  void abandon() { thread_.abandon(); }
  bool join(std::chrono::steady_clock::time_point deadline) { return thread_.join(deadline); }

 private:
  struct Slot {
    std::unique_ptr<Renderer> renderer;  // touched by the thread only
  };

  GlThread(const std::shared_ptr<Slot>& slot, std::size_t maxQueued, std::function<void()> onExit)
      : slot_(slot), thread_(1, maxQueued, [slot, onExit = std::move(onExit)] {
          slot->renderer.reset();
          onExit();
        }) {}

  TaskThreads::Task bind(Task task) const {
    return [slot = slot_, task = std::move(task)] { task(slot->renderer); };
  }

  std::shared_ptr<Slot> slot_;
  TaskThreads thread_;
};

}  // namespace telar::addon
