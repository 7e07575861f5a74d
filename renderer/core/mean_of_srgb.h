#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>

#include "telar/image.h"

namespace telar {

/// Linear light of a byte that is coded as sRGB (IEC 61966-2-1).
inline double lightOfSrgb(std::size_t code) {
  const double c = static_cast<double>(code) / 255;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

/// Mean of the texels of a picture that is coded as sRGB (IEC 61966-2-1): linear Rec.709, exact, where a mip level has
/// lost up to 1/255 of brightness to rounding.
/// @param counts  what a texel counts, by the code of its alpha
/// @return none where the texels are no bytes, or none counts
inline std::optional<glm::dvec3> meanOfSrgb(const Image8& image, const std::array<std::uint8_t, 256>& counts) {
  if (image.type != TexelType::kByte || image.pixels.empty()) return std::nullopt;
  std::array<std::array<std::uint64_t, 3>, 256> weights{};  // of texels of a code, by channel
  for (std::size_t i = 0; i + 3 < image.pixels.size(); i += 4) {
    for (std::size_t channel = 0; channel < 3; ++channel) {
      weights[image.pixels[i + channel]][channel] += counts[image.pixels[i + 3]];
    }
  }
  glm::dvec4 sum(0);
  for (std::size_t code = 0; code < weights.size(); ++code) {
    const auto& [red, green, blue] = weights[code];
    const double light = lightOfSrgb(code);
    sum += glm::dvec4(light * static_cast<double>(red), light * static_cast<double>(green),
                      light * static_cast<double>(blue), red);
  }
  if (sum.w <= 0) return std::nullopt;
  return glm::dvec3(sum) / sum.w;
}

/// @param byAlpha  texels count by their alpha, 0..1
inline std::optional<glm::dvec3> meanOfSrgb(const Image8& image, bool byAlpha) {
  std::array<std::uint8_t, 256> counts{};
  for (std::size_t code = 0; code < counts.size(); ++code) counts[code] = byAlpha ? static_cast<std::uint8_t>(code) : 1;
  return meanOfSrgb(image, counts);
}

}  // namespace telar
