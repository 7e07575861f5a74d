#include "pass/plan/partial_coverage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>
#include <map>
#include <utility>

#include "pass/plan/pixel_size.h"
#include "pass/texture/mip_levels.h"

namespace telar::pass {
namespace {

/// WHOLE_SHARE of material/coverage.glsl, less what a texel of 8 bits rounds.
constexpr double WHOLE_SHARE = 0.985;
/// Derivatives are differences between pixels: levels by which they may be off.
constexpr double LEVEL_MARGIN = 0.05;

/// Squares of texels to a square metre of the mesh, both axes together, of the triangle that has the fewest.
double fewestTexels2(const Primitive& primitive, const TextureRef& texture, const glm::dmat2& toTexels) {
  const auto& uvs = primitive.uvs[static_cast<std::size_t>(texture.texCoord)];
  if (uvs.empty()) return 0;
  const std::size_t count = primitive.indices.empty() ? primitive.positions.size() : primitive.indices.size();
  const auto vertex = [&](std::size_t i) { return primitive.indices.empty() ? i : primitive.indices[i]; };
  double fewest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 2 < count; i += 3) {
    const std::size_t a = vertex(i), b = vertex(i + 1), c = vertex(i + 2);
    const glm::dvec3 ab(primitive.positions[b] - primitive.positions[a]);
    const glm::dvec3 ac(primitive.positions[c] - primitive.positions[a]);
    const double bb = glm::dot(ab, ab), bc = glm::dot(ab, ac), cc = glm::dot(ac, ac);
    const double area2 = bb * cc - bc * bc;
    if (!(area2 > 0)) continue;  // covers nothing
    const glm::dvec2 u = toTexels * glm::dvec2(uvs[b] - uvs[a]), v = toTexels * glm::dvec2(uvs[c] - uvs[a]);
    // Squared norm of the map from the triangle's plane to texels: by the inverse of the edges' Gram matrix.
    fewest = std::min(fewest, (cc * glm::dot(u, u) - 2 * bc * glm::dot(u, v) + bb * glm::dot(v, v)) / area2);
  }
  return std::isfinite(fewest) ? fewest : 0;
}

/// Texels of the first level for which one of a smaller level stands.
struct Block {
  const Image8& image;
  std::uint32_t x, y, width, height;

  template <class Visit>
  void eachAlpha(const Visit& visit) const {
    for (std::uint32_t row = y; row < y + height; ++row) {
      const std::uint8_t* texel = &image.pixels[(std::size_t{row} * image.width + x) * 4 + 3];
      for (std::uint32_t i = 0; i < width; ++i, texel += 4) visit(*texel);
    }
  }
};

/// The most alpha that no more than `few` texels have less than.
int alphaOfMost(const Block& block, std::uint32_t few) {
  if (few == 0) {
    std::uint8_t least = 255;
    block.eachAlpha([&](std::uint8_t alpha) { least = std::min(least, alpha); });
    return least;
  }
  std::array<std::uint32_t, 256> counts{};
  block.eachAlpha([&](std::uint8_t alpha) { ++counts[alpha]; });
  std::size_t alpha = 0;
  for (std::uint32_t less = counts[0]; less <= few; less += counts[alpha]) ++alpha;
  return static_cast<int>(alpha);
}

/// Up to which cutoff, times 255, some texel of this mip level is there as a whole. One look for all cutoffs: a file may
/// have many of one image.
int mostWhole(const Image8& image, int level) {
  const std::uint32_t width = std::min(image.width, 1u << level), height = std::min(image.height, 1u << level);
  const std::uint32_t count = width * height;
  const std::uint32_t few = count - 1 - static_cast<std::uint32_t>(WHOLE_SHARE * count);
  int most = 0;
  for (std::uint32_t y = 0; y < image.height && most < 255; y += height) {
    for (std::uint32_t x = 0; x < image.width && most < 255; x += width)
      most = std::max(most, alphaOfMost({image, x, y, width, height}, few));
  }
  return most;
}

/// Between the middle of the picture and its corner: pixels that face their ray are smaller there by it.
double cornerCosine(const frame::Camera& camera) {
  if (camera.orthographic) return 1;
  const glm::dvec2 corner(1 / camera.projection[0][0], 1 / camera.projection[1][1]);
  return 1 / std::sqrt(1 + glm::dot(corner, corner));
}

/// What was found of one mesh or one image holds for all items that have it.
class Finder {
 public:
  Finder(const FramePlan& plan, const Scene& scene, const Shot& shot, const GpuScene& gpu, const CancelToken& cancel)
      : scene_(scene),
        gpu_(gpu),
        cancel_(cancel),
        pixel_(pixelSize(plan, scene.bounds, shot) * cornerCosine(plan.camera)) {}

  bool isPartial(const DrawItem& item) {
    cancel_.check();
    const TextureRef& texture = item.material->baseColorTexture;
    const Image8& image = scene_.images[static_cast<std::size_t>(texture.image)];
    const bool isRead = texture.sampler.readsMipLevels() && halves(image.width, image.height) && !image.ownLevels &&
                        image.type == TexelType::kByte && gpu_.levelsLeftOut(scene_, texture.image) == 0;
    if (!isRead || item.primitive->topology != Topology::kTriangles || item.primitive->deformers) return false;
    const double pixel = pixel_ / scaleOf(item);
    // The shader's level is by the longer step of two, whose square is at least half of both.
    const double level = 0.5 * std::log2(0.5 * pixel * pixel * texels2(item, image)) - LEVEL_MARGIN;
    if (!(level >= 1)) return false;
    // Where no texel of this level is there as a whole, none of a smaller level is.
    const std::pair key{texture.image, static_cast<int>(std::min(level, 31.0))};
    const auto [found, isNew] = mostWhole_.try_emplace(key, 0);
    if (isNew) {
      waitForImages(scene_, cancel_);
      found->second = mostWhole(image, key.second);
    }
    // A texel that equals the cutoff counts as there, however the GPU rounds.
    return found->second < 255 * double{item.textureCutoff()} - 0.5;
  }

 private:
  double texels2(const DrawItem& item, const Image8& image) {
    const auto [found, isNew] = texels2_.try_emplace({item.primitive, item.material}, 0);
    if (isNew) {
      const TextureRef& texture = item.material->baseColorTexture;
      const glm::dmat2 size(image.width, 0, 0, image.height);
      found->second = fewestTexels2(*item.primitive, texture, size * glm::dmat2(glm::mat2(texture.uvTransform)));
    }
    return found->second;
  }

  const Scene& scene_;
  const GpuScene& gpu_;
  const CancelToken& cancel_;
  const double pixel_;  ///< metres
  std::map<std::pair<const Primitive*, const Material*>, double> texels2_;
  std::map<std::pair<int, int>, int> mostWhole_;  ///< by image and level
};

}  // namespace

void findPartial(FramePlan& plan, const Scene& scene, const Shot& shot, const GpuScene& gpu,
                 const CancelToken& cancel) {
  Finder finder(plan, scene, shot, gpu, cancel);
  for (DrawItem& item : plan.draws.blended) {
    if (item.blendsCoverage) item.isPartial = finder.isPartial(item);
  }
}

}  // namespace telar::pass
