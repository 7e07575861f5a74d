#include "asset/material.h"

#include <cmath>

#include "asset/extension_value.h"
#include "asset/number.h"
#include "asset/pointer.h"

namespace telar::asset {
namespace {

constexpr int UV_SETS = 2;
constexpr double EMISSIVE_MAX = 65504;  // the largest half: more cannot be kept in the frame
constexpr double NORMAL_SCALE_MAX = 1e4;

constexpr int WRAPS[] = {33071, 33648, 10497};
constexpr int MAG_FILTERS[] = {9728, 9729};
constexpr int MIN_FILTERS[] = {9728, 9729, 9984, 9985, 9986, 9987};

template <std::size_t N>
bool isOneOf(int value, const int (&list)[N]) {
  return std::find(std::begin(list), std::end(list), value) != std::end(list);
}

class MaterialReader {
 public:
  MaterialReader(int material, const Document& document, Warnings& warnings)
      : document_(document),
        source_(document.model.materials[static_cast<std::size_t>(material)]),
        warnings_(warnings),
        where_(pointer("materials", material)) {}

  Material read() {
    Material out;
    out.name = source_.name;
    readPbr(out);
    readTextures(out);
    readEmissive(out);
    readAlpha(out);
    out.doubleSided = source_.doubleSided;
    out.unlit = source_.extensions.contains("KHR_materials_unlit");
    if (out.unlit) dropLitTextures(out);
    return out;
  }

 private:
  float clamped(double value, double low, double high, const char* key) {
    const double out = std::clamp(value, low, high);
    if (out != value) warnings_.add("W_RANGE", "a value was clamped to its range", where_ + "/" + key);
    return toFloat(out);
  }

  void readPbr(Material& out) {
    const auto& pbr = source_.pbrMetallicRoughness;
    for (int i = 0; i < 4; ++i) {
      out.baseColorFactor[i] =
          clamped(pbr.baseColorFactor[static_cast<std::size_t>(i)], 0, 1, "pbrMetallicRoughness/baseColorFactor");
    }
    out.metallicFactor = clamped(pbr.metallicFactor, 0, 1, "pbrMetallicRoughness/metallicFactor");
    out.roughnessFactor = clamped(pbr.roughnessFactor, 0, 1, "pbrMetallicRoughness/roughnessFactor");
  }

  void readTextures(Material& out) {
    const auto& pbr = source_.pbrMetallicRoughness;
    out.baseColorTexture = texture(pbr.baseColorTexture, "pbrMetallicRoughness/baseColorTexture");
    out.metallicRoughnessTexture =
        texture(pbr.metallicRoughnessTexture, "pbrMetallicRoughness/metallicRoughnessTexture");
    out.normalTexture = texture(source_.normalTexture, "normalTexture");
    out.normalScale = clamped(source_.normalTexture.scale, -NORMAL_SCALE_MAX, NORMAL_SCALE_MAX, "normalTexture/scale");
    out.occlusionTexture = texture(source_.occlusionTexture, "occlusionTexture");
    out.occlusionStrength = clamped(source_.occlusionTexture.strength, 0, 1, "occlusionTexture/strength");
    out.emissiveTexture = texture(source_.emissiveTexture, "emissiveTexture");
  }

