#pragma once
#include <cstdint>
#include <vector>

#include "visibility/memory.h"
#include "visibility/window_triangle.h"

namespace telar::visibility {

/// A sample of a pixel.
struct Sample {
  int x, y;  ///< of the pixel
  int place;
};

/// For each sample of a part of the window a depth behind which nothing is seen, for there is a triangle in front.
class SampleDepth {
 public:
  /// Opens all samples. @param part  what may be covered; all else stays open
  void begin(const SampleGrid& grid, const Pixels& part);

  /// Takes the samples that the GL certainly covers with it. @pre add() comes before close()
  /// @param[out] edge  samples so near to an edge that the triangle alone is not sure to cover them; and some others
  /// @param[in,out] steps  increased by the pixels that it looked at, as in all below
  void add(const WindowTriangle& triangle, std::vector<Sample>& edge, std::int64_t& steps);
  /// Takes one sample.
  void add(const Sample& sample, float depth);
  /// Where it is in the window, px.
  glm::vec2 placeOf(const Sample& sample) const;
  /// Finds the farthest depth of each block of pixels.
  void close();

  /// Whether all samples in these pixels have something in front of this depth. A quick look: it may say no where the
  /// answer is yes.
  bool covers(const Pixels& pixels, float depth, std::int64_t& steps) const;
  /// Whether at every sample where the GL may see this triangle there is something in front of it.
  bool hides(const WindowTriangle& triangle, std::int64_t& steps) const;

  std::size_t memory() const { return bytesOf(depths_) + bytesOf(farthest_); }

 private:
  static constexpr int BLOCK = 8;  ///< px, a side

  bool contains(const Pixels& pixels) const;
  std::size_t indexOf(int x, int y) const {
    return static_cast<std::size_t>(y - part_.fromY) * stride_ + static_cast<std::size_t>(x - part_.fromX) * SAMPLES;
  }
  float* pixelOf(int x, int y) { return depths_.data() + indexOf(x, y); }
  const float* pixelOf(int x, int y) const { return depths_.data() + indexOf(x, y); }

  SampleGrid grid_;
  Pixels part_{0, -1, 0, -1};  ///< begins at whole blocks
  std::size_t stride_ = 0;     ///< floats from one row to the next
  std::size_t columns_ = 0;    ///< of blocks
  std::vector<float> depths_, farthest_;
};

}  // namespace telar::visibility
