#pragma once
#include <vector>

#include "telar/image.h"
#include "telar/shot.h"

namespace telar::frame {

/// Mean radiance to an encoded colour: exposure, tone mapping, sRGB.
class PixelEncoder {
 public:
  using ToneMap = glm::vec3 (*)(glm::vec3 radiance, float exposure);

  explicit PixelEncoder(const Shot& shot);
  /// @param pixel  linear Rec.709, premultiplied with coverage, and coverage
  /// @return colour, 0 or more, 1 = white, and coverage
  glm::vec4 operator()(const glm::vec4& pixel) const;

 private:
  ToneMap toneMap_;
  float exposure_;
};

/// Mean radiance to pixels by the same text as the raster's: exposure, tone mapping, sRGB, background.
/// @param pixels  row 0 on top; linear Rec.709, premultiplied with coverage, and coverage
Frame toFrame(const std::vector<glm::vec4>& pixels, const Shot& shot);

}  // namespace telar::frame
