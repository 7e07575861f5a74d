#include "pass/surface_textures.h"

#include <optional>
#include <set>

namespace telar::pass {
namespace {

/// The texture's smallest alpha that passes the material's alpha test.
float textureCutoff(const Material& m) { return m.baseColorFactor.a > 0 ? m.alphaCutoff / m.baseColorFactor.a : 2.0f; }

/// The derived form of the texture that is sampled, if there is one.
std::optional<DerivedTexture> derivedOf(const DrawItem& item, const TextureSlot& slot, const Scene& scene) {
  using Key = shader::VariantKey;
  const int image = slot.texture(*item.material).image;
  const bool srgb = decodesSrgb(scene.images[static_cast<std::size_t>(image)].coding, slot.srgb);
  if (item.key.normalFacets && slot.map == &Key::normalMap)
    return DerivedTexture{DerivedTexture::Kind::kNormalFacets, image, srgb};
  if (item.key.normalVariance && (slot.map == &Key::normalMap || slot.map == &Key::clearcoatNormalMap)) {
    DerivedTexture relief{DerivedTexture::Kind::kNormalVariance, image, srgb};
    if (item.key.normalHoles && slot.map == &Key::normalMap) {
      relief.cutoff = textureCutoff(*item.material);
      relief.cover = item.material->baseColorTexture.image;
    }
    return relief;
  }
  if (item.key.alphaToCoverage && slot.map == &Key::baseColorMap) {
    return DerivedTexture{DerivedTexture::Kind::kCoverage, image, srgb, textureCutoff(*item.material)};
  }
  return std::nullopt;
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

/// Before the first upload, so that a model that takes too much is refused at once.
void SurfaceTextures::checkMemory(const FramePlan& plan, const Scene& scene, const GpuScene& gpu) const {
  std::set<DerivedTexture> wanted;
  for (const auto* list : plan.draws.shown()) {
    eachTexture(*list, [&](const DrawItem& item, const TextureSlot& slot) {
      if (const auto derived = derivedOf(item, slot, scene)) wanted.insert(*derived);
    });
  }
  if (wanted.empty()) return;
  checkLimit("L_MEMORY_BYTES", static_cast<double>(memoryBytes_),
             static_cast<double>(scene.memoryBytes + gpu.derivedBytes(scene, std::move(wanted))));
}

void SurfaceTextures::upload(const FramePlan& plan, const Scene& scene, GpuScene& gpu, const CancelToken& cancel) {
  checkMemory(plan, scene, gpu);
  for (const auto* list : plan.draws.shown()) {
    eachTexture(*list, [&](const DrawItem& item, const TextureSlot& slot) {
      cancel.check();
      texture(item, slot, scene, gpu, cancel);
    });
  }
}

GLuint SurfaceTextures::texture(const DrawItem& item, const TextureSlot& slot, const Scene& scene, GpuScene& gpu,
                                const CancelToken& cancel) {
  const int index = slot.texture(*item.material).image;
  const GLuint plain = gpu.texture(scene, index, slot.srgb, cancel);
  const auto key = derivedOf(item, slot, scene);
  if (!key) return plain;
  const Image8& image = scene.images[static_cast<std::size_t>(index)];
  const auto width = static_cast<int>(image.width), height = static_cast<int>(image.height);
  const GLuint cover = key->cover < 0 ? 0 : gpu.texture(scene, key->cover, true, cancel);
  return gpu.derived(*key, [&] {
    using Kind = DerivedTexture::Kind;
    if (key->kind == Kind::kCoverage) return baker_.coverage(plain, key->srgb, width, height, key->cutoff, cancel);
    if (key->kind == Kind::kNormalFacets) return baker_.normalFacets(plain, width, height, cancel);
    return baker_.normalVariance(plain, width, height, cover, key->cutoff, cancel);
  });
}

}  // namespace telar::pass
