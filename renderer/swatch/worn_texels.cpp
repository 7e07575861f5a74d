#include "swatch/worn_texels.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "core/mean_of_srgb.h"

namespace telar::swatch {
namespace {

constexpr double PLACES = 1 << 18;
constexpr std::size_t FACES_PER_TEXEL_CHECK = 1 << 12;
/// Of a side of a period, as it is asked whether all of it is worn: a gap between panels of an atlas is some hundredths of it, and each
/// of the cells holds a thousand places of what is worn evenly.
constexpr std::uint32_t CELLS = 16;

std::size_t texelAt(double coordinate, std::uint32_t wrap, std::uint32_t count) {
  if (wrap == Sampler::CLAMP_TO_EDGE) {
    coordinate = std::clamp(coordinate, 0.0, 1.0);
  } else if (wrap == Sampler::MIRRORED_REPEAT) {
    coordinate = std::abs(coordinate - 2 * std::round(coordinate / 2));
  } else {
    coordinate -= std::floor(coordinate);
  }
  return std::min(static_cast<std::size_t>(coordinate * count), static_cast<std::size_t>(count) - 1);
}

/// What of a place of a material with this alpha is there.
double coverOf(const Material& material, double alpha) {
  if (material.alphaMode == AlphaMode::kBlend) return std::clamp(alpha, 0.0, 1.0);
  return material.alphaMode == AlphaMode::kMask && alpha < material.alphaCutoff ? 0 : 1;
}

/// Linear base colour and alpha of a material at a place of its texture.
class BaseColor {
 public:
  BaseColor(const Scene& scene, const Material& material) : material_(material) {
    if (material.baseColorTexture) image_ = &scene.images[static_cast<std::size_t>(material.baseColorTexture.image)];
    for (std::size_t code = 0; code < light_.size(); ++code) light_[code] = lightOfSrgb(code);
  }

  /// @param place  of the texture, transformed
  glm::dvec4 at(const glm::dvec2& place) const {
    const glm::dvec4 factor(material_.baseColorFactor);
    if (!image_) return factor;
    const Sampler& sampler = material_.baseColorTexture.sampler;
    const std::size_t x = texelAt(place.x, sampler.wrapS, image_->width);
    const std::size_t y = texelAt(place.y, sampler.wrapT, image_->height);
    const std::uint8_t* texel = image_->pixels.data() + 4 * (y * image_->width + x);
    return glm::dvec4(light_[texel[0]], light_[texel[1]], light_[texel[2]], texel[3] / 255.0) * factor;
  }

