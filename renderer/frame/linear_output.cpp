#include "frame/linear_output.h"

#include <cmath>
#include <cstring>

#include "brdf/brdf.h"

namespace telar::frame {
namespace {

PixelEncoder::ToneMap toneMapOf(ToneMapping toneMapping, const ThreeTerms& three) {
  const bool white = three.neutralToneMapping == ThreeTerms::THREE_NEUTRAL_TONE_MAPPING_WHITE;
  if (white && toneMapping == ToneMapping::kNeutral) return brdf_f::toneMapNeutralWhite;
  switch (toneMapping) {
    case ToneMapping::kNone:
      break;
#define TELAR_TONE_MAP(name, function, three) \
  case ToneMapping::name:                     \
    return brdf_f::function;
      TELAR_TONE_MAPPINGS(TELAR_TONE_MAP)
#undef TELAR_TONE_MAP
  }
  return [](glm::vec3 color, float) { return color; };
}

std::byte byteOf(float x) { return static_cast<std::byte>(std::lround(glm::clamp(x, 0.0f, 1.0f) * 255.0f)); }

}  // namespace

PixelEncoder::PixelEncoder(const Shot& shot)
    : toneMap_(toneMapOf(shot.toneMapping, shot.three)), exposure_(static_cast<float>(shot.exposure)) {}

glm::vec4 PixelEncoder::operator()(const glm::vec4& pixel) const {
  const glm::vec3 radiance = pixel.a > 0 ? glm::vec3(pixel) / pixel.a : glm::vec3(0);
  return {brdf_f::srgbFromLinear(glm::max(toneMap_(radiance, exposure_), 0.0f)), pixel.a};
}

Frame toFrame(const std::vector<glm::vec4>& pixels, const Shot& shot) {
  Frame frame{
      static_cast<std::uint32_t>(shot.width), static_cast<std::uint32_t>(shot.height), framePixelType(shot.output), {}};
  const auto exposure = static_cast<float>(shot.exposure);
  const bool colour = shot.background.type == Shot::Background::Type::kColor;
  if (frame.type == PixelType::kRgbaF32) {
    frame.pixels.resize(pixels.size() * sizeof(glm::vec4));
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      glm::vec4 out(glm::clamp(glm::vec3(pixels[i]) * exposure, 0.0f, brdf_f::RADIANCE_MAX), pixels[i].a);
      if (colour) out = glm::vec4(glm::vec3(out) + shot.background.color * (1 - out.a), 1.0f);
      std::memcpy(&frame.pixels[i * sizeof out], &out, sizeof out);
    }
    return frame;
  }
  const PixelEncoder encoder(shot);
  const glm::vec3 behind = brdf_f::srgbFromLinear(glm::clamp(shot.background.color, 0.0f, 1.0f));
  frame.pixels.resize(pixels.size() * 4);
  const glm::vec4 nothing = encoder(glm::vec4(0));
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const glm::vec4 pixel = pixels[i] == glm::vec4(0) ? nothing : encoder(pixels[i]);
    glm::vec3 encoded(pixel);
    float coverage = pixel.a;
    if (colour) {
      // Encoded values are blended, as the browser's drawing buffer does.
      encoded = glm::mix(behind, glm::clamp(encoded, 0.0f, 1.0f), coverage);
      coverage = 1;
    }
    for (int c = 0; c < 3; ++c) frame.pixels[i * 4 + static_cast<std::size_t>(c)] = byteOf(encoded[c]);
    frame.pixels[i * 4 + 3] = byteOf(coverage);
  }
  return frame;
}

}  // namespace telar::frame
