#pragma once
#include <cstddef>

#include "telar/scene.h"

namespace telar {

/// Index of the material that a variant (KHR_materials_variants) gives a primitive; -1 = glTF's default material.
/// @param variant  index into Scene::variants; -1 = the file's own materials
inline int materialIndex(const Primitive& primitive, int variant) {
  if (variant < 0 || static_cast<std::size_t>(variant) >= primitive.variantMaterials.size()) return primitive.material;
  const int mapped = primitive.variantMaterials[static_cast<std::size_t>(variant)];
  return mapped >= 0 ? mapped : primitive.material;
}

}  // namespace telar
