#include "asset/material/material.h"

#include "asset/check/clamped.h"
#include "asset/check/pointer.h"
#include "asset/document/extension_value.h"
#include "asset/material/fabric_layers.h"
#include "asset/material/physical_layers.h"
#include "asset/material/texture_ref.h"
#include "telar/half.h"
#include "telar/material_textures.inc"

namespace telar::asset {
namespace {

class MaterialReader {
 public:
  MaterialReader(int material, const Document& document, Warnings& warnings)
      : source_(document.model.materials[static_cast<std::size_t>(material)]),
        warnings_(warnings),
        textures_(document, warnings),
        where_(pointer("materials", material)) {
    const auto index = static_cast<std::size_t>(material);
    if (index < document.fabrics.size()) fabric_ = document.fabrics[index];
  }

  Material read() {
    Material out;
    out.name = source_.name;
    readPbr(out);
    readTextures(out);
    readEmissive(out);
    readAlpha(out);
    out.doubleSided = source_.doubleSided;
    out.preset = fabric_.preset;
    out.withPreset = fabric_.withPreset;
    out.unlit = source_.extensions.contains("KHR_materials_unlit");
    if (out.unlit) {
      dropLitTextures(out);
    } else {
      out.physical = readPhysicalLayers(source_.extensions, where_ + "/extensions", textures_, warnings_, out.layers);
      out.fabric = readFabricLayers(source_.extensions, out, where_ + "/extensions",
                                    where_ + (fabric_.inExtras ? "/extras" : "/extensions"), textures_, warnings_);
    }
    return out;
  }

 private:
  float inRange(double value, double low, double high, const char* key) {
    return clamped(value, low, high, where_ + "/" + key, warnings_);
  }

  void readPbr(Material& out) {
    const auto& pbr = source_.pbrMetallicRoughness;
    for (int i = 0; i < 4; ++i) {
      out.baseColorFactor[i] =
          inRange(pbr.baseColorFactor[static_cast<std::size_t>(i)], 0, 1, "pbrMetallicRoughness/baseColorFactor");
    }
    out.metallicFactor = inRange(pbr.metallicFactor, 0, 1, "pbrMetallicRoughness/metallicFactor");
    out.roughnessFactor = inRange(pbr.roughnessFactor, 0, 1, "pbrMetallicRoughness/roughnessFactor");
  }

  void readTextures(Material& out) {
    const auto& pbr = source_.pbrMetallicRoughness;
    out.baseColorTexture = texture(pbr.baseColorTexture, "pbrMetallicRoughness/baseColorTexture");
    out.metallicRoughnessTexture =
        texture(pbr.metallicRoughnessTexture, "pbrMetallicRoughness/metallicRoughnessTexture");
    out.normalTexture = texture(source_.normalTexture, "normalTexture");
    out.normalScale = inRange(source_.normalTexture.scale, -NORMAL_SCALE_MAX, NORMAL_SCALE_MAX, "normalTexture/scale");
    out.occlusionTexture = texture(source_.occlusionTexture, "occlusionTexture");
    out.occlusionStrength = inRange(source_.occlusionTexture.strength, 0, 1, "occlusionTexture/strength");
    out.emissiveTexture = texture(source_.emissiveTexture, "emissiveTexture");
  }

  void readEmissive(Material& out) {
    const auto extension = source_.extensions.find("KHR_materials_emissive_strength");
    const double strength =
        extension == source_.extensions.end() ? 1.0 : numberOf(extension->second, "emissiveStrength", 1.0);
    for (int i = 0; i < 3; ++i) {
      const double factor = source_.emissiveFactor[static_cast<std::size_t>(i)];
      // More cannot be kept in the frame.
      out.emissiveFactor[i] = inRange(inRange(factor, 0, 1, "emissiveFactor") * strength, 0, HALF_MAX,
                                      "extensions/KHR_materials_emissive_strength/emissiveStrength");
    }
  }

  void readAlpha(Material& out) {
    const std::string& mode = source_.alphaMode;
    if (mode == "MASK") {
      out.alphaMode = AlphaMode::kMask;
    } else if (mode == "BLEND") {
      out.alphaMode = AlphaMode::kBlend;
    } else if (!mode.empty() && mode != "OPAQUE") {
      warnings_.add("W_ENUM", "the alpha mode " + telar::quoted(mode) + " is unknown; drawn opaque",
                    where_ + "/alphaMode");
    }
    // Above 1 is allowed and hides everything.
    out.alphaCutoff = inRange(source_.alphaCutoff, 0, 2, "alphaCutoff");
  }

  /// An unlit material reads nothing but its base colour.
  static void dropLitTextures(Material& out) {
    out.metallicRoughnessTexture = out.normalTexture = out.occlusionTexture = out.emissiveTexture = TextureRef{};
  }

  template <typename Info>  // TextureInfo, NormalTextureInfo or OcclusionTextureInfo
  TextureRef texture(const Info& info, const char* key) {
    if (info.index < 0) return {};
    const auto transform = info.extensions.find("KHR_texture_transform");
    const tinygltf::Value* found = transform == info.extensions.end() ? nullptr : &transform->second;
    return textures_.read(info.index, info.texCoord, found, where_ + "/" + key);
  }

  const tinygltf::Material& source_;
  Warnings& warnings_;
  TextureReader textures_;
  std::string where_;
  FabricSource fabric_;
};

}  // namespace

Material readMaterial(int material, const Document& document, Warnings& warnings) {
  return MaterialReader(material, document, warnings).read();
}

std::vector<TextureUse> texturesOf(Material& material) {
#define TELAR_TEXTURE_USE(field, name, srgb, feature) {&material.field, srgb},
  std::vector<TextureUse> out{TELAR_MATERIAL_TEXTURES(TELAR_TEXTURE_USE)};
#undef TELAR_TEXTURE_USE
  std::erase_if(out, [](const TextureUse& use) { return !*use.texture; });
  return out;
}

}  // namespace telar::asset
