#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string_view>
#include <vector>

#include "asset/check/warnings.h"
#include "asset/document/document.h"

namespace telar::asset {

/// js/assets/fabric_presets.json: by name {summary, source, material}, where `material` is part of a glTF material.
std::string_view fabricPresetText();

/// Moves TELAR_materials_fabric from the materials' extras to their extensions, where it is not there already, and
/// appends to `materials` each that names a preset once more, with what its preset fills in: every property that it
/// leaves out itself, at any depth. W_ENUM for a name that is not known.
/// @param reduced a document that the schema has passed
/// @return by material of the file
std::vector<FabricSource> applyFabricPresets(nlohmann::json& reduced, Warnings& warnings);

}  // namespace telar::asset
