#include "asset/material/fabric_layers.h"

#include "asset/material/layer.h"

namespace telar::asset {
namespace {

constexpr double THREADS_MAX = 1e6;  // per unit of u or v: finer than any texture

Yarn readYarn(Layer layer) {
  Yarn out;
  if (!layer) return out;
  out.coverage = layer.factor("coverage", static_cast<double>(out.coverage));
  out.roughness = layer.factor("roughnessFactor", static_cast<double>(out.roughness));
  out.anisotropy = layer.factor("anisotropyStrength", static_cast<double>(out.anisotropy));
  out.specularColor = layer.color("specularColorFactor", 1, 1);
  return out;
}

void readWeave(Layer layer, FabricLayers& out, Warnings& warnings) {
  if (!layer) return;
  out.warp = readYarn(layer.part("warp"));
  out.weft = readYarn(layer.part("weft"));
  const float sum = out.warp.coverage + out.weft.coverage;
  out.weave = sum > 0;  // without yarns there is the one highlight of the material
  if (sum > 1) {
    warnings.add("W_RANGE", "the coverages of warp and weft sum to more than 1 and were scaled down", layer.where());
    out.warp.coverage /= sum;
    out.weft.coverage /= sum;
  }
  const glm::vec3 threads = layer.color("threadsPerUv", 0, THREADS_MAX);
  out.threadsPerUv = {threads.x, threads.y};
  out.weaveTexture = layer.texture("weaveTexture");
}

/// What the back leaves out is as on the front.
void readBack(Layer layer, const Material& front, FabricLayers& out) {
  if (!layer) return;
  out.back = true;
  out.backRoughnessFactor = layer.factor("roughnessFactor", static_cast<double>(front.roughnessFactor));
  if (layer.has("baseColorFactor") || layer.has("baseColorTexture")) {
    out.backColorFactor = layer.color("baseColorFactor", 1, 1);
    out.backColorTexture = layer.texture("baseColorTexture");
  } else {
    out.backColorFactor = glm::vec3(front.baseColorFactor);
    out.backColorTexture = front.baseColorTexture;
  }
}

}  // namespace

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