 private:
  const Material& material_;
  const Image8* image_ = nullptr;
  std::array<double, 256> light_{};
};

template <class T>
T mixed(const std::vector<T>& values, const Corners& corners, const glm::dvec3& weights) {
  return T(float(weights.x) * values[corners[0]] + float(weights.y) * values[corners[1]] +
           float(weights.z) * values[corners[2]]);
}

/// Whether a place lies in a triangle of the texture, however that is wound.
bool holds(const std::vector<glm::vec2>& uvs, const Corners& corners, const glm::dvec2& place) {
  std::array<double, 3> sides{};
  for (std::size_t k = 0; k < 3; ++k) {
    const glm::dvec2 from(uvs[corners[k]]), along = glm::dvec2(uvs[corners[(k + 1) % 3]]) - from, to = place - from;
    sides[k] = along.x * to.y - along.y * to.x;
  }
  const auto [least, most] = std::minmax({sides[0], sides[1], sides[2]});
  return least != most && (least >= 0 || most <= 0);  // of one without area, all are 0
}

double areaOf(const surface::Surface& surface, const surface::Face& face) {
  const glm::dvec3& a = surface.corner(face, 0);
  return glm::length(glm::cross(surface.corner(face, 1) - a, surface.corner(face, 2) - a)) / 2;
}

/// Triangles of one primitive, and how large they are.
struct Patch {
  const Primitive* primitive = nullptr;
  std::vector<Corners> triangles;
  std::vector<double> areas;
};

/// Rings of triangles around each vertex of a patch, by the vertices that they share in the texture: 0 at the border of a panel,
/// and everywhere where there is none.
std::vector<std::uint32_t> ringsOf(const Patch& patch, const CancelToken& cancel) {
  std::vector<std::array<std::uint32_t, 2>> sides;
  sides.reserve(3 * patch.triangles.size());
  for (const Corners& corners : patch.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [p, q] = std::minmax(corners[k], corners[(k + 1) % 3]);
      sides.push_back({p, q});
    }
  }
  cancel.check();
  std::sort(sides.begin(), sides.end());
  cancel.check();
  std::vector<std::uint32_t> rings(patch.primitive->positions.size(), surface::NONE), ring;
  for (std::size_t i = 0, next = 0; i < sides.size(); i = next) {
    while (next < sides.size() && sides[next] == sides[i]) ++next;
    if (next - i != 1) continue;
    for (const std::uint32_t p : sides[i]) {
      if (rings[p] != 0) rings[p] = 0, ring.push_back(p);
    }
  }
  sides.erase(std::unique(sides.begin(), sides.end()), sides.end());
  std::vector<std::uint32_t> first(rings.size() + 1), beside(2 * sides.size());
  for (const auto& side : sides) ++first[side[0] + 1], ++first[side[1] + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<std::uint32_t> at(first.begin(), first.end() - 1);
  for (const auto& [p, q] : sides) beside[at[p]++] = q, beside[at[q]++] = p;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (i % FACES_PER_TEXEL_CHECK == 0) cancel.check();
    const std::uint32_t p = ring[i];
    for (std::uint32_t k = first[p]; k < first[p + 1]; ++k) {
      if (rings[beside[k]] == surface::NONE) rings[beside[k]] = rings[p] + 1, ring.push_back(beside[k]);
    }
  }
  std::replace(rings.begin(), rings.end(), surface::NONE, 0u);
  return rings;
}

/// The triangles that wear a material, by primitive, each once: another place has the same texture.
std::vector<Patch> patchesOf(const Scene& scene, const surface::Surface& surface, const Worn& worn,
                             const CancelToken& cancel) {
  std::map<const Primitive*, std::uint32_t> placed;  // the first source of each
  std::vector<Patch> out;
  for (std::size_t f = 0; f < surface.faces.size(); ++f) {
    if (f % FACES_PER_TEXEL_CHECK == 0) cancel.check();
    const surface::Face& face = surface.faces[f];
    if (surface.sources[face.source].material != worn.material) continue;
    const Primitive& primitive = primitiveOf(scene, surface.sources[face.source]);
    const auto [source, isNew] = placed.try_emplace(&primitive, face.source);
    if (source->second != face.source) continue;
    // Faces of a source follow one another.
    if (isNew) out.push_back({&primitive, {}, {}});
    out.back().triangles.push_back(cornersOf(primitive, face));
    out.back().areas.push_back(areaOf(surface, face));
  }
  return out;
}

/// One of many places that a material is worn at.
struct WornPlace {
  const Primitive& primitive;
  Corners corners;
  glm::dvec3 weights;
  glm::dvec2 texture;  ///< place in the texture of the base colour, transformed; (0, 0) without one
  double area;         ///< square metres that it stands for
};

/// Visits places of the triangles that wear the material, PLACES and more, evenly by area: an R2 sequence (Roberts 2018).
/// @return whether all of them have coordinates of the texture
template <class Visit>
bool visitWorn(const Scene& scene, const surface::Surface& surface, const Worn& worn, const CancelToken& cancel,
               const Visit& visit) {
  const TextureRef& texture = scene.materials.at(static_cast<std::size_t>(worn.material)).baseColorTexture;
  const glm::dmat3 transform = texture.hasTransform ? glm::dmat3(texture.uvTransform) : glm::dmat3(1);
  double place = 0;
  for (std::size_t f = 0; f < surface.faces.size(); ++f) {
    if (f % FACES_PER_TEXEL_CHECK == 0) cancel.check();
    const surface::Face& face = surface.faces[f];
    if (surface.sources[face.source].material != worn.material) continue;
    const Primitive& primitive = primitiveOf(scene, surface.sources[face.source]);
    const auto& uvs = primitive.uvs[static_cast<std::size_t>(texture.texCoord)];
    if (texture && uvs.empty()) return false;
    const Corners corners = cornersOf(primitive, face);
    const double area = areaOf(surface, face), places = std::ceil(PLACES * area / worn.area);
    for (double i = 0; i < places; ++i, ++place) {
      glm::dvec2 at = glm::fract(glm::dvec2(0.5) + place * glm::dvec2(0.7548776662466927, 0.5698402909980532));
      if (at.x + at.y > 1) at = 1.0 - at;
      const glm::dvec3 weights(1 - at.x - at.y, at.x, at.y);
      const glm::dvec2 uv = texture ? glm::dvec2(mixed(uvs, corners, weights)) : glm::dvec2(0);
      if (!std::isfinite(uv.x + uv.y)) continue;
      visit(WornPlace{primitive, corners, weights, glm::dvec2(transform * glm::dvec3(uv, 1)), area / places});
    }
  }
  return true;
}

}  // namespace