  void readEmissive(Material& out) {
    const auto extension = source_.extensions.find("KHR_materials_emissive_strength");
    const double strength =
        extension == source_.extensions.end() ? 1.0 : numberOf(extension->second, "emissiveStrength", 1.0);
    for (int i = 0; i < 3; ++i) {
      const double factor = source_.emissiveFactor[static_cast<std::size_t>(i)];
      out.emissiveFactor[i] = clamped(clamped(factor, 0, 1, "emissiveFactor") * strength, 0, EMISSIVE_MAX,
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
    out.alphaCutoff = clamped(source_.alphaCutoff, 0, 2, "alphaCutoff");
  }

  /// An unlit material reads nothing but its base colour.
  static void dropLitTextures(Material& out) {
    out.metallicRoughnessTexture = out.normalTexture = out.occlusionTexture = out.emissiveTexture = TextureRef{};
  }

  template <typename Info>  // TextureInfo, NormalTextureInfo or OcclusionTextureInfo
  TextureRef texture(const Info& info, const char* key) {
    if (info.index < 0) return {};
    const std::string where = where_ + "/" + key;
    TextureRef out;
    out.image = imageOf(info.index);
    if (out.image < 0) {
      warnings_.add("W_TEXTURE", "the texture has no image that telar reads and is not drawn",
                    pointer("textures", info.index));
      return {};
    }
    out.sampler = samplerOf(document_.model.textures[static_cast<std::size_t>(info.index)].sampler);
    out.texCoord = info.texCoord;
    const auto transform = info.extensions.find("KHR_texture_transform");
    if (transform != info.extensions.end()) applyTransform(transform->second, out);
    if (out.texCoord >= UV_SETS) {
      warnings_.add("W_TEXCOORD", "the texture uses a UV set above TEXCOORD_1 and is not drawn", where + "/texCoord");
      return {};
    }
    return out;
  }

  int imageOf(int texture) const {
    const auto& source = document_.model.textures[static_cast<std::size_t>(texture)];
    const auto webp = source.extensions.find("EXT_texture_webp");
    return webp == source.extensions.end() ? source.source : webp->second.Get("source").GetNumberAsInt();
  }

  Sampler samplerOf(int index) {
    Sampler out;
    if (index < 0) return out;
    const auto& source = document_.model.samplers[static_cast<std::size_t>(index)];
    const auto take = [&](int value, const auto& list, std::uint32_t& target) {
      if (value == -1) return;  // tinygltf's "not given"
      if (isOneOf(value, list)) {
        target = static_cast<std::uint32_t>(value);
      } else {
        warnings_.add("W_SAMPLER", "the sampler has an unknown value; the default is used", pointer("samplers", index));
      }
    };
    take(source.wrapS, WRAPS, out.wrapS);
    take(source.wrapT, WRAPS, out.wrapT);
    take(source.magFilter, MAG_FILTERS, out.magFilter);
    take(source.minFilter, MIN_FILTERS, out.minFilter);
    return out;
  }

  /// T * R * S of the extension, in the signs in which three.js 0.187 (GLTFTextureTransformExtension) writes it.
  static void applyTransform(const tinygltf::Value& transform, TextureRef& out) {
    if (transform.Has("texCoord")) out.texCoord = transform.Get("texCoord").GetNumberAsInt();
    out.hasTransform = transform.Has("offset") || transform.Has("rotation") || transform.Has("scale");
    const auto pair = [&](const char* key, double fallback, int i) {
      const auto& list = arrayOf(transform, key);
      return list.empty() ? fallback : list[static_cast<std::size_t>(i)].GetNumberAsDouble();
    };
    const double c = std::cos(numberOf(transform, "rotation", 0)), s = std::sin(numberOf(transform, "rotation", 0));
    const double sx = pair("scale", 1, 0), sy = pair("scale", 1, 1);
    out.uvTransform = glm::mat3(toFloat(sx * c), toFloat(-sx * s), 0.0f,                              // column 0
                                toFloat(sy * s), toFloat(sy * c), 0.0f,                               // column 1
                                toFloat(pair("offset", 0, 0)), toFloat(pair("offset", 0, 1)), 1.0f);  // column 2
  }

  const Document& document_;
  const tinygltf::Material& source_;
  Warnings& warnings_;
  std::string where_;
};

}  // namespace

Material readMaterial(int material, const Document& document, Warnings& warnings) {
  return MaterialReader(material, document, warnings).read();
}

std::vector<TextureRef*> texturesOf(Material& material) {
  std::vector<TextureRef*> out;
  for (TextureRef* texture : {&material.baseColorTexture, &material.metallicRoughnessTexture, &material.normalTexture,
                              &material.occlusionTexture, &material.emissiveTexture}) {
    if (*texture) out.push_back(texture);
  }
  return out;
}

std::vector<const TextureRef*> texturesOf(const Material& material) {
  const auto list = texturesOf(const_cast<Material&>(material));
  return {list.begin(), list.end()};
}

}  // namespace telar::asset
