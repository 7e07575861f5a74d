#include "pass/visible/unread_levels.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <tuple>

#include "pass/plan/made_texture.h"
#include "pass/plan/texture_slots.h"
#include "pass/plan/varyings.h"
#include "pass/texture/mip_levels.h"

namespace telar::pass {
namespace {

using Key = shader::VariantKey;

/// Smaller images are uploaded sooner than looked at: texels for each two by two pixels, and of one image.
constexpr std::uint64_t TEXELS_WORTH_A_QUAD = 128, TEXELS_WORTH_A_LOOK = 1 << 18;
/// What is made of them takes longer than to upload them.
constexpr std::uint64_t MADE_TEXELS_WORTH_A_QUAD = 16;
/// Texels between two fragments from which on a GL reads level 1 and smaller ones: 2, and what it may round.
constexpr float LEVEL_1_STEPS = 2.02f;
constexpr std::uint8_t ALL = 255;

/// Whether TextureStore can leave out levels of it: it makes them itself, of bytes, each half as large as the last.
bool mayLackLevels(const Image8& image) {
  return !image.ownLevels && image.type == TexelType::kByte && halves(image.width, image.height);
}

/// Whether what it samples are the maps alone, by the GL's own choice of the level.
bool isPlain(const Key& key) {
  return !key.fullDetail && !key.normalVariance && !key.normalFacets && !key.alphaToCoverage && !key.alphaMeans &&
         !key.metalMeans && !key.yarnRelief;
}

/// Whether what is made of a slot's map is sampled in its place or beside it, by the GL's own choice of the level.
bool isMadeOf(const TextureSlot& slot, const Key& key) {
  if (key.fullDetail || key.alphaToCoverage || key.alphaMeans) return false;
  if (slot.map == &Key::baseColorMap) return key.metalMeans;
  return madeOf(key, slot) == DerivedTexture::Kind::kNormalVariance;  // facets are read texel by texel
}

/// Maps that are read at the same texels: coordinates, width, height; those that are read otherwise have none.
constexpr std::size_t WHOLE = ~std::size_t{0};
struct SameTexels {
  std::vector<int> images;
  std::vector<int> sources;  ///< those of which another texture is made
};
using Maps = std::map<std::tuple<std::size_t, std::uint32_t, std::uint32_t>, SameTexels>;

/// The images of an item.
Maps mapsOf(const DrawItem& item, const Scene& scene) {
  Maps maps;
  for (const TextureSlot& slot : TEXTURE_SLOTS) {
    if (!(item.key.*slot.map)) continue;
    const TextureRef& texture = slot.texture(*item.material);
    if (!texture) continue;
    const Image8& image = scene.images[static_cast<std::size_t>(texture.image)];
    // A bump map is read beside its place: how far beside, differs from fragment to fragment.
    const bool plain = texture.sampler.readsMipLevels() && slot.map != &Key::bumpMap && mayLackLevels(image);
    SameTexels& same = maps[{plain ? uvComponent(item.key, slot) : WHOLE, image.width, image.height}];
    same.images.push_back(texture.image);
    if (isMadeOf(slot, item.key)) same.sources.push_back(texture.image);
  }
  return maps;
}

std::size_t at(int image) { return static_cast<std::size_t>(image); }

/// Levels above the one that the GL reads, with texels so far apart.
std::uint8_t levelsAbove(float steps) {
  if (!(steps >= LEVEL_1_STEPS)) return 0;
  return std::isinf(steps) ? ALL : static_cast<std::uint8_t>(std::ilogb(steps / LEVEL_1_STEPS) + 1);
}

}  // namespace

UnreadLevels::UnreadLevels(const FramePlan& plan, const Scene& scene, const GpuScene& gpu,
                           const VisibilityBuffer& buffer)
    : levels_(scene.images.size(), ALL), made_(levels_) {
  for (const auto* list : plan.draws.shown()) {
    for (std::size_t draw = 0; draw < list->size(); ++draw) {
      const Key& key = (*list)[draw].key;
      for (const auto& [map, same] : mapsOf((*list)[draw], scene)) {
        const auto& [uv, width, height] = map;
        const std::uint64_t texels = std::uint64_t{width} * height;
        const bool looks = list == &plan.draws.opaque && uv != WHOLE && texels >= TEXELS_WORTH_A_LOOK;
        const bool isWhole = std::ranges::any_of(same.images, [&](int i) { return levels_[at(i)] == 0; }) ||
                             std::ranges::any_of(same.images, [&](int i) { return gpu.isWhole(i); });
        const bool isMadeWhole =
            std::ranges::any_of(same.sources, [&](int i) { return made_[at(i)] == 0 || gpu.unreadOfDerived(i) == 0; });
        const bool ofImages = looks && isPlain(key) && !isWhole &&
                              texels * same.images.size() >= TEXELS_WORTH_A_QUAD * buffer.quads(draw);
        const bool ofMade = looks && !same.sources.empty() && !isMadeWhole &&
                            texels * same.sources.size() >= MADE_TEXELS_WORTH_A_QUAD * buffer.quads(draw);
        const std::uint8_t levels =
            ofImages || ofMade ? levelsAbove(buffer.texelSteps(draw, uv, {width, height}, LEVEL_1_STEPS)) : 0;
        const auto lower = [](std::uint8_t& known, std::uint8_t most) { known = std::min(known, most); };
        for (const int image : same.images) lower(levels_[at(image)], ofImages ? levels : 0);
        for (const int image : same.sources) lower(made_[at(image)], ofMade ? levels : 0);
      }
    }
  }
}

}  // namespace telar::pass
