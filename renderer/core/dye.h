#pragma once
#include <glm/glm.hpp>

namespace telar {

/// What a cloth's colour leaves of a sheen that its preset gives for undyed fibres. Light that leaves near the ends of
/// fibres has crossed about half of the dye that diffuse light crosses: by Beer's law that is the square root
/// (reasoned). A floor of 0.001, blacker than cloth is dyed, lets another colour be asked for later.
/// @param color linear base colour
inline glm::vec3 sheenDye(const glm::vec3& color) { return glm::sqrt(glm::clamp(color, 0.001f, 1.0f)); }

/// What it leaves of light that passes through an undyed cloth: all that diffuse light crosses. The same floor.
inline glm::vec3 transmissionDye(const glm::vec3& color) { return glm::clamp(color, 0.001f, 1.0f); }

}  // namespace telar
