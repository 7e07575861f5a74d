#pragma once
#include <vector>

#include "telar/image.h"
#include "telar/shot.h"

namespace telar::pass {

/// Mean radiance to pixels by the same text as the raster's: exposure, tone mapping, sRGB, background.
/// @param pixels  row 0 on top; linear Rec.709, premultiplied with coverage, and coverage
Frame toFrame(const std::vector<glm::vec4>& pixels, const Shot& shot);

}  // namespace telar::pass
