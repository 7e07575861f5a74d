#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "telar/image.h"
#include "telar/picture_facts.h"

namespace telar::frame {

/// How much of each pixel the model covers, 0..255, by alpha: of a frame whose alpha no background has written.
/// @param groundOpacity  of shadows on the ground that wrote alpha too: black up to this alpha counts as one; 0 = none
std::vector<std::uint8_t> coverageOf(const Frame& frame, double groundOpacity);
/// Same of a float frame's pixels.
std::vector<std::uint8_t> coverageOf(const std::vector<glm::vec4>& pixels, double groundOpacity);

/// Alpha 1 everywhere: the frame has a background.
void makeOpaque(Frame& frame);

/// @param coverage  of coverageOf(), as large as the frame
PictureFacts pictureFacts(const Frame& frame, const std::vector<std::uint8_t>& coverage);

}  // namespace telar::frame
