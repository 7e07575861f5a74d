#include "frame/layers.h"

#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>
#include <set>

#include "frame/variant.h"
#include "telar/layers.h"

namespace telar::frame {
namespace {

using Json = nlohmann::ordered_json;

const std::string& nameOf(const Scene& scene, const Node& node) {
  return node.name.empty() ? scene.meshes[static_cast<std::size_t>(node.mesh)].name : node.name;
}

}  // namespace

std::shared_ptr<const Material> plainMaterial(const Material& m) {
  auto plain = std::make_shared<Material>();
  plain->baseColorFactor = m.baseColorFactor, plain->baseColorTexture = m.baseColorTexture;
  plain->metallicFactor = 0;
  plain->normalTexture = m.normalTexture, plain->normalScale = m.normalScale;
  plain->alphaMode = m.alphaMode, plain->alphaCutoff = m.alphaCutoff;
  plain->doubleSided = m.doubleSided;
  plain->physical = m.physical;
  plain->layers.bumpTexture = m.layers.bumpTexture, plain->layers.bumpFactor = m.layers.bumpFactor;
  plain->fabric.back = m.fabric.back, plain->fabric.backColorFactor = m.fabric.backColorFactor;
  plain->fabric.backColorTexture = m.fabric.backColorTexture;
  return plain;
}

LayerIds::LayerIds(const Scene& scene) : scene_(scene) {
  int count = 0;
  for (const Node& node : scene.nodes) parts_.push_back(node.mesh < 0 ? 0 : ++count);
}

float LayerIds::part(const Node& node) const {
  return static_cast<float>(parts_[static_cast<std::size_t>(&node - scene_.nodes.data())]);
}

float LayerIds::material(int index) const {
  return static_cast<float>(index < 0 ? scene_.materials.size() + 1 : static_cast<std::size_t>(index) + 1);
}

Json LayerIds::parts() const {
  Json legend = Json::array();
  for (const Node& node : scene_.nodes) {
    if (node.mesh >= 0)
      legend.push_back(
          {{"id", static_cast<int>(part(node))}, {"node", node.file.node}, {"name", nameOf(scene_, node)}});
  }
  return legend;
}

Json LayerIds::materials(const std::string& variant) const {
  const int index = variantIndex(scene_, variant);
  std::set<int> used;
  for (const Node& node : scene_.nodes) {
    if (node.mesh < 0) continue;
    for (const Primitive& primitive : scene_.meshes[static_cast<std::size_t>(node.mesh)].primitives)
      used.insert(materialIndex(node, primitive, index));
  }
  Json legend = Json::array();
  for (const int i : used) {
    const bool own = i >= 0;
    legend.push_back({{"id", static_cast<int>(material(i))},
                      {"material", own ? Json(i) : Json(nullptr)},
                      {"name", own ? scene_.materials[static_cast<std::size_t>(i)].name : std::string()}});
  }
  return legend;
}

Json describeLayers(const Scene& scene, const Shot& shot, const std::vector<LayerImage>& layers) {
  const LayerIds ids(scene);
  Json out = Json::object();
  for (const LayerImage& layer : layers) {
    Json& facts = out[std::string(namesOf(layer.layer)[static_cast<std::size_t>(layer.layer)])] = Json::object();
    if (layer.layer == Layer::kPartId) facts["legend"] = ids.parts();
    if (layer.layer == Layer::kMaterialId) facts["legend"] = ids.materials(shot.variant);
    if (layer.layer == Layer::kDepth) {
      const DepthRange range = depthRange(layer);
      facts["range"] = {range.min, range.max};
    }
  }
  return out;
}

bool alphaIsCoverage(const Shot& shot) {
  return shot.background.type == Shot::Background::Type::kTransparent && !shot.ground;
}

Shot coverageShot(const Shot& shot) {
  Shot plain = shot;
  plain.environment = {};
  plain.lights.clear();
  plain.modelLights = false;
  plain.background = {};
  plain.ground.reset();
  plain.layers.clear();
  if (plain.reference) plain.reference->transport = Shot::Reference::Transport::kDirect;
  return plain;
}

LayerImage coverageLayer(const Frame& frame) {
  const std::size_t count = std::size_t{frame.width} * frame.height;
  LayerImage image{Layer::kCoverage, std::vector<float>(count)};
  for (std::size_t i = 0; i < count; ++i) {
    if (frame.type == PixelType::kRgba8)
      image.pixels[i] = static_cast<float>(std::to_integer<int>(frame.pixels[4 * i + 3])) / 255.0f;
    else
      std::memcpy(&image.pixels[i], &frame.pixels[(4 * i + 3) * sizeof(float)], sizeof(float));
  }
  return image;
}

}  // namespace telar::frame
