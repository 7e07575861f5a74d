#include "frame/ghosts.h"

namespace telar::frame {

std::shared_ptr<const Material> Ghosts::of(const Material& material, float opacity) {
  auto& kept = made_[{&material, opacity}];
  if (kept) return kept;
  auto ghost = std::make_shared<Material>(material);
  ghost->alphaMode = AlphaMode::kBlend;
  // The factor of what is opaque is no alpha. That of its texture and vertices counts, as in the browser.
  ghost->baseColorFactor.a = (isOpaque(material) ? 1.0f : material.baseColorFactor.a) * opacity;
  kept = std::move(ghost);
  return kept;
}

}  // namespace telar::frame
