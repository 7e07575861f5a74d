#pragma once
#include <chrono>
#include <functional>
#include <limits>
#include <vector>

#include "gl/functions.h"
#include "telar/cancel.h"

namespace telar::gl {

/// What fragments of one program cost on this machine: wall-clock nanoseconds, learned while they are drawn.
class DrawCost {
 public:
  /// @param weight  of the program against one that looks up a texture and a light or two
  explicit DrawCost(double weight = 1);

  double milliseconds(double fragments) const { return fragments * nanoseconds_ * 1e-6; }
  /// Fragments that are drawn in so many milliseconds.
  double fragments(double milliseconds) const { return milliseconds * 1e6 / nanoseconds_; }
  /// @param ratio  of what was measured to what was expected
  void learn(double ratio);

 private:
  double least_;  ///< nanoseconds that are always expected: what comes next may be dearer than all before
  double nanoseconds_;
};

/// Keeps what a GL has to do short: a software GL queues draws without end and drops none of them, so that a job could
/// be stopped only when all is drawn. Work is counted before it is drawn; where it would take longer than a slice, the
/// GL finishes what it has and the job's cancel token is looked at. Of pictures nothing changes.
class Pacer {
 public:
  /// @param gl  outlives it
  explicit Pacer(const Functions& gl) : gl_(gl) {}

  /// Another job begins.
  /// @param sliceMs  wall-clock time that the GL may have to do, about; infinity, as before the first job: no cuts
  void begin(const CancelToken& cancel, double sliceMs);

  double sliceMs() const { return sliceMs_; }

  /// Whether this beside what is queued stays within a slice.
  bool fits(const DrawCost& cost, double fragments) const {
    return queuedMs_ + cost.milliseconds(fragments) <= sliceMs_;
  }
  /// Whether this does alone.
  bool fitsAlone(const DrawCost& cost, double fragments) const { return cost.milliseconds(fragments) <= sliceMs_; }
  /// Counts what is drawn next. @param cost  lives until finish()
  void count(DrawCost& cost, double fragments);
  /// Waits until the GL has done everything, and learns from how long it took. @throws Error{X_CANCELLED, X_TIMEOUT}
  void finish();

  /// Pixels of the target.
  struct Rectangle {
    int x = 0, y = 0, width = 0, height = 0;
    double area() const { return static_cast<double>(width) * height; }
  };
  /// Draws at once, or one part of the target after another where that does not fit into a slice.
  /// @param fragments  that all of it may shade    @param draw  the same draw call each time
  void draw(DrawCost& cost, double fragments, const Rectangle& covered, const std::function<void()>& draw);

 private:
  using Clock = std::chrono::steady_clock;

  const Functions& gl_;
  CancelToken cancel_;
  double sliceMs_ = std::numeric_limits<double>::infinity();
  double queuedMs_ = 0;
  Clock::time_point since_;        ///< when what is queued was begun
  std::vector<DrawCost*> queued_;  ///< whose it is
};

}  // namespace telar::gl
