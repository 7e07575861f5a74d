#pragma once
#include <glm/glm.hpp>

namespace telar {

/// Relative luminance of linear Rec.709.
inline float luminance(const glm::vec3& color) { return 0.2126f * color.r + 0.7152f * color.g + 0.0722f * color.b; }
inline double luminance(const glm::dvec3& color) { return 0.2126 * color.r + 0.7152 * color.g + 0.0722 * color.b; }

/// Whether a light of this colour and intensity gives any: what single precision has none left of is dark.
inline bool shines(const glm::vec3& color, double intensity) {
  return glm::vec3(glm::dvec3(color) * intensity) != glm::vec3(0);
}

}  // namespace telar
