#include "asset/document/camera_light.h"

#include <nlohmann/json.hpp>
#include <numbers>

#include "asset/check/clamped.h"
#include "asset/check/number.h"
#include "asset/check/pointer.h"
#include "asset/document/schema.h"

namespace telar::asset {
namespace {

using nlohmann::json;

constexpr float LIGHT_MAX = 1e9f;  // candela, lux, metres: beyond any real lamp, far from overflow in the shaders

/// The value, or `fallback` where the key is absent. @throws json::exception when it is of a wrong type
template <typename T>
T valueOr(const json& object, const char* key, T fallback) {
  const auto found = object.find(key);
  return found == object.end() ? fallback : found->get<T>();
}

ModelCamera readCamera(const json& source) {
  ModelCamera out;
  out.name = cutName(valueOr(source, "name", std::string()));
  out.perspective = source.at("type").get_ref<const std::string&>() == "perspective";
  const json& lens = source.at(out.perspective ? "perspective" : "orthographic");
  out.near = lens.at("znear").get<double>();
  out.far = valueOr(lens, "zfar", 0.0);
  if (out.perspective) {
    out.fovY = lens.at("yfov").get<double>();
    out.aspectRatio = valueOr(lens, "aspectRatio", 0.0);
  } else {
    out.xmag = lens.at("xmag").get<double>();
    out.ymag = lens.at("ymag").get<double>();
  }
  return out;
}

bool usable(const ModelCamera& camera) {
  if (camera.far != 0 && camera.far <= camera.near) return false;
  if (camera.perspective) {
    return camera.near > 0 && camera.fovY > 0 && camera.fovY < std::numbers::pi && camera.aspectRatio >= 0;
  }
  return camera.near >= 0 && camera.far > 0 && camera.xmag > 0 && camera.ymag > 0;
}

glm::vec3 readColor(const json& source) {
  const auto found = source.find("color");
  if (found == source.end()) return glm::vec3(1.0f);
  return {toFloat(found->at(0).get<double>()), toFloat(found->at(1).get<double>()),
          toFloat(found->at(2).get<double>())};
}

std::optional<LightType> readType(const json& source) {
  const auto& type = source.at("type").get_ref<const std::string&>();
  if (type == "directional") return LightType::kDirectional;
  if (type == "point") return LightType::kPoint;
  if (type == "spot") return LightType::kSpot;
  return std::nullopt;
}

std::optional<ModelLight> readLight(const json& source) {
  const auto type = readType(source);
  if (!type) return std::nullopt;
  ModelLight out;
  out.type = *type;
  out.name = cutName(valueOr(source, "name", std::string()));
  out.color = readColor(source);
  out.intensity = toFloat(valueOr(source, "intensity", 1.0));
  out.range = toFloat(valueOr(source, "range", 0.0));
  const auto spot = source.find("spot");
  if (out.type == LightType::kSpot && spot != source.end()) {
    out.innerConeAngle = toFloat(valueOr(*spot, "innerConeAngle", 0.0));
    out.outerConeAngle = toFloat(valueOr(*spot, "outerConeAngle", std::numbers::pi / 4));
  }
  return out;
}

void clampLight(ModelLight& light, const std::string& where, Warnings& warnings) {
  const auto clampTo = [&](float& value, float high, const char* key) {
    value = clamped(value, 0, high, where + key, warnings);
  };
  clampTo(light.intensity, LIGHT_MAX, "/intensity");
  clampTo(light.range, LIGHT_MAX, "/range");
  for (int i = 0; i < 3; ++i) clampTo(light.color[i], LIGHT_MAX, "/color");
  clampTo(light.outerConeAngle, std::numbers::pi_v<float> / 2, "/spot/outerConeAngle");
  clampTo(light.innerConeAngle, light.outerConeAngle, "/spot/innerConeAngle");
}

}  // namespace

std::vector<std::optional<ModelCamera>> readCameras(const json& cameras, Warnings& warnings) {
  if (!cameras.is_array()) fail("E_SCHEMA", "expected an array here", "/cameras");
  std::vector<std::optional<ModelCamera>> out;
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    out.emplace_back();
    try {
      const ModelCamera camera = readCamera(cameras[i]);
      if (usable(camera)) out.back() = camera;
    } catch (const json::exception&) {
      out.back().reset();  // told below
    }
    if (!out.back()) warnings.add("W_CAMERA", "a camera is malformed and was left out", pointer("cameras", i));
  }
  return out;
}

std::vector<std::optional<ModelLight>> readLights(const json& lights, Warnings& warnings) {
  static constexpr const char* LIST = "/extensions/KHR_lights_punctual/lights";
  if (!lights.is_array()) fail("E_SCHEMA", "expected an array here", LIST);
  std::vector<std::optional<ModelLight>> out;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const std::string where = LIST + pointer(i);
    out.emplace_back();
    try {
      out.back() = readLight(lights[i]);
    } catch (const json::exception&) {
      out.back().reset();  // told below
    }
    if (!out.back()) {
      warnings.add("W_LIGHT", "a light is malformed and was left out", where);
    } else {
      clampLight(*out.back(), where, warnings);
    }
  }
  return out;
}

}  // namespace telar::asset
