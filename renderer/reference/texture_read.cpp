#include "reference/texture_read.h"

#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>

#include "brdf/brdf.h"
#include "telar/error.h"

namespace telar::reference {
namespace {

constexpr std::uint32_t NEAREST = 9728, CLAMP_TO_EDGE = 33071, MIRRORED_REPEAT = 33648;

/// Texel index that a wrap mode gives; `i` is any whole number.
std::size_t wrapped(long long i, std::uint32_t size, std::uint32_t mode) {
  const auto n = static_cast<long long>(size);
  if (i >= 0 && i < n) return static_cast<std::size_t>(i);
  if (mode == CLAMP_TO_EDGE) return static_cast<std::size_t>(i < 0 ? 0 : i >= n ? n - 1 : i);
  const long long period = mode == MIRRORED_REPEAT ? 2 * n : n;
  long long at = i % period;
  if (at < 0) at += period;
  return static_cast<std::size_t>(at >= n ? period - 1 - at : at);
}

struct Reader {
  const Image8& image;
  const Sampler& sampler;
  const std::array<float, 256>& colours;
  const std::array<float, 256>& alphas;

  glm::vec4 texel(long long x, long long y) const {
    const std::size_t at =
        wrapped(y, image.height, sampler.wrapT) * image.width + wrapped(x, image.width, sampler.wrapS);
    const std::uint8_t* p = &image.pixels[at * texelBytes(image.type)];
    if (image.type == TexelType::kByte) return {colours[p[0]], colours[p[1]], colours[p[2]], alphas[p[3]]};
    if (image.type == TexelType::kHalf) {
      std::uint64_t halves = 0;
      std::memcpy(&halves, p, sizeof halves);
      return glm::unpackHalf4x16(halves);
    }
    glm::vec4 floats;
    std::memcpy(&floats, p, sizeof floats);
    return floats;
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

glm::vec4 Textures::read(const TextureRef& texture, const glm::vec2& uv, bool srgb) const {
  if (!texture) return glm::vec4(1.0f);
  const Image8& image = scene_.images[static_cast<std::size_t>(texture.image)];
  if (image.pixels.empty()) return glm::vec4(1.0f);
  const glm::vec3 moved = texture.uvTransform * glm::vec3(uv, 1.0f);
  // Far outside of [0, 1] a float has no fraction to filter with, and an integer may not hold it.
  if (!(std::abs(moved.x) < 1e9f && std::abs(moved.y) < 1e9f)) return glm::vec4(1.0f);
  const Reader reader{image, texture.sampler, decodesSrgb(image.coding, srgb) ? linear_ : bytes_, bytes_};
  const double x = static_cast<double>(moved.x) * image.width, y = static_cast<double>(moved.y) * image.height;
  if (texture.sampler.magFilter == NEAREST) {
    return reader.texel(static_cast<long long>(std::floor(x)), static_cast<long long>(std::floor(y)));
  }
  const double left = std::floor(x - 0.5), top = std::floor(y - 0.5);
  const auto ix = static_cast<long long>(left), iy = static_cast<long long>(top);
  const auto partX = static_cast<float>(x - 0.5 - left), partY = static_cast<float>(y - 0.5 - top);
  return glm::mix(glm::mix(reader.texel(ix, iy), reader.texel(ix + 1, iy), partX),
                  glm::mix(reader.texel(ix, iy + 1), reader.texel(ix + 1, iy + 1), partX), partY);
}

}  // namespace telar::reference
