#include "gl/pacer.h"

#include <algorithm>

namespace telar::gl {
namespace {

// A new program is taken for slow until it was measured: its first slices are short.
constexpr double UNKNOWN_NS = 500;
// llvmpipe on two cores takes 50 to 150 ns for a fragment of cloth, and next to nothing for one that is hidden. Were
// that expected of the next one too, the next slice might last for seconds.
constexpr double LEAST_NS = 10;
// A slice may be slower than the one before for other reasons than its fragments: a program that the driver compiles
// when it first draws, another process.
constexpr double MOST_RISE = 4, MOST_FALL = 0.5;

// llvmpipe shades tiles of so many pixels on a side.
constexpr int TILE = 64;

/// What lies outside of the scissor rectangle is not drawn while this lives.
class Scissoring {
 public:
  explicit Scissoring(const Functions& gl) : gl_(gl) { gl_.Enable(GL_SCISSOR_TEST); }
  ~Scissoring() { gl_.Disable(GL_SCISSOR_TEST); }
  Scissoring(const Scissoring&) = delete;
  Scissoring& operator=(const Scissoring&) = delete;

 private:
  const Functions& gl_;
};

/// Pixels rounded down to whole tiles, at least one and at most so many.
int tiles(double pixels, int most) {
  const double whole = std::clamp(pixels / TILE, 1.0, 1.0 * most);
  return static_cast<int>(whole) * TILE;
}

}  // namespace

DrawCost::DrawCost(double weight) : least_(LEAST_NS * weight), nanoseconds_(UNKNOWN_NS * weight) {}

void DrawCost::learn(double ratio) {
  nanoseconds_ = std::max(least_, nanoseconds_ * std::clamp(ratio, MOST_FALL, MOST_RISE));
}

void Pacer::begin(const CancelToken& cancel, double sliceMs) {
  cancel_ = cancel;
  sliceMs_ = sliceMs;
  queuedMs_ = 0;
  queued_.clear();
}

void Pacer::count(DrawCost& cost, double fragments) {
  if (queued_.empty()) since_ = Clock::now();
  queuedMs_ += cost.milliseconds(fragments);
  if (std::find(queued_.begin(), queued_.end(), &cost) == queued_.end()) queued_.push_back(&cost);
}

void Pacer::finish() {
  gl_.Finish();
  if (queuedMs_ > 0) {
    const double took = std::chrono::duration<double, std::milli>(Clock::now() - since_).count();
    for (DrawCost* cost : queued_) cost->learn(took / queuedMs_);
  }
  queuedMs_ = 0;
  queued_.clear();
  cancel_.check();
}

void Pacer::draw(DrawCost& cost, double fragments, const Rectangle& covered, const std::function<void()>& draw) {
  if (!fits(cost, fragments) && !queued_.empty()) finish();
  if (fitsAlone(cost, fragments)) {
    count(cost, fragments);
    draw();
    return;
  }
  const Scissoring scissoring(gl_);
  const int right = covered.x + covered.width, top = covered.y + covered.height;
  for (int y = covered.y; y < top;) {
    const double rows = cost.fragments(sliceMs_) / covered.width;
    const int height = std::min(tiles(rows, (covered.height + TILE - 1) / TILE), top - y);
    for (int x = covered.x; x < right;) {
      const double columns = cost.fragments(sliceMs_) / height;
      const int width = std::min(tiles(columns, (covered.width + TILE - 1) / TILE), right - x);
      gl_.Scissor(x, y, width, height);
      count(cost, std::min(fragments, Rectangle{x, y, width, height}.area()));
      draw();
      x += width;
      finish();
    }
    y += height;
  }
}

}  // namespace telar::gl
