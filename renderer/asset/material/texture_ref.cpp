#include "asset/material/texture_ref.h"

#include <algorithm>
#include <cmath>

#include "asset/check/number.h"
#include "asset/check/pointer.h"
#include "asset/document/extension_value.h"

namespace telar::asset {
namespace {

constexpr int UV_SETS = 2;

constexpr std::uint32_t WRAPS[] = {Sampler::CLAMP_TO_EDGE, Sampler::MIRRORED_REPEAT, Sampler::REPEAT};
constexpr std::uint32_t MAG_FILTERS[] = {Sampler::NEAREST, Sampler::LINEAR};
constexpr std::uint32_t MIN_FILTERS[] = {Sampler::NEAREST,
                                         Sampler::LINEAR,
                                         Sampler::NEAREST_MIPMAP_NEAREST,
                                         Sampler::LINEAR_MIPMAP_NEAREST,
                                         Sampler::NEAREST_MIPMAP_LINEAR,
                                         Sampler::LINEAR_MIPMAP_LINEAR};

template <std::size_t N>
bool isOneOf(int value, const std::uint32_t (&list)[N]) {
  return std::find(std::begin(list), std::end(list), static_cast<std::uint32_t>(value)) != std::end(list);
}

/// T * R * S of the extension, in the signs in which three.js 0.187 (GLTFTextureTransformExtension) writes it.
void applyTransform(const tinygltf::Value& transform, TextureRef& out) {
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

/// The image of a texture: of several that which three.js asks for first.
void takeImage(const tinygltf::Texture& texture, TextureRef& out) {
  const auto takeFrom = [&](const char* name) {
    const auto extension = texture.extensions.find(name);
    if (extension == texture.extensions.end()) return false;
    out.image = extension->second.Get("source").GetNumberAsInt();
    return true;
  };
  out.image = texture.source;
  out.basisu = takeFrom("KHR_texture_basisu");
  if (!out.basisu) takeFrom("EXT_texture_webp");
}

}  // namespace

TextureRef TextureReader::read(int texture, int texCoord, const tinygltf::Value* transform, const std::string& where) {
  TextureRef out;
  const auto& source = document_.model.textures[static_cast<std::size_t>(texture)];
  takeImage(source, out);
  if (out.image < 0) {
    warnings_.add("W_TEXTURE", "the texture has no image that telar reads and is not drawn",
                  pointer("textures", texture));
    return {};
  }
  out.sampler = samplerOf(source.sampler);
  out.texCoord = texCoord;
  if (transform) applyTransform(*transform, out);
  if (out.texCoord >= UV_SETS) {
    warnings_.add("W_TEXCOORD", "the texture uses a UV set above TEXCOORD_1 and is not drawn", where + "/texCoord");
    return {};
  }
  return out;
}

TextureRef TextureReader::read(const tinygltf::Value& extension, const char* key, const std::string& where) {
  if (!extension.Has(key)) return {};
  const tinygltf::Value& info = extension.Get(key);
  const int texCoord = info.Has("texCoord") ? info.Get("texCoord").GetNumberAsInt() : 0;
  const bool transformed = info.Has("extensions") && info.Get("extensions").Has("KHR_texture_transform");
  const tinygltf::Value* transform = transformed ? &info.Get("extensions").Get("KHR_texture_transform") : nullptr;
  return read(info.Get("index").GetNumberAsInt(), texCoord, transform, where + "/" + key);
}

Sampler TextureReader::samplerOf(int index) {
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

}  // namespace telar::asset
