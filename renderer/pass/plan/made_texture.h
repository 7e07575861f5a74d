#pragma once
#include <optional>

#include "pass/model/gpu_scene.h"
#include "pass/plan/texture_slots.h"

namespace telar::pass {

/// What is made of the map of a slot, and sampled in its place; none where the map itself is.
inline std::optional<DerivedTexture::Kind> madeOf(const shader::VariantKey& key, const TextureSlot& slot) {
  using Kind = DerivedTexture::Kind;
  if (key.normalFacets && slot.map == &shader::VariantKey::normalMap) return Kind::kNormalFacets;
  if (key.normalVariance &&
      (slot.map == &shader::VariantKey::normalMap || slot.map == &shader::VariantKey::clearcoatNormalMap))
    return Kind::kNormalVariance;
  if ((key.alphaToCoverage || key.alphaMeans) && slot.map == &shader::VariantKey::baseColorMap) return Kind::kCoverage;
  return std::nullopt;
}

}  // namespace telar::pass
