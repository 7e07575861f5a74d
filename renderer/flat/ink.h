#pragma once
#include <vector>

#include "flat/flat.h"

namespace telar::flat {

/// A picture that lines are drawn on, antialiased: how dark a pixel is, is the part of its width that the line covers
/// across, which is exact where the line is straight and longer than a pixel.
class Paper {
 public:
  Paper(int width, int height)
      : width_(width), height_(height), ink_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

  /// @param weight  pixels; 0 draws nothing. Round ends and joints; a stitch is dashed and its dashes end square
  void draw(const Stroke& stroke, double weight);

  /// 1 less the ink: row 0 on top.
  std::vector<float> brightness() const;

 private:
  void segment(const glm::dvec2& a, const glm::dvec2& b, double weight, bool round);

  int width_, height_;
  std::vector<float> ink_;
};

}  // namespace telar::flat
