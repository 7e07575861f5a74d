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

/// What others are made of, without the levels that are left out. -1 = none.
BakeSource sourceOf(int index, bool srgb, const Scene& scene, GpuScene& gpu, const CancelToken& cancel) {
  if (index < 0) return {};
  const GLuint texture = gpu.source(scene, index, srgb, cancel);
  const Image8& image = scene.images[static_cast<std::size_t>(index)];
  const int first = gpu.levelsLeftOut(scene, index);
  return {texture, {std::max(image.width >> first, 1u), std::max(image.height >> first, 1u)}};
}

/// The derived form of the texture that is sampled, if there is one.
std::optional<DerivedTexture> derivedOf(const DrawItem& item, const TextureSlot& slot, const Scene& scene,
                                        const GpuScene& gpu) {
  const auto kind = madeOf(item.key, slot);
  if (!kind) return std::nullopt;
  const int image = slot.texture(*item.material).image;
  DerivedTexture made{*kind, image, decodesSrgb(scene.images[static_cast<std::size_t>(image)].coding, slot.srgb)};
  const bool leavesHolesOut =
      *kind == DerivedTexture::Kind::kNormalVariance && item.key.normalHoles && slot.map == &Key::normalMap;
  if (leavesHolesOut) made.cover = item.material->baseColorTexture.image;
  if ((leavesHolesOut || *kind == DerivedTexture::Kind::kCoverage) && item.key.alphaToCoverage)
    made.cutoff = item.textureCutoff();
  return withLimits(made, scene, gpu);
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
      if (item.key.metalMeans) metal(item, scene, gpu, cancel, unread);
      if (item.key.yarnRelief) yarnRelief(item, scene, gpu, cancel);
      if (item.hasReliefAxis()) reliefAxis(item, scene, gpu, cancel);
    }
  }
  gpu.dropSources();
}

GLuint SurfaceTextures::texture(const DrawItem& item, const TextureSlot& slot, const Scene& scene, GpuScene& gpu,
                                const CancelToken& cancel, const UnreadLevels* unread) {
  const int index = slot.texture(*item.material).image;
  auto key = derivedOf(item, slot, scene, gpu);
  if (!key) return gpu.texture(scene, index, slot.srgb, cancel, unread ? unread->of(index) : 0);
  if (unread && key->kind == DerivedTexture::Kind::kNormalVariance)
    key->unread = std::max(unread->ofMade(index) - key->first, 0);
  return gpu.derived(*key, [&] {
    using Kind = DerivedTexture::Kind;
    const BakeSource source = sourceOf(index, slot.srgb, scene, gpu, cancel);
    if (key->kind == Kind::kCoverage) return baker_.coverage(source, key->srgb, key->cutoff, cancel);
    if (key->kind == Kind::kNormalFacets) return baker_.normalFacets(source, cancel);
    return baker_.normalVariance(source, sourceOf(key->cover, true, scene, gpu, cancel), key->cutoff, key->unread,
                                 cancel);
  });
}

GLuint SurfaceTextures::metal(const DrawItem& item, const Scene& scene, GpuScene& gpu, const CancelToken& cancel,
                              const UnreadLevels* unread) {
  DerivedTexture key = metalOf(item, scene, gpu);
  if (unread) key.unread = std::max(unread->ofMade(key.image) - key.first, 0);
  return gpu.derived(key, [&] {
    BakeSource color = sourceOf(key.image, true, scene, gpu, cancel);
    // Without metal anywhere one texel says so of all.
    if (!hasMetal(scene.images[static_cast<std::size_t>(key.cover)])) color.size = glm::ivec2(1);
    return baker_.metal(color, key.srgb, sourceOf(key.cover, false, scene, gpu, cancel),
                        sourceOf(key.yarns, false, scene, gpu, cancel), key.unread, cancel);
  });
}

GLuint SurfaceTextures::yarnRelief(const DrawItem& item, const Scene& scene, GpuScene& gpu, const CancelToken& cancel) {
  const DerivedTexture key = yarnReliefOf(item, scene, gpu);
  return gpu.derived(key, [&] {
    return baker_.yarnRelief(sourceOf(key.image, false, scene, gpu, cancel),
                             sourceOf(key.yarns, false, scene, gpu, cancel), cancel);
  });
}

glm::vec2 SurfaceTextures::reliefAxis(const DrawItem& item, const Scene& scene, GpuScene& gpu,
                                      const CancelToken& cancel) {
  const int image = item.material->normalTexture.image;
  return gpu.reliefAxis(image, gpu.levelsLeftOut(scene, image),
                        [&] { return baker_.reliefAxis(sourceOf(image, false, scene, gpu, cancel), cancel); });
}

}  // namespace telar::pass
