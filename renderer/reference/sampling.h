#pragma once
#include <glm/glm.hpp>

/// Directions drawn where no lobe is, and what samples of two ways count for. Those of the lobes are in
/// shaders/brdf/importance.glsl.
namespace telar::reference {

/// A unit direction, all as likely. @param u  [0, 1)^2
glm::vec3 sampleSphere(const glm::vec2& u);
constexpr float PDF_SPHERE = 0.079577472f;  ///< 1 / (4 pi), per steradian

/// Weight of the first of two ways that drew one sample each.
/// src: Veach 1997, "Robust Monte Carlo Methods for Light Transport Simulation", eq. 9.13, the power heuristic
inline float powerHeuristic(float own, float other) {
  const float a = own * own, b = other * other;
  return a + b > 0 ? a / (a + b) : 0.0f;
}

}  // namespace telar::reference
