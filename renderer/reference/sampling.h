#pragma once
namespace telar::reference {

/// Weight of the first of two ways that drew one sample each.
/// src: Veach 1997, "Robust Monte Carlo Methods for Light Transport Simulation", eq. 9.13, the power heuristic
inline float powerHeuristic(float own, float other) {
  const float a = own * own, b = other * other;
  return a + b > 0 ? a / (a + b) : 0.0f;
}

}  // namespace telar::reference
