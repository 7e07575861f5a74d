#include "asset/material/physical_layers.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "asset/check/number.h"
#include "asset/material/layer.h"

namespace telar::asset {
namespace {

// The specifications give no upper bounds for these; beyond them the terms of shading leave fp32, and nothing looks
// different any more.
constexpr double IOR_MAX = 1000;
constexpr double SPECULAR_COLOR_MAX = 65504;
constexpr double THICKNESS_MAX = 1e6;  // nanometres
constexpr double VOLUME_MAX = 1e12;    // metres, and as small a part of one
constexpr double DISPERSION_MAX = 40;  // beyond it red light would travel faster than in empty space

/// Each of these makes the material physical for GLTFLoader; bump maps are not drawn.
constexpr const char* PHYSICAL[] = {
    "KHR_materials_anisotropy", "KHR_materials_clearcoat", "KHR_materials_diffuse_roughness",
    "KHR_materials_dispersion", "KHR_materials_ior",       "KHR_materials_iridescence",
    "KHR_materials_sheen",      "KHR_materials_specular",  "KHR_materials_transmission",
    "KHR_materials_volume",     "EXT_materials_bump",
};

void readIor(Layer layer, PhysicalLayers& out) {
  if (!layer) return;
  // 0 stands for the specular-glossiness model: reflection at all angles. src: GLTFLoader, KHR_materials_ior
  out.ior = layer.number("ior", 1.5) == 0 ? toFloat(IOR_MAX) : layer.factor("ior", 1.5, 1, IOR_MAX);
}

void readSpecular(Layer layer, PhysicalLayers& out) {
  if (!layer) return;
  out.specularFactor = layer.factor("specularFactor", 1);
  out.specularTexture = layer.texture("specularTexture");
  out.specularColorFactor = layer.color("specularColorFactor", 1, SPECULAR_COLOR_MAX);
  out.specularColorTexture = layer.texture("specularColorTexture");
}

void readClearcoat(Layer layer, PhysicalLayers& out) {
  if (!layer) return;
  out.clearcoatFactor = layer.factor("clearcoatFactor", 0);
  out.clearcoatRoughnessFactor = layer.factor("clearcoatRoughnessFactor", 0);
  out.clearcoatNormalScale = layer.scale("clearcoatNormalTexture");
  if (out.clearcoatFactor == 0) return;
  out.clearcoatTexture = layer.texture("clearcoatTexture");
  out.clearcoatRoughnessTexture = layer.texture("clearcoatRoughnessTexture");
  out.clearcoatNormalTexture = layer.texture("clearcoatNormalTexture");
}

void readSheen(Layer layer, PhysicalLayers& out) {
  if (!layer) return;
  out.sheen = true;
  out.sheenColorFactor = layer.color("sheenColorFactor", 0, 1);
  out.sheenColorTexture = layer.texture("sheenColorTexture");
  out.sheenRoughnessFactor = layer.factor("sheenRoughnessFactor", 0);
  out.sheenRoughnessTexture = layer.texture("sheenRoughnessTexture");
}

void readAnisotropy(Layer layer, PhysicalLayers& out) {
  if (!layer) return;
  out.anisotropyStrength = layer.factor("anisotropyStrength", 0);
  // Within a turn, a float keeps the angle.
  out.anisotropyRotation = toFloat(std::remainder(layer.number("anisotropyRotation", 0), 2 * std::numbers::pi));
  if (out.anisotropyStrength > 0) out.anisotropyTexture = layer.texture("anisotropyTexture");
}

void readIridescence(Layer layer, PhysicalLayers& out) {
  if (!layer) return;
  out.iridescenceFactor = layer.factor("iridescenceFactor", 0);
  out.iridescenceIor = layer.factor("iridescenceIor", 1.3, 1, IOR_MAX);
  out.iridescenceThicknessMinimum = layer.factor("iridescenceThicknessMinimum", 100, 0, THICKNESS_MAX);
  out.iridescenceThicknessMaximum = layer.factor("iridescenceThicknessMaximum", 400, 0, THICKNESS_MAX);
  if (out.iridescenceFactor == 0) return;
  out.iridescenceTexture = layer.texture("iridescenceTexture");
  out.iridescenceThicknessTexture = layer.texture("iridescenceThicknessTexture");
}

void readDiffuseRoughness(Layer layer, PhysicalLayers& out) {
  if (!layer) return;
  out.diffuseRoughnessFactor = layer.factor("diffuseRoughnessFactor", 0);
  if (out.diffuseRoughnessFactor > 0) out.diffuseRoughnessTexture = layer.texture("diffuseRoughnessTexture");
}

void readTransmission(Layer layer, PhysicalLayers& out) {
  if (!layer) return;
  out.transmissionFactor = layer.factor("transmissionFactor", 0);
  if (out.transmissionFactor > 0) out.transmissionTexture = layer.texture("transmissionTexture");
}

/// What only transmitted light shows: nothing is read for a material that transmits none.
void readVolume(Layer layer, PhysicalLayers& out) {
  if (!layer) return;
  out.thicknessFactor = layer.factor("thicknessFactor", 0, 0, VOLUME_MAX);
  if (out.transmissionFactor > 0 && out.thicknessFactor > 0) {
    out.thicknessTexture = layer.texture("thicknessTexture");
  }
  // 0 is no distance but the loader's way to say none. src: GLTFLoader, KHR_materials_volume
  if (layer.number("attenuationDistance", 0) != 0) {
    out.attenuationDistance = layer.factor("attenuationDistance", 0, 1 / VOLUME_MAX, VOLUME_MAX);
  }
  out.attenuationColor = layer.color("attenuationColor", 1, 1);
}

void readDispersion(Layer layer, PhysicalLayers& out) {
  if (layer) out.dispersion = layer.factor("dispersion", 0, 0, DISPERSION_MAX);
}

}  // namespace

bool readPhysicalLayers(const tinygltf::ExtensionMap& extensions, const std::string& where, TextureReader& textures,
                        Warnings& warnings, PhysicalLayers& out) {
  const auto layer = [&](const char* name) { return Layer(extensions, name, where, textures, warnings); };
  readIor(layer("KHR_materials_ior"), out);
  readSpecular(layer("KHR_materials_specular"), out);
  readClearcoat(layer("KHR_materials_clearcoat"), out);
  readSheen(layer("KHR_materials_sheen"), out);
  readAnisotropy(layer("KHR_materials_anisotropy"), out);
  readIridescence(layer("KHR_materials_iridescence"), out);
  readDiffuseRoughness(layer("KHR_materials_diffuse_roughness"), out);
  readTransmission(layer("KHR_materials_transmission"), out);
  readVolume(layer("KHR_materials_volume"), out);
  readDispersion(layer("KHR_materials_dispersion"), out);
  return std::any_of(std::begin(PHYSICAL), std::end(PHYSICAL),
                     [&](const char* name) { return extensions.contains(name); });
}

}  // namespace telar::asset
