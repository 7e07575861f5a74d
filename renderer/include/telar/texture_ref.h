#pragma once
#include <cstdint>
#include <glm/glm.hpp>

namespace telar {

/// Values are the GL enums that glTF uses (10497 REPEAT, 9729 LINEAR, 9987 LINEAR_MIPMAP_LINEAR, ...).
struct Sampler {
  std::uint32_t wrapS = 10497;
  std::uint32_t wrapT = 10497;
  std::uint32_t magFilter = 9729;
  std::uint32_t minFilter = 9987;
  bool operator==(const Sampler&) const = default;
  /// Or level 0 alone.
  bool readsMipLevels() const { return minFilter != 9728 && minFilter != 9729; }
};

/// One use of a texture by a material.
struct TextureRef {
  int image = -1;       ///< index into Scene::images, -1 = no texture
  bool basisu = false;  ///< has it by KHR_texture_basisu
  Sampler sampler;
  int texCoord = 0;             ///< 0 or 1, after KHR_texture_transform's override
  glm::mat3 uvTransform{1.0f};  ///< KHR_texture_transform as three.js builds it: uv' = uvTransform * (u, v, 1)
  bool hasTransform = false;
  bool placed = false;  ///< uvTransform is the matrix of a cloth on a garment: no release takes it apart
  explicit operator bool() const { return image >= 0; }
};

}  // namespace telar
