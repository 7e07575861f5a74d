#pragma once
#include <span>
#include <vector>

#include "telar/image.h"
#include "telar/shot.h"

namespace telar::pass {

/// The mean of passes over a picture, of which a pixel takes no more once it is sure enough.
class PixelMean {
 public:
  /// Passes between two looks at how sure the pixels are.
  static constexpr int ROUND = 8;

  /// @param shot  its size, output and noise
  explicit PixelMean(const Shot& shot);

  /// Adds a pass to the pixels that are not settled. @param frame  kRgbaF32 of the shot's size
  void add(const Frame& frame);

  /// After every ROUND passes: settles the pixels whose standard error, pooled with their neighbours', is Shot::noise
  /// or less. @return whether any is left; always with noise 0
  bool settle();

  /// Which pixels are settled: 255 or 0, row 0 on top. Empty before the first is.
  std::span<const std::uint8_t> settled() const { return settled_; }

  /// The picture. Row 0 on top; linear Rec.709, premultiplied with coverage, and coverage.
  std::vector<glm::vec4> mean() const;
  /// Passes that a pixel has taken, the mean of all pixels.
  double meanCount() const;

 private:
  /// Sums over rounds of a pixel's encoded luma, before black and before white.
  struct Spread {
    glm::vec2 sum{0}, squares{0};
    float variance(int rounds) const;
  };
  Shot shot_;
  int rounds_ = 0;
  std::vector<glm::vec4> sum_, round_;
  std::vector<std::uint16_t> count_;
  std::vector<Spread> spreads_;   // none with noise 0
  std::vector<float> variances_;  // of the mean, in encoded values squared
  std::vector<std::uint8_t> settled_;
};

}  // namespace telar::pass