bool wearsATile(const Scene& scene, const surface::Surface& surface, const Worn& worn, const CancelToken& cancel) {
  const TextureRef& texture = scene.materials.at(static_cast<std::size_t>(worn.material)).baseColorTexture;
  if (texture.sampler.wrapS == Sampler::CLAMP_TO_EDGE || texture.sampler.wrapT == Sampler::CLAMP_TO_EDGE) return false;
  const auto cellOf = [](double coordinate, std::uint32_t wrap) {
    return texelAt(wrap == Sampler::MIRRORED_REPEAT ? coordinate / 2 : coordinate, Sampler::REPEAT, CELLS);
  };
  std::array<bool, std::size_t{CELLS} * CELLS> isWorn{};
  const bool all = visitWorn(scene, surface, worn, cancel, [&](const WornPlace& place) {
    const std::size_t x = cellOf(place.texture.x, texture.sampler.wrapS);
    isWorn[CELLS * cellOf(place.texture.y, texture.sampler.wrapT) + x] = true;
  });
  return all && std::all_of(isWorn.begin(), isWorn.end(), [](bool cell) { return cell; });
}

std::optional<glm::dvec3> meanTileColor(const Scene& scene, const Worn& worn) {
  const Material& material = scene.materials.at(static_cast<std::size_t>(worn.material));
  const Image8& image = scene.images[static_cast<std::size_t>(material.baseColorTexture.image)];
  if (!decodesSrgb(image.coding, true)) return std::nullopt;
  const glm::dvec4 factor = glm::dvec4(material.baseColorFactor) * worn.color / worn.area;
  std::array<std::uint8_t, 256> counts{};
  for (std::size_t code = 0; code < counts.size(); ++code) {
    // What is blended counts by its texels' alpha: the rest of it is the same all over.
    const bool isThere = coverOf(material, static_cast<double>(code) / 255 * factor.a) > 0;
    counts[code] = static_cast<std::uint8_t>(material.alphaMode == AlphaMode::kBlend ? code : std::size_t{isThere});
  }
  auto mean = meanOfSrgb(image, counts);
  if (!mean) mean = meanOfSrgb(image, false);  // nothing of it covers: the colour that it would have
  return mean ? std::optional(*mean * glm::dvec3(factor)) : std::nullopt;
}

std::optional<glm::dvec3> meanWornColor(const Scene& scene, const surface::Surface& surface, const Worn& worn,
                                        const CancelToken& cancel) {
  const Material& material = scene.materials.at(static_cast<std::size_t>(worn.material));
  if (const TextureRef& texture = material.baseColorTexture) {
    const Image8& image = scene.images[static_cast<std::size_t>(texture.image)];
    if (!decodesSrgb(image.coding, true) || image.type != TexelType::kByte || image.pixels.empty()) return std::nullopt;
  }
  const BaseColor color(scene, material);
  glm::dvec4 covering(0), all(0);  // sums of colours by what covers, and by area, and of that
  const bool known = visitWorn(scene, surface, worn, cancel, [&](const WornPlace& place) {
    glm::dvec4 there = color.at(place.texture);
    const auto& colors = place.primitive.colors;
    if (!colors.empty()) there *= glm::dvec4(mixed(colors, place.corners, place.weights));
    const glm::dvec4 counted = place.area * glm::dvec4(glm::dvec3(there), 1);
    covering += coverOf(material, there.a) * counted;
    all += counted;
  });
  // Where nothing of it covers, the colour that it would have.
  const glm::dvec4& sum = covering.w > 0 ? covering : all;
  return known && sum.w > 0 ? std::optional(glm::dvec3(sum) / sum.w) : std::nullopt;
}

std::array<glm::dvec2, 2> wornPlace(const Scene& scene, const surface::Surface& surface, const Worn& worn,
                                    std::size_t set, const CancelToken& cancel) {
  std::array<glm::dvec2, 2> out{glm::dvec2(0.5), glm::dvec2(0.5)};
  const std::vector<Patch> patches = patchesOf(scene, surface, worn, cancel);
  for (const Patch& patch : patches) {
    const auto& uvs = patch.primitive->uvs[set];
    const auto isMiddle = [&](const Corners& corners) { return holds(uvs, corners, out[set]); };
    if (!uvs.empty() && std::any_of(patch.triangles.begin(), patch.triangles.end(), isMiddle)) return out;
  }
  std::pair<std::uint32_t, double> most{0, -1};
  for (const Patch& patch : patches) {
    const std::vector<std::uint32_t> rings = ringsOf(patch, cancel);
    for (std::size_t t = 0; t < patch.triangles.size(); ++t) {
      const Corners& corners = patch.triangles[t];
      const std::pair here(rings[corners[0]] + rings[corners[1]] + rings[corners[2]], patch.areas[t]);
      if (here <= most) continue;
      most = here;
      for (std::size_t i = 0; i < out.size(); ++i) {
        if (patch.primitive->uvs[i].empty()) continue;
        const glm::dvec2 middle(mixed(patch.primitive->uvs[i], corners, glm::dvec3(1.0 / 3)));
        if (std::isfinite(middle.x + middle.y)) out[i] = middle;
      }
    }
  }
  return out;
}

}  // namespace telar::swatch
