#include "asset/material/physical_layers.h"

#include <algorithm>

#include "asset/material/layer.h"

namespace telar::asset {
namespace {

/// Each of these makes the material physical for GLTFLoader.
constexpr const char* PHYSICAL[] = {
#include "asset/physical_extensions.inc"
};

}  // namespace

bool readPhysicalLayers(const tinygltf::ExtensionMap& extensions, const std::string& where, TextureReader& textures,
                        Warnings& warnings, PhysicalLayers& out) {
  const auto layer = [&](const char* name) { return Layer(extensions, name, where, textures, warnings); };
#include "asset/physical_readers.inc"
  return std::any_of(std::begin(PHYSICAL), std::end(PHYSICAL),
                     [&](const char* name) { return extensions.contains(name); });
}

}  // namespace telar::asset
