#include "frame/picture_facts.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace telar::frame {
namespace {

constexpr int DARK = 2, BRIGHT = 250;  ///< of 255: tone mapping approaches white and does not reach it
constexpr std::uint8_t WHOLE = 255;
constexpr double OPACITY_STEP = 1.0 / 255;  ///< what rounding may add to a shadow's alpha

glm::vec4 floatsAt(const Frame& frame, std::size_t pixel) {
  glm::vec4 rgba;
  std::memcpy(&rgba, &frame.pixels[pixel * sizeof rgba], sizeof rgba);
  return rgba;
}

const std::uint8_t* bytesOf(const Frame& frame) { return reinterpret_cast<const std::uint8_t*>(frame.pixels.data()); }

std::size_t texelsOf(const Frame& frame) { return std::size_t{frame.width} * frame.height; }

/// Counts of pixels by the ends that their channels are at.
struct Ends {
  std::size_t model = 0, dark = 0, bright = 0, saturated = 0;

  void add(int low, int high) {
    ++model;
    dark += static_cast<std::size_t>(low == 3), bright += static_cast<std::size_t>(high == 3);
    saturated += static_cast<std::size_t>(low + high == 3 && low > 0 && high > 0);
  }
};

/// Shadows up to this alpha; rounding may add a step to it.
double mostOfShadow(double groundOpacity) { return groundOpacity > 0 ? groundOpacity + OPACITY_STEP : 0; }

std::uint8_t coverageOf(const glm::vec4& pixel, double shadow) {
  const bool black = !(std::max({pixel.r, pixel.g, pixel.b}) > 0);
  if (black && pixel.a <= shadow) return 0;
  // What covers a pixel at all counts.
  return static_cast<std::uint8_t>(std::ceil(glm::clamp(pixel.a, 0.0f, 1.0f) * 255.0f));
}

}  // namespace

std::vector<std::uint8_t> coverageOf(const std::vector<glm::vec4>& pixels, double groundOpacity) {
  std::vector<std::uint8_t> coverage(pixels.size());
  const double shadow = mostOfShadow(groundOpacity);
  for (std::size_t i = 0; i < coverage.size(); ++i) coverage[i] = coverageOf(pixels[i], shadow);
  return coverage;
}

std::vector<std::uint8_t> coverageOf(const Frame& frame, double groundOpacity) {
  std::vector<std::uint8_t> coverage(texelsOf(frame));
  const double shadow = mostOfShadow(groundOpacity);
  if (frame.type == PixelType::kRgbaF32) {
    for (std::size_t i = 0; i < coverage.size(); ++i) coverage[i] = coverageOf(floatsAt(frame, i), shadow);
    return coverage;
  }
  const std::uint8_t* rgba = bytesOf(frame);
  for (std::size_t i = 0; i < coverage.size(); ++i, rgba += 4) {
    const bool black = (rgba[0] | rgba[1] | rgba[2]) == 0;
    coverage[i] = black && rgba[3] <= 255 * shadow ? std::uint8_t{0} : rgba[3];
  }
  return coverage;
}

void makeOpaque(Frame& frame) {
  if (frame.type == PixelType::kRgba8) {
    for (std::size_t i = 3; i < frame.pixels.size(); i += 4) frame.pixels[i] = std::byte{255};
    return;
  }
  constexpr float ONE = 1.0f;
  for (std::size_t i = 3 * sizeof ONE; i < frame.pixels.size(); i += 4 * sizeof ONE) {
    std::memcpy(&frame.pixels[i], &ONE, sizeof ONE);
  }
}

PictureFacts pictureFacts(const Frame& frame, const std::vector<std::uint8_t>& coverage) {
  const bool encoded = frame.type == PixelType::kRgba8;
  std::size_t covered = 0;
  Ends ends;
  for (std::size_t i = 0; i < coverage.size(); ++i) {
    covered += static_cast<std::size_t>(coverage[i] > 0);
    if (coverage[i] < WHOLE) continue;
    if (encoded) {
      const std::uint8_t* rgb = bytesOf(frame) + 4 * i;
      ends.add((rgb[0] <= DARK) + (rgb[1] <= DARK) + (rgb[2] <= DARK),
               (rgb[0] >= BRIGHT) + (rgb[1] >= BRIGHT) + (rgb[2] >= BRIGHT));
    } else {
      const glm::vec4 pixel = floatsAt(frame, i);
      ends.add(!(pixel.r > 0) + !(pixel.g > 0) + !(pixel.b > 0), 0);
    }
  }
  const auto part = [](std::size_t count, std::size_t of) {
    return of > 0 ? static_cast<double>(count) / static_cast<double>(of) : 0.0;
  };
  return {part(covered, coverage.size()), part(ends.dark, ends.model), part(ends.bright, ends.model),
          part(ends.saturated, ends.model)};
}

}  // namespace telar::frame
