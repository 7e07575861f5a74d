#pragma once
#include <array>

#include "shader/variant_key.h"
#include "telar/scene.h"

namespace telar::pass {

/// One texture of a material and what it is called in shaders/material.
struct TextureSlot {
  const TextureRef& (*texture)(const Material&);
  bool shader::VariantKey::*map;  ///< sampled at all
  bool shader::VariantKey::*uv1;  ///< with the second UV set
  const char* sampler;
  const char* uvTransform;
  bool srgb;
};

#define TELAR_TEXTURE_SLOT(member, name, srgb)                                                       \
  TextureSlot {                                                                                      \
    [](const Material& m) -> const TextureRef& { return m.member; }, &shader::VariantKey::name##Map, \
        &shader::VariantKey::name##Uv1, #name "Map", #name "UvTransform", srgb                       \
  }

/// Every texture that a program may sample; a texture's place in the list is its texture unit.
inline constexpr std::array TEXTURE_SLOTS{
    TELAR_TEXTURE_SLOT(baseColorTexture, baseColor, true),
    TELAR_TEXTURE_SLOT(metallicRoughnessTexture, metallicRoughness, false),
    TELAR_TEXTURE_SLOT(normalTexture, normal, false),
    TELAR_TEXTURE_SLOT(occlusionTexture, occlusion, false),
    TELAR_TEXTURE_SLOT(emissiveTexture, emissive, true),
    TELAR_TEXTURE_SLOT(layers.specularTexture, specular, false),
    TELAR_TEXTURE_SLOT(layers.specularColorTexture, specularColor, true),
    TELAR_TEXTURE_SLOT(layers.clearcoatTexture, clearcoat, false),
    TELAR_TEXTURE_SLOT(layers.clearcoatRoughnessTexture, clearcoatRoughness, false),
    TELAR_TEXTURE_SLOT(layers.clearcoatNormalTexture, clearcoatNormal, false),
    TELAR_TEXTURE_SLOT(layers.sheenColorTexture, sheenColor, true),
    TELAR_TEXTURE_SLOT(layers.sheenRoughnessTexture, sheenRoughness, false),
    TELAR_TEXTURE_SLOT(layers.anisotropyTexture, anisotropy, false),
    TELAR_TEXTURE_SLOT(layers.iridescenceTexture, iridescence, false),
    TELAR_TEXTURE_SLOT(layers.iridescenceThicknessTexture, iridescenceThickness, false),
    TELAR_TEXTURE_SLOT(layers.diffuseRoughnessTexture, diffuseRoughness, false),
    TELAR_TEXTURE_SLOT(layers.transmissionTexture, transmission, false),
    TELAR_TEXTURE_SLOT(layers.thicknessTexture, thickness, false),
    TELAR_TEXTURE_SLOT(fabric.diffuseTransmissionTexture, diffuseTransmission, false),
    TELAR_TEXTURE_SLOT(fabric.diffuseTransmissionColorTexture, diffuseTransmissionColor, true),
    TELAR_TEXTURE_SLOT(fabric.weaveTexture, weave, false),
    TELAR_TEXTURE_SLOT(fabric.backColorTexture, backColor, true),
};
#undef TELAR_TEXTURE_SLOT

}  // namespace telar::pass
