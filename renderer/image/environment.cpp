#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>

#include "image/environment_header.h"
#include "image/exr_chunks.h"
#include "image/exr_header.h"
#include "image/oiio_bridge.h"
#include "image/radiance_decode.h"

namespace telar {
namespace {

constexpr float FULL_MAX = 1e20f;  // sums over a sphere, and what they are multiplied with, stay finite
constexpr float HALF_NORMAL_MIN = 0x1p-14f;
constexpr float HALF_STEP_MIN = 0x1p-24f;
constexpr std::size_t TEXELS_PER_STEP = 1 << 20;  // between two looks at the cancel token

/// RGBE is mantissa / 256, which three.js takes as mantissa / 255. Both are one product in double here and in three.js,
/// with factors that differ by a power of two, so the rounded results are equal bit for bit.
float rescaleRgbe(float value) { return float(double(value) * (256.0 / 255.0)); }

/// Largest half not above `value` in [0, 65504]: three.js drops the bits that a half has no room for.
float truncateToHalf(float value) {
  if (value < HALF_NORMAL_MIN) return std::floor(value / HALF_STEP_MIN) * HALF_STEP_MIN;
  return std::bit_cast<float>(std::bit_cast<std::uint32_t>(value) & 0xffffe000u);
}

/// NaN becomes 0. Infinity says no more than that a half did not hold it.
float clamped(float value, float most) {
  if (!(value > 0)) return 0;
  if (std::isinf(value)) return HALF_MAX;
  return value < HALF_MAX ? truncateToHalf(value) : std::min(value, most);
}

/// Cubes and atlases are as large as one side of a map asks for, however short the other is: a map costs what one twice
/// as wide as high costs that has its longer side.
void checkSize(const image::EnvironmentHeader& header, const Limits& limits) {
  const double width = header.width, height = header.height, most = double(limits.environmentPixels);
  checkLimit("L_ENVIRONMENT_PIXELS", most, width * height);
  const double wide = std::max(width, 2 * height), cost = wide * wide / 2;
  if (cost <= most) return;
  const auto text = [](double x) { return std::to_string(static_cast<std::uint64_t>(x)); };
  throw Error("L_ENVIRONMENT_PIXELS", "L_ENVIRONMENT_PIXELS: an environment of " + text(width) + " x " + text(height) +
                                          " pixels costs as much as one of " + text(wide) + " x " + text(wide / 2) +
                                          ": " + text(cost) + " is over the limit of " + text(most) +
                                          "; give a smaller map, or raise this limit for files that you trust")
      .withLimit("L_ENVIRONMENT_PIXELS", most, cost);
}

}  // namespace

ImageF readEnvironment(std::span<const std::byte> file, const Limits& limits, const CancelToken& cancel,
                       EnvironmentRange range) {
  cancel.check();
  const image::EnvironmentHeader header = image::readEnvironmentHeader(file);
  checkSize(header, limits);
  const bool rgbe = header.format == image::EnvironmentFormat::kHdr;
  if (!rgbe) image::checkExrChunks(file, image::readExrHeader(file), cancel);
  ImageF out =
      rgbe ? image::decodeRadiance(file, header, cancel) : image::readExr(file, header.width, header.height, cancel);

  const float most = range == EnvironmentRange::kFull ? FULL_MAX : HALF_MAX;
  for (std::size_t i = 0; i < out.pixels.size(); i += 4) {
    if (i % (TEXELS_PER_STEP * 4) == 0) cancel.check();
    for (std::size_t c = i; c < i + 3; ++c) {
      out.pixels[c] = clamped(rgbe ? rescaleRgbe(out.pixels[c]) : out.pixels[c], most);
    }
    out.pixels[i + 3] = 1;
  }
  return out;
}

}  // namespace telar
