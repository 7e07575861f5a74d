#pragma once
#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

namespace telar {

/// [x, y, z]
inline nlohmann::ordered_json list(const glm::dvec3& v) { return {v.x, v.y, v.z}; }
inline nlohmann::ordered_json list(const glm::vec3& v) { return list(glm::dvec3(v)); }

}  // namespace telar
