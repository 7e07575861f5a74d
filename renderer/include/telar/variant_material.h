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

/// The one that is drawn: a node that is dressed shows another than its mesh has.
inline int materialIndex(const Node& node, const Primitive& primitive, int variant) {
  const int own = materialIndex(primitive, variant);
  if (!node.materials) return own;
  const auto worn = node.materials->find(own);
  return worn == node.materials->end() ? own : worn->second;
}

}  // namespace telar
