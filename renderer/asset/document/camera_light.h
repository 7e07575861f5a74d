#pragma once
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <vector>

#include "asset/check/warnings.h"

namespace telar::asset {

/// Reads `cameras`. A thumbnail is drawn by another camera, so a malformed one is left out with W_CAMERA.
/// @throws Error{E_SCHEMA} when it is no array
std::vector<std::optional<ModelCamera>> readCameras(const nlohmann::json& cameras, Warnings& warnings);

/// Reads the lights of KHR_lights_punctual. Values out of range are clamped with W_RANGE; a light of unknown type or
/// with values of wrong type is left out with W_LIGHT.
/// @throws Error{E_SCHEMA} when it is no array
std::vector<std::optional<ModelLight>> readLights(const nlohmann::json& lights, Warnings& warnings);

}  // namespace telar::asset
