#pragma once

namespace telar {

/// Largest number that a half float holds.
constexpr float HALF_MAX = 65504.0f;

}  // namespace telar
