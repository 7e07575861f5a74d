#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "telar/image.h"
#include "telar/picture_facts.h"

namespace telar::frame {

/// Coverage of each pixel by the model, 0..255, from the alpha of a frame that no background was drawn into.
/// @param groundOpacity  of shadows on the ground that wrote alpha too: black up to this alpha counts as one; 0 = none
std::vector<std::uint8_t> coverageOf(const Frame& frame, double groundOpacity);
/// Same of a float frame's pixels.
std::vector<std::uint8_t> coverageOf(const std::vector<glm::vec4>& pixels, double groundOpacity);

/// Alpha 1 everywhere: the frame has a background.
void makeOpaque(Frame& frame);

/// @param coverage  of coverageOf(), as large as the frame
PictureFacts pictureFacts(const Frame& frame, const std::vector<std::uint8_t>& coverage);

}  // namespace telar::frame
