#include "asset/document/extensions.h"

#include <algorithm>
#include <string_view>
#include <unordered_set>

#include "asset/check/pointer.h"

namespace telar::asset {
namespace {

// clang-format off
constexpr std::string_view SUPPORTED[] = {
#include "asset/layer_extensions.inc"
    "EXT_mesh_gpu_instancing",
    "EXT_meshopt_compression",
    "EXT_texture_webp",
    "KHR_draco_mesh_compression",
    "KHR_lights_punctual",
    "KHR_materials_emissive_strength",
    "KHR_materials_unlit",
    "KHR_materials_variants",
    "KHR_mesh_quantization",
    "KHR_meshopt_compression",
    "KHR_texture_basisu",
    "KHR_texture_transform",
};
// clang-format on

/// What to do about extensions that people meet; js/docs/formats.md says why they are not drawn.
struct Cure {
  std::string_view name, text;
};
constexpr Cure CURES[] = {
    {"KHR_materials_pbrSpecularGlossiness", "convert the file with gltf-transform metalrough"},
    {"EXT_texture_avif", "export the textures as WebP, PNG, JPEG or KTX2"},
};

std::string cureOf(std::string_view name) {
  for (const Cure& cure : CURES) {
    if (cure.name == name) return std::string(cure.text);
  }
  return "export without it";
}

bool supported(std::string_view name) {
  return std::find(std::begin(SUPPORTED), std::end(SUPPORTED), name) != std::end(SUPPORTED);
}

using Names = std::unordered_set<std::string_view>;

}  // namespace

void checkExtensions(const std::vector<std::string>& used, const std::vector<std::string>& required, Warnings& warnings,
                     bool tolerant) {
  const Names usedNames(used.begin(), used.end()), requiredNames(required.begin(), required.end());
  for (std::size_t i = 0; i < required.size(); ++i) {
    if (!supported(required[i])) {
      if (tolerant) {
        warnings.add("W_EXT_REQUIRED",
                     "the required extension " + telar::quoted(required[i]) + " is not drawn; " + cureOf(required[i]),
                     pointer("extensionsRequired", i));
        continue;
      }
      fail("E_EXT_REQUIRED",
           "the model requires the glTF extension " + telar::quoted(required[i]) + ", which telar does not have; " +
               cureOf(required[i]),
           pointer("extensionsRequired", i));
    }
    if (!usedNames.contains(required[i])) {
      warnings.add("W_EXT",
                   "the extension " + telar::quoted(required[i]) + " is required but not listed in extensionsUsed",
                   pointer("extensionsRequired", i));
    }
  }
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (supported(used[i]) || requiredNames.contains(used[i])) continue;
    warnings.add("W_EXT_IGNORED",
                 "the optional extension " + telar::quoted(used[i]) + " is not drawn; " + cureOf(used[i]),
                 pointer("extensionsUsed", i));
  }
}

}  // namespace telar::asset
