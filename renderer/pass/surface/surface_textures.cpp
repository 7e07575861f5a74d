#include "pass/surface/surface_textures.h"

#include <algorithm>
#include <optional>
#include <set>

namespace telar::pass {
namespace {

using Key = shader::VariantKey;

/// The key with what of its images is not read.
DerivedTexture withLimits(DerivedTexture key, const Scene& scene, const GpuScene& gpu) {
  key.first = gpu.levelsLeftOut(scene, key.image);
  key.besideFirst = std::max(gpu.levelsLeftOut(scene, key.cover), gpu.levelsLeftOut(scene, key.yarns));
  return key;
}

/// Texels of the level of its image that a texture is made of.
glm::ivec2 sizeOf(const DerivedTexture& key, const Scene& scene) {
  const Image8& image = scene.images[static_cast<std::size_t>(key.image)];
  return {std::max(image.width >> key.first, 1u), std::max(image.height >> key.first, 1u)};
}

/// The derived form of the texture that is sampled, if there is one.
std::optional<DerivedTexture> derivedOf(const DrawItem& item, const TextureSlot& slot, const Scene& scene,
                                        const GpuScene& gpu) {
  const int image = slot.texture(*item.material).image;
  const bool srgb = decodesSrgb(scene.images[static_cast<std::size_t>(image)].coding, slot.srgb);
  if (item.key.normalFacets && slot.map == &Key::normalMap)
    return withLimits({DerivedTexture::Kind::kNormalFacets, image, srgb}, scene, gpu);
  if (item.key.normalVariance && (slot.map == &Key::normalMap || slot.map == &Key::clearcoatNormalMap)) {
    DerivedTexture relief{DerivedTexture::Kind::kNormalVariance, image, srgb};
    if (item.key.normalHoles && slot.map == &Key::normalMap) {
      relief.cutoff = item.textureCutoff();
      relief.cover = item.material->baseColorTexture.image;
    }
    return withLimits(relief, scene, gpu);
  }
  if (item.key.alphaToCoverage && slot.map == &Key::baseColorMap) {
    return withLimits({DerivedTexture::Kind::kCoverage, image, srgb, item.textureCutoff()}, scene, gpu);
  }
  return std::nullopt;
}

/// The map of what of the base colour is metal's.
DerivedTexture metalOf(const DrawItem& item, const Scene& scene, const GpuScene& gpu) {
  const Material& m = *item.material;
  const int image = m.baseColorTexture.image;
  DerivedTexture metal{DerivedTexture::Kind::kMetal, image,
                       decodesSrgb(scene.images[static_cast<std::size_t>(image)].coding, true)};
  metal.cover = m.metallicRoughnessTexture.image;
  if (item.key.metalYarns) metal.yarns = m.fabric.weaveTexture.image;
  return withLimits(metal, scene, gpu);
}

/// Whether a map of metalness, in blue, has metal anywhere. Most files have such a map for its roughness alone.
bool hasMetal(const Image8& image) {
  if (image.type != TexelType::kByte) return true;
  for (std::size_t i = 2; i < image.pixels.size(); i += 4) {
    if (image.pixels[i] != 0) return true;
  }
  return false;
}

/// The map of how flat warp and weft lie.
DerivedTexture yarnReliefOf(const DrawItem& item, const Scene& scene, const GpuScene& gpu) {
  DerivedTexture relief{DerivedTexture::Kind::kYarnRelief, item.material->normalTexture.image};
  relief.yarns = item.material->fabric.weaveTexture.image;
  return withLimits(relief, scene, gpu);
}

/// Textures that the list samples: calls visit(item, slot) for each.
template <class Visit>
void eachTexture(const std::vector<DrawItem>& list, const Visit& visit) {
  for (const DrawItem& item : list) {
    for (const TextureSlot& slot : TEXTURE_SLOTS) {
      if (item.key.*slot.map && slot.texture(*item.material)) visit(item, slot);
    }
  }
}

}  // namespace

void SurfaceTextures::checkMemory(const FramePlan& plan, const Scene& scene, const GpuScene& gpu) const {
  std::set<DerivedTexture> wanted;
  for (const auto* list : plan.draws.shown()) {
    eachTexture(*list, [&](const DrawItem& item, const TextureSlot& slot) {
      if (const auto derived = derivedOf(item, slot, scene, gpu)) wanted.insert(*derived);
    });
    for (const DrawItem& item : *list) {
      if (item.key.metalMeans) wanted.insert(metalOf(item, scene, gpu));
      if (item.key.yarnRelief) wanted.insert(yarnReliefOf(item, scene, gpu));
    }
  }
  if (wanted.empty()) return;
  checkLimit("L_MEMORY_BYTES", static_cast<double>(memoryBytes_),
             static_cast<double>(scene.memoryBytes + gpu.derivedBytes(scene, std::move(wanted))));
}

void SurfaceTextures::upload(const FramePlan& plan, const Scene& scene, GpuScene& gpu, const CancelToken& cancel,
                             const UnreadLevels* unread) {
  for (const auto* list : plan.draws.shown()) {
    eachTexture(*list, [&](const DrawItem& item, const TextureSlot& slot) {
      cancel.check();
      texture(item, slot, scene, gpu, cancel, unread);
    });
    for (const DrawItem& item : *list) {
      if (item.key.metalMeans) metal(item, scene, gpu, cancel);
      if (item.key.yarnRelief) yarnRelief(item, scene, gpu, cancel);
    }
  }
}

GLuint SurfaceTextures::texture(const DrawItem& item, const TextureSlot& slot, const Scene& scene, GpuScene& gpu,
                                const CancelToken& cancel, const UnreadLevels* unread) {
  const int index = slot.texture(*item.material).image;
  const GLuint plain = gpu.texture(scene, index, slot.srgb, cancel, unread ? unread->of(index) : 0);
  const auto key = derivedOf(item, slot, scene, gpu);
  if (!key) return plain;
  const glm::ivec2 size = sizeOf(*key, scene);
  const GLuint cover = key->cover < 0 ? 0 : gpu.texture(scene, key->cover, true, cancel);
  return gpu.derived(*key, [&] {
    using Kind = DerivedTexture::Kind;
    if (key->kind == Kind::kCoverage) return baker_.coverage(plain, key->srgb, size.x, size.y, key->cutoff, cancel);
    if (key->kind == Kind::kNormalFacets) return baker_.normalFacets(plain, size.x, size.y, cancel);
    return baker_.normalVariance(plain, size.x, size.y, cover, key->cutoff, cancel);
  });
}

GLuint SurfaceTextures::metal(const DrawItem& item, const Scene& scene, GpuScene& gpu, const CancelToken& cancel) {
  const DerivedTexture key = metalOf(item, scene, gpu);
  return gpu.derived(key, [&] {
    const bool any = hasMetal(scene.images[static_cast<std::size_t>(key.cover)]);  // else one texel says so of all
    const glm::ivec2 size = any ? sizeOf(key, scene) : glm::ivec2(1);
    const GLuint color = gpu.texture(scene, key.image, true, cancel);
    const GLuint metallic = gpu.texture(scene, key.cover, false, cancel);
    const GLuint yarns = key.yarns < 0 ? 0 : gpu.texture(scene, key.yarns, false, cancel);
    return baker_.metal(color, key.srgb, size.x, size.y, metallic, yarns, cancel);
  });
}

GLuint SurfaceTextures::yarnRelief(const DrawItem& item, const Scene& scene, GpuScene& gpu, const CancelToken& cancel) {
  const DerivedTexture key = yarnReliefOf(item, scene, gpu);
  return gpu.derived(key, [&] {
    const glm::ivec2 size = sizeOf(key, scene);
    return baker_.yarnRelief(gpu.texture(scene, key.image, false, cancel), size.x, size.y,
                             gpu.texture(scene, key.yarns, false, cancel), cancel);
  });
}

}  // namespace telar::pass
