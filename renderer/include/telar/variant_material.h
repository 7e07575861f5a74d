#pragma once
#include <cstddef>

#include "telar/scene.h"

namespace telar {

/// Index of the material that a variant (KHR_materials_variants) gives a primitive; -1 = glTF's default material.
/// @param variant  index into Scene::variants; -1 = the file's own materials
inline int materialIndex(const Primitive& primitive, int variant) {
  const auto mapped = primitive.variantMaterials.find(variant);
  return mapped == primitive.variantMaterials.end() ? primitive.material : mapped->second;
}

}  // namespace telar
