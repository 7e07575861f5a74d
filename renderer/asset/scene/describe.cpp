#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <utility>
#include <vector>

#include "asset/scene/json_vector.h"
#include "asset/scene/outline.h"
#include "telar/dress.h"
#include "telar/load.h"
#include "telar/material_textures.inc"
#include "telar/variant_material.h"

namespace telar {
namespace {

using json = nlohmann::ordered_json;

double degrees(double radians) { return radians * 180.0 / std::numbers::pi; }

const char* nameOf(AlphaMode mode) {
  switch (mode) {
    case AlphaMode::kMask:
      return "MASK";
    case AlphaMode::kBlend:
      return "BLEND";
    default:
      return "OPAQUE";
  }
}

const char* nameOf(LightType type) {
  switch (type) {
    case LightType::kDirectional:
      return "directional";
    case LightType::kSpot:
      return "spot";
    default:
      return "point";
  }
}

/// What of a material only the shading "fabric" reads; null where there is nothing.
json describeFabric(const Material& material) {
  const FabricLayers& fabric = material.fabric;
  json out = json::object();
  if (fabric.diffuseTransmissionFactor > 0) out["diffuseTransmission"] = fabric.diffuseTransmissionFactor;
  if (fabric.flatness > 0) out["flatness"] = fabric.flatness;
  if (fabric.weave) {
    out["weave"] = {{"warp", fabric.warp.coverage},
                    {"weft", fabric.weft.coverage},
                    {"threadsPerUv", {fabric.threadsPerUv.x, fabric.threadsPerUv.y}}};
  }
  if (fabric.back) out["back"] = true;
  return out.empty() ? json(nullptr) : out;
}

/// @param worn the same with its preset
json describe(const Material& material, const Material& worn) {
  json textures = json::array();
#define TELAR_TEXTURE_NAME(field, name, srgb, feature) \
  if (material.field) textures.push_back(#name);
  TELAR_MATERIAL_TEXTURES(TELAR_TEXTURE_NAME)
#undef TELAR_TEXTURE_NAME
  return {{"name", material.name},
          {"alphaMode", nameOf(material.alphaMode)},
          {"doubleSided", material.doubleSided},
          {"unlit", material.unlit},
          {"metallic", material.metallicFactor},
          {"roughness", material.roughnessFactor},
          {"textures", textures},
          {"preset", material.preset.empty() ? json(nullptr) : json(material.preset)},
          {"fabric", describeFabric(worn)}};
}

json describe(const Image8& image) {
  json out = {{"width", image.width}, {"height", image.height}};
  if (!image.format.empty()) out["format"] = image.format;
  if (image.ownLevels) out["levels"] = 1 + image.smallerLevels.size();
  return out;
}

json describe(const ModelLight& light, const Node& node) {
  const glm::dvec3 position(node.world[3]);
  json out = {{"name", light.name.empty() ? node.name : light.name},
              {"type", nameOf(light.type)},
              {"color", list(light.color)},
              {"intensity", light.intensity},
              {"position", list(position)},
              {"range", light.range}};
  if (light.type == LightType::kSpot) {
    out["innerConeAngle"] = light.innerConeAngle;
    out["outerConeAngle"] = light.outerConeAngle;
  }
  return out;
}

glm::dvec3 unit(const glm::dvec3& v, const glm::dvec3& fallback) {
  const double length = glm::length(v);
  return length > 0 && std::isfinite(length) ? v / length : fallback;
}

/// Looks along the node's -Z; the target is the point of that ray which is nearest to the scene's centre.
json describe(const ModelCamera& camera, const Node& node, const Bounds& bounds) {
  const glm::dvec3 position(node.world[3]);
  const glm::dvec3 forward = unit(-glm::dvec3(node.world[2]), {0, 0, -1});
  const double distance = glm::dot(bounds.middle() - position, forward);
  const glm::dvec3 target = position + forward * (distance > 0 ? distance : 1.0);
  json out = {{"name", camera.name.empty() ? node.name : camera.name},
              {"node", node.file.node},
              {"projection", camera.perspective ? "perspective" : "orthographic"}};
  if (camera.perspective) {
    out["fovY"] = degrees(camera.fovY);
    if (camera.aspectRatio > 0) out["aspectRatio"] = camera.aspectRatio;
  } else {
    out["height"] = 2 * camera.ymag;
    out["width"] = 2 * camera.xmag;
  }
  out["near"] = camera.near;
  out["far"] = camera.far > 0 ? json(camera.far) : json(nullptr);
  out["position"] = list(position);
  out["target"] = list(target);
  out["up"] = list(unit(glm::dvec3(node.world[1]), {0, 1, 0}));
  return out;
}

json describe(const Warning& warning) {
  json out = {{"code", warning.code}, {"message", warning.message}};
  if (!warning.pointer.empty()) out["pointer"] = warning.pointer;
  return out;
}

json describeLights(const Scene& scene) {
  json out = json::array();
  for (const Node& node : scene.nodes) {
    if (node.light >= 0) out.push_back(describe(scene.lights[static_cast<std::size_t>(node.light)], node));
  }
  return out;
}

json describeAnimations(const Scene& scene) {
  json out = json::array();
  if (!scene.motion) return out;
  for (const Animation& animation : scene.motion->animations) {
    out.push_back({{"name", animation.name}, {"duration", animation.duration}});
  }
  return out;
}

json describeCameras(const Scene& scene) {
  std::vector<std::pair<int, std::size_t>> placed;  // camera and node
  for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
    if (scene.nodes[i].camera >= 0) placed.emplace_back(scene.nodes[i].camera, i);
  }
  std::sort(placed.begin(), placed.end());
  json out = json::array();
  for (const auto& [camera, node] : placed) {
    out.push_back(describe(scene.cameras[static_cast<std::size_t>(camera)], scene.nodes[node], scene.bounds));
  }
  return out;
}

std::size_t cornersOf(const Primitive& primitive) {
  return primitive.indices.empty() ? primitive.positions.size() : primitive.indices.size();
}

/// So many materials of a variant are listed.
constexpr std::size_t VARIANT_MATERIALS_MAX = 8;

/// What each variant draws, those of most corners first, ties in the file's order. A file may have thousands of
/// variants and of materials: what no variant changes is counted once, and each adds what it changes.
json describeVariants(const Scene& scene) {
  if (scene.variants.empty()) return json::array();
  const auto known = [&scene](int i) { return i >= 0 && static_cast<std::size_t>(i) < scene.fileMaterials; };
  std::map<int, std::int64_t> all;
  std::vector<std::map<int, std::int64_t>> changes(scene.variants.size());
  for (const Node& node : scene.nodes) {
    if (node.mesh < 0) continue;
    for (const Primitive& primitive : scene.meshes[static_cast<std::size_t>(node.mesh)].primitives) {
      const auto corners = static_cast<std::int64_t>(cornersOf(primitive) * node.places());
      if (known(primitive.material)) all[primitive.material] += corners;
      for (const auto& [variant, material] : primitive.variantMaterials) {
        if (variant < 0 || static_cast<std::size_t>(variant) >= changes.size()) continue;
        auto& change = changes[static_cast<std::size_t>(variant)];
        if (known(primitive.material)) change[primitive.material] -= corners;
        if (known(material)) change[material] += corners;
      }
    }
  }
  using Drawn = std::pair<int, std::int64_t>;
  const auto byCorners = [](const Drawn& p, const Drawn& q) {
    return p.second != q.second ? p.second > q.second : p.first < q.first;
  };
  std::vector<Drawn> most(all.begin(), all.end());
  std::sort(most.begin(), most.end(), byCorners);
  json out = json::array();
  for (const auto& change : changes) {
    std::vector<Drawn> drawn;
    for (const auto& [material, corners] : change) {
      const auto base = all.find(material);
      drawn.emplace_back(material, corners + (base == all.end() ? 0 : base->second));
    }
    for (std::size_t i = 0, taken = 0; i < most.size() && taken < VARIANT_MATERIALS_MAX; ++i) {
      if (!change.contains(most[i].first)) drawn.push_back(most[i]), ++taken;
    }
    std::erase_if(drawn, [](const Drawn& d) { return d.second <= 0; });
    std::sort(drawn.begin(), drawn.end(), byCorners);
    json materials = json::array();
    for (std::size_t i = 0; i < std::min(drawn.size(), VARIANT_MATERIALS_MAX); ++i) materials.push_back(drawn[i].first);
    out.push_back(materials);
  }
  return out;
}

template <class List>
json describeAll(const List& list) {
  json out = json::array();
  for (const auto& item : list) out.push_back(describe(item));
  return out;
}

json describeMaterials(const Scene& scene) {
  json out = json::array();
  for (std::size_t i = 0; i < scene.fileMaterials; ++i) {
    const Material& material = scene.materials[i];
    out.push_back(describe(material, shownMaterial(scene, material, ShadingModel::kFabric)));
  }
  return out;
}

}  // namespace

std::string describeScene(const Scene& scene, const CancelToken& cancel) {
  const bool empty = scene.bounds.empty();
  json out;
  out["name"] = scene.name;
  out["bounds"] = empty ? json(nullptr) : json{{"min", list(scene.bounds.min)}, {"max", list(scene.bounds.max)}};
  out["outline"] = json::array();
  for (const glm::dvec3& point : asset::outlineOf(scene, cancel)) out["outline"].push_back(list(point));
  out["size"] = empty ? json{0, 0, 0} : list(scene.bounds.max - scene.bounds.min);
  out["nodes"] = scene.nodes.size();
  out["meshes"] = scene.fileMeshes;
  out["drawCalls"] = scene.drawCount;
  out["vertices"] = scene.vertexCount;
  out["triangles"] = scene.triangleCount;
  out["fileBytes"] = scene.fileBytes;
  out["sha256"] = scene.sha256;
  out["materials"] = describeMaterials(scene);
  out["images"] = describeAll(scene.images);
  out["lights"] = describeLights(scene);
  out["cameras"] = describeCameras(scene);
  out["animations"] = describeAnimations(scene);
  out["variants"] = scene.variants;
  out["variantMaterials"] = describeVariants(scene);
  out["extensionsUsed"] = scene.extensionsUsed;
  out["generator"] = scene.generator;
  out["copyright"] = scene.copyright;
  out["warnings"] = describeAll(scene.warnings);
  return out.dump();
}

std::string describeDressed(const Scene& scene) {
  return json{{"materials", describeMaterials(scene)},
              {"images", describeAll(scene.images)},
              {"warnings", describeAll(scene.warnings)}}
      .dump();
}

std::string describeUvScales(const Scene& scene, const CancelToken& cancel) {
  json out = json::array();
  for (const auto& metres : metresPerUv(scene, std::vector<bool>(scene.fileMaterials, true), cancel)) {
    out.push_back(metres ? json{metres->x, metres->y} : json(nullptr));
  }
  return out.dump();
}

std::string describeNames(const Scene& scene) {
  json out = {{"materials", json::array()}, {"nodes", json::array()}};
  for (std::size_t i = 0; i < scene.fileMaterials; ++i) out["materials"].push_back(scene.materials[i].name);
  for (const Node& node : scene.nodes) {
    out["nodes"].push_back({{"node", node.file.node}, {"name", node.name}, {"parent", node.parent}});
  }
  return out.dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace telar
