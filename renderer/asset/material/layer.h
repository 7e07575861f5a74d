#pragma once
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "asset/check/clamped.h"
#include "asset/check/number.h"
#include "asset/document/extension_value.h"
#include "asset/material/texture_ref.h"

namespace telar::asset {

/// One extension of one material, or an object in it; read only where it is there.
class Layer {
 public:
  /// @param where JSON pointer of the material's `extensions`
  Layer(const tinygltf::ExtensionMap& extensions, const char* name, const std::string& where, TextureReader& textures,
        Warnings& warnings)
      : where_(where + "/" + name), textures_(textures), warnings_(warnings) {
    const auto found = extensions.find(name);
    if (found != extensions.end()) source_ = &found->second;
  }

  /// The object at `key` of this one; none where there is none.
  Layer part(const char* key) const { return {*source_, key, where_, textures_, warnings_}; }

  explicit operator bool() const { return source_ != nullptr; }
  const std::string& where() const { return where_; }

  bool has(const char* key) const { return source_->Has(key); }

  double number(const char* key, double fallback) const { return numberOf(*source_, key, fallback); }

  float factor(const char* key, double fallback, double low = 0, double high = 1) const {
    return clamped(number(key, fallback), low, high, where_ + "/" + key, warnings_);
  }

  /// Any angle, radians: within a turn, a float keeps it.
  float angle(const char* key) const { return toFloat(std::remainder(number(key, 0), 2 * std::numbers::pi)); }

  /// 0 stands for the specular-glossiness model: reflection at all angles. src: GLTFLoader, KHR_materials_ior
  float ior(const char* key, double fallback, double low, double high) const {
    return number(key, fallback) == 0 ? toFloat(high) : factor(key, fallback, low, high);
  }

  /// 0 is no distance but the loader's way to say none. src: GLTFLoader, KHR_materials_volume
  float distance(const char* key, double low, double high) const {
    return number(key, 0) != 0 ? factor(key, 0, low, high) : std::numeric_limits<float>::infinity();
  }

  glm::vec3 color(const char* key, float fallback, double high) const {
    glm::vec3 out(fallback);
    const auto& list = arrayOf(*source_, key);
    for (std::size_t i = 0; i < list.size(); ++i) {
      out[static_cast<int>(i)] = clamped(list[i].GetNumberAsDouble(), 0, high, where_ + "/" + key, warnings_);
    }
    return out;
  }

  TextureRef texture(const char* key) const { return textures_.read(*source_, key, where_); }

  /// `scale` of a normal texture.
  float scale(const char* key) const {
    if (!source_->Has(key)) return 1;
    return clamped(numberOf(source_->Get(key), "scale", 1), -NORMAL_SCALE_MAX, NORMAL_SCALE_MAX,
                   where_ + "/" + key + "/scale", warnings_);
  }

 private:
  Layer(const tinygltf::Value& parent, const char* key, const std::string& where, TextureReader& textures,
        Warnings& warnings)
      : where_(where + "/" + key), textures_(textures), warnings_(warnings) {
    if (parent.Has(key)) source_ = &parent.Get(key);
  }

  const tinygltf::Value* source_ = nullptr;  ///< null where the file has none
  std::string where_;
  TextureReader& textures_;
  Warnings& warnings_;
};

}  // namespace telar::asset
