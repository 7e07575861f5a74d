#include "reference/texture_read.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/packing.hpp>

#include "brdf/brdf.h"
#include "core/prefetch.h"
#include "core/unaligned.h"
#include "telar/error.h"

namespace telar::reference {
namespace {

/// The texels on both sides of a place, and how far it is from the first to the second.
struct Taps {
  std::size_t low, high;
  float part;
};

std::size_t wrapped(std::int64_t i, std::int64_t size, std::uint32_t mode) {
  if (mode == telar::Sampler::CLAMP_TO_EDGE) return static_cast<std::size_t>(std::clamp<std::int64_t>(i, 0, size - 1));
  const std::int64_t period = mode == telar::Sampler::MIRRORED_REPEAT ? 2 * size : size;
  const std::int64_t at = i < 0 ? i + period : i >= period ? i - period : i;
  return static_cast<std::size_t>(at >= size ? period - 1 - at : at);
}

/// std::floor() calls libm on processors that telar is compiled for. @param x  within the range of the result
std::int64_t floorOf(double x) {
  const auto i = static_cast<std::int64_t>(x);
  return i - (x < static_cast<double>(i) ? 1 : 0);
}

/// Where a coordinate stands among texels, wrapped to within one of the map (two of a mirrored one): a division of
/// whole numbers for each texel would take longer than the reads.
double placeOf(float coordinate, std::uint32_t size, std::uint32_t mode) {
  const double c = coordinate;
  if (mode == telar::Sampler::CLAMP_TO_EDGE) return std::clamp(c, -1.0, 2.0) * size;
  if (mode == telar::Sampler::MIRRORED_REPEAT) return (c - static_cast<double>(floorOf(c / 2)) * 2) * size;
  return (c - static_cast<double>(floorOf(c))) * size;
}

Taps tapsOf(float coordinate, std::uint32_t size, std::uint32_t mode) {
  const double place = placeOf(coordinate, size, mode) - 0.5;
  const std::int64_t low = floorOf(place);
  return {wrapped(low, size, mode), wrapped(low + 1, size, mode), static_cast<float>(place - static_cast<double>(low))};
}

std::size_t nearestOf(float coordinate, std::uint32_t size, std::uint32_t mode) {
  return wrapped(floorOf(placeOf(coordinate, size, mode)), size, mode);
}

struct TexelReader {
  const Image8& image;
  const std::array<float, 256>& colours;
  const std::array<float, 256>& alphas;

  glm::vec4 texel(std::size_t x, std::size_t y) const {
    const std::uint8_t* p = &image.pixels[(y * image.width + x) * texelBytes(image.type)];
    if (image.type == TexelType::kByte) return {colours[p[0]], colours[p[1]], colours[p[2]], alphas[p[3]]};
    if (image.type == TexelType::kHalf) return glm::unpackHalf4x16(loadUnaligned<std::uint64_t>(p));
    return loadUnaligned<glm::vec4>(p);
  }
};

}  // namespace

Textures::Textures(const Scene& scene) : scene_(scene) {
  for (const Image8& image : scene.images) {
    if (image.type != TexelType::kBlocks) continue;
    throw Error("E_IMAGE_FORMAT",
                "the image is " + image.format +
                    ", blocks that only a GPU reads; for quality \"reference\" use a texture in PNG, or "
                    "KTX2 in ETC1S or UASTC");
  }
  for (std::size_t i = 0; i < bytes_.size(); ++i) {
    bytes_[i] = static_cast<float>(i) / 255.0f;
    linear_[i] = brdf_f::linearFromSrgb(glm::vec3(bytes_[i])).x;
  }
}

glm::vec4 Textures::read(const TextureRef& texture, const glm::vec2& uv, bool srgb, bool byAlpha) const {
  if (!texture) return glm::vec4(1.0f);
  const Image8& image = scene_.images[static_cast<std::size_t>(texture.image)];
  if (image.pixels.empty()) return glm::vec4(1.0f);
  const glm::vec3 moved = texture.uvTransform * glm::vec3(uv, 1.0f);
  // Far outside of [0, 1] a float has no fraction to filter with, and an integer may not hold it.
  if (!(std::abs(moved.x) < 1e9f && std::abs(moved.y) < 1e9f)) return glm::vec4(1.0f);
  const TexelReader reader{image, decodesSrgb(image.coding, srgb) ? linear_ : bytes_, bytes_};
  const telar::Sampler& sampler = texture.sampler;
  if (sampler.magFilter == telar::Sampler::NEAREST) {
    return reader.texel(nearestOf(moved.x, image.width, sampler.wrapS),
                        nearestOf(moved.y, image.height, sampler.wrapT));
  }
  const Taps x = tapsOf(moved.x, image.width, sampler.wrapS), y = tapsOf(moved.y, image.height, sampler.wrapT);
  const auto mean = [&](const auto& texel) {
    return glm::mix(glm::mix(texel(x.low, y.low), texel(x.high, y.low), x.part),
                    glm::mix(texel(x.low, y.high), texel(x.high, y.high), x.part), y.part);
  };
  if (!byAlpha) return mean([&reader](std::size_t column, std::size_t row) { return reader.texel(column, row); });
  const glm::vec4 color = mean([&reader](std::size_t column, std::size_t row) {
    const glm::vec4 texel = reader.texel(column, row);
    return glm::vec4(glm::vec3(texel) * texel.a, texel.a);
  });
  return {glm::vec3(color) / std::max(color.a, 1.0f / 512.0f), color.a};
}

void Textures::prefetch(const TextureRef& texture, const glm::vec2& uv) const {
  if (!texture) return;
  const Image8& image = scene_.images[static_cast<std::size_t>(texture.image)];
  const glm::vec3 moved = texture.uvTransform * glm::vec3(uv, 1.0f);
  if (image.pixels.empty() || !(std::abs(moved.x) < 1e9f && std::abs(moved.y) < 1e9f)) return;
  // Of both rows that are read, the first texel: the second mostly lies beside it.
  const Taps x = tapsOf(moved.x, image.width, texture.sampler.wrapS),
             y = tapsOf(moved.y, image.height, texture.sampler.wrapT);
  for (const std::size_t row : {y.low, y.high})
    telar::prefetch(&image.pixels[(row * image.width + x.low) * texelBytes(image.type)]);
}

}  // namespace telar::reference
