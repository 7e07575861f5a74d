#include "asset/document/fabric_presets.h"

#include <nlohmann/json.hpp>

#include "asset/check/pointer.h"
#include "core/dye.h"

namespace telar::asset {
namespace {

using nlohmann::json;

constexpr const char* NAME = "TELAR_materials_fabric";

/// Whether the material had it in its extras alone.
bool takeFromExtras(json& material) {
  const auto extras = material.find("extras");
  if (extras == material.end()) return false;
  const json fabric = extras->value(NAME, json());
  material.erase(extras);
  if (fabric.is_null() || (material.contains("extensions") && material["extensions"].contains(NAME))) return false;
  material["extensions"][NAME] = fabric;
  return true;
}

/// tinygltf drops empty objects, but a weave with all its defaults is one.
void keepWeave(json& fabric) {
  const auto weave = fabric.find("weave");
  if (weave != fabric.end() && weave->empty()) (*weave)["threadsPerUv"] = {0.0, 0.0};
}

/// The object, whose preset may be missing; null where the material has none.
json* fabricOf(json& material) {
  const auto extensions = material.find("extensions");
  return extensions != material.end() && extensions->contains(NAME) ? &(*extensions)[NAME] : nullptr;
}

/// Multiplies a preset's colour by what the dye leaves of it.
void dye(json& filled, const char* extension, const char* key, const glm::vec3& dye) {
  json& layer = filled["extensions"][extension];
  const json undyed = layer.value(key, json::array({1, 1, 1}));
  for (std::size_t i = 0; i < 3; ++i) layer[key][i] = undyed.at(i).get<float>() * dye[static_cast<int>(i)];
}

/// The preset's sheen, and its light that passes through, in the colour of a material that says nothing of them.
void dyeLayers(json& filled, const json& own) {
  const json color = filled["pbrMetallicRoughness"].value("baseColorFactor", json());
  if (!color.is_array()) return;
  glm::vec3 base(1);
  for (int i = 0; i < 3; ++i) base[i] = color.at(static_cast<std::size_t>(i)).get<float>();
  const auto says = [](const json& material, const std::string& path) {
    return material.contains(json::json_pointer("/extensions/" + path));
  };
  const std::string sheen = "KHR_materials_sheen", through = "KHR_materials_diffuse_transmission";
  if (says(filled, sheen + "/sheenColorFactor") && !says(own, sheen + "/sheenColorFactor")) {
    dye(filled, sheen.c_str(), "sheenColorFactor", sheenDye(base));
  }
  if (says(filled, through) && !says(own, through + "/diffuseTransmissionColorFactor")) {
    dye(filled, through.c_str(), "diffuseTransmissionColorFactor", transmissionDye(base));
  }
}

std::string namesOf(const json& presets) {
  std::string out;
  for (const auto& [name, preset] : presets.items()) out += (out.empty() ? "" : ", ") + name;
  return out;
}

}  // namespace

std::vector<FabricSource> applyFabricPresets(json& reduced, Warnings& warnings) {
  std::vector<FabricSource> out;
  const auto materials = reduced.find("materials");
  if (materials == reduced.end()) return out;
  json presets;  // read when the first material names one
  std::vector<json> withPresets;
  const std::size_t count = materials->size();
  for (std::size_t i = 0; i < count; ++i) {
    json& material = (*materials)[i];
    out.push_back({.inExtras = takeFromExtras(material)});
    json* fabric = fabricOf(material);
    if (!fabric) continue;
    keepWeave(*fabric);
    const std::string name = fabric->value("preset", "");
    if (name.empty()) continue;
    if (presets.is_null()) presets = json::parse(fabricPresetText());
    const auto preset = presets.find(name);
    if (preset == presets.end()) {
      warnings.add("W_ENUM", "the preset " + telar::quoted(name) + " is unknown; there are " + namesOf(presets),
                   pointer("materials", i, out[i].inExtras ? "extras" : "extensions") + "/" + NAME + "/preset");
      continue;
    }
    json filled = (*preset)["material"];
    filled.merge_patch(material);  // RFC 7396: the material's own values stay
    dyeLayers(filled, material);
    out[i].preset = name;
    out[i].withPreset = static_cast<int>(count + withPresets.size());
    withPresets.push_back(std::move(filled));
  }
  for (json& material : withPresets) materials->push_back(std::move(material));
  return out;
}

}  // namespace telar::asset
