#include "asset/material/fabric_layers.h"

#include "asset/material/layer.h"

namespace telar::asset {
namespace {

Yarn readYarn(const Layer& in) {
  Yarn out;
  if (!in) return out;
#include "asset/yarn_readers.inc"
  return out;
}

void readWeave(const Layer& in, FabricLayers& out, Warnings& warnings) {
  if (!in) return;
  out.warp = readYarn(in.part("warp"));
  out.weft = readYarn(in.part("weft"));
  const float sum = out.warp.coverage + out.weft.coverage;
  out.weave = sum > 0;  // without yarns there is the one highlight of the material
  if (sum > 1) {
    warnings.add("W_RANGE", "the coverages of warp and weft sum to more than 1 and were scaled down", in.where());
    out.warp.coverage /= sum;
    out.weft.coverage /= sum;
  }
#include "asset/weave_readers.inc"
  out.weaveTexture = in.texture("weaveTexture");
}

void readBack(const Layer& layer, const Material& front, FabricLayers& out) {
  if (!layer) return;
  out.back = true;
  out.backRoughnessFactor = layer.factor("roughnessFactor", static_cast<double>(front.roughnessFactor));
  out.backHasColor = layer.has("baseColorFactor") || layer.has("baseColorTexture");
  if (out.backHasColor) {
    out.backColorFactor = layer.color("baseColorFactor", 1, 1);
    out.backColorTexture = layer.texture("baseColorTexture");
  }
  colorBack(front, out);
}

}  // namespace

void colorBack(const Material& front, FabricLayers& fabric) {
  if (!fabric.back || fabric.backHasColor) return;
  fabric.backColorFactor = glm::vec3(front.baseColorFactor);
  fabric.backColorTexture = front.baseColorTexture;
}

FabricLayers readFabricLayers(const tinygltf::ExtensionMap& extensions, const Material& front, const std::string& where,
                              const std::string& fabricWhere, TextureReader& textures, Warnings& warnings) {
  FabricLayers out;
  // In a preset's file TELAR_materials_fabric may stand apart.
  const auto layer = [&](const std::string& name) {
    const bool own = name == "TELAR_materials_fabric";
    return Layer(extensions, name.c_str(), own ? fabricWhere : where, textures, warnings);
  };
#include "asset/fabric_readers.inc"
  const Layer fabric = layer("TELAR_materials_fabric");
  if (!fabric) return out;
  readWeave(fabric.part("weave"), out, warnings);
  readBack(fabric.part("back"), front, out);
  return out;
}

}  // namespace telar::asset
