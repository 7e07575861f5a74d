#pragma once
#include <vector>

#include "telar/image.h"
#include "telar/shot.h"

namespace telar::pass {

/// Mean radiance to an encoded colour: exposure, tone mapping, sRGB.
class PixelEncoder {
 public:
  explicit PixelEncoder(const Shot& shot);
  /// @param pixel  linear Rec.709, premultiplied with coverage, and coverage
  /// @return colour, 0 or more, 1 = white, and coverage
  glm::vec4 operator()(const glm::vec4& pixel) const;

 private:
  glm::vec3 (*toneMap_)(glm::vec3, float);
  float exposure_;
};

/// Mean radiance to pixels by the same text as the raster's: exposure, tone mapping, sRGB, background.
/// @param pixels  row 0 on top; linear Rec.709, premultiplied with coverage, and coverage
Frame toFrame(const std::vector<glm::vec4>& pixels, const Shot& shot);

}  // namespace telar::pass
