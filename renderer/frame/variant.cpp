#include "frame/variant.h"

#include <algorithm>

#include "telar/error.h"

namespace telar::frame {
namespace {

const Material DEFAULT_MATERIAL{};  // glTF's: white, metallic 1, roughness 1

}  // namespace

int variantIndex(const Scene& scene, const std::string& name) {
  if (name.empty()) return -1;
  const auto found = std::find(scene.variants.begin(), scene.variants.end(), name);
  if (found != scene.variants.end()) return static_cast<int>(found - scene.variants.begin());
  std::string known;
  for (const std::string& variant : scene.variants) known += (known.empty() ? "" : ", ") + telar::quoted(variant);
  throw Error("E_VARIANT", "shot.variant: this model has no variant " + telar::quoted(name) +
                               (known.empty() ? "; it has none" : "; it has " + known));
}

const Material& materialAt(const Scene& scene, int index, ShadingModel shading) {
  if (index < 0) return DEFAULT_MATERIAL;
  return shownMaterial(scene, scene.materials[static_cast<std::size_t>(index)], shading);
}

}  // namespace telar::frame
