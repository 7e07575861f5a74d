#pragma once
#include <array>

#include "shader/variant_key.h"
#include "telar/material_textures.inc"
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
  bool shader::VariantKey::*layer;  ///< that it belongs to; null = metallic-roughness
};

#define TELAR_TEXTURE_SLOT(field, name, srgb, feature)                        \
  TextureSlot{[](const Material& m) -> const TextureRef& { return m.field; }, \
              &shader::VariantKey::name##Map,                                 \
              &shader::VariantKey::name##Uv1,                                 \
              #name "Map",                                                    \
              #name "UvTransform",                                            \
              srgb,                                                           \
              feature},
#define TELAR_CORE_SLOT(field, name, srgb, none) TELAR_TEXTURE_SLOT(field, name, srgb, nullptr)
#define TELAR_LAYER_SLOT(field, name, srgb, layer) TELAR_TEXTURE_SLOT(field, name, srgb, &shader::VariantKey::layer)

/// Every texture that a program may sample; a texture's place in the list is its texture unit.
inline constexpr std::array TEXTURE_SLOTS{TELAR_CORE_TEXTURES(TELAR_CORE_SLOT) TELAR_LAYER_TEXTURES(TELAR_LAYER_SLOT)};

#undef TELAR_LAYER_SLOT
#undef TELAR_CORE_SLOT
#undef TELAR_TEXTURE_SLOT

}  // namespace telar::pass
