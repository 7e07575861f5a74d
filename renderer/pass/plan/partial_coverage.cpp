#include "pass/plan/partial_coverage.h"

#include <cmath>
#include <glm/glm.hpp>
#include <limits>
#include <map>
#include <tuple>

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

/// Whether some texel of this mip level is there as a whole: where none is, none of a smaller level is.
/// @param cutoff  [0, 2]. A texel that equals it counts as there, however the GPU rounds.
bool hasWhole(const Image8& image, int level, double cutoff) {
  const std::uint32_t width = std::min(image.width, 1u << level), height = std::min(image.height, 1u << level);
  const double wanted = WHOLE_SHARE * width * height, least = 255 * cutoff - 0.5;
  for (std::uint32_t y = 0; y < image.height; y += height) {
    for (std::uint32_t x = 0; x < image.width; x += width) {
      std::uint32_t there = 0;
      for (std::uint32_t row = y; row < y + height; ++row) {
        const std::uint8_t* texel = &image.pixels[(std::size_t{row} * image.width + x) * 4 + 3];
        for (std::uint32_t i = 0; i < width; ++i, texel += 4) there += *texel >= least ? 1 : 0;
      }
      if (there > wanted) return true;
    }
  }
  return false;
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
    const std::tuple key{texture.image, static_cast<int>(std::min(level, 31.0)), item.textureCutoff()};
    const auto [found, isNew] = whole_.try_emplace(key, false);
    if (isNew) found->second = hasWhole(image, std::get<1>(key), std::get<2>(key));
    return !found->second;
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
  std::map<std::tuple<int, int, float>, bool> whole_;  ///< by image, level and cutoff
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
