#pragma once
#include <cstdint>
#include <glm/glm.hpp>

namespace telar {

/// How a texture is read: values are the GL enums that glTF uses.
struct Sampler {
  static constexpr std::uint32_t REPEAT = 10497, CLAMP_TO_EDGE = 33071, MIRRORED_REPEAT = 33648;
  static constexpr std::uint32_t NEAREST = 9728, LINEAR = 9729;
  static constexpr std::uint32_t NEAREST_MIPMAP_NEAREST = 9984, LINEAR_MIPMAP_NEAREST = 9985;
  static constexpr std::uint32_t NEAREST_MIPMAP_LINEAR = 9986, LINEAR_MIPMAP_LINEAR = 9987;

  std::uint32_t wrapS = REPEAT;
  std::uint32_t wrapT = REPEAT;
  std::uint32_t magFilter = LINEAR;
  std::uint32_t minFilter = LINEAR_MIPMAP_LINEAR;
  bool operator==(const Sampler&) const = default;
  /// Or level 0 alone.
  bool readsMipLevels() const { return minFilter != NEAREST && minFilter != LINEAR; }
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
