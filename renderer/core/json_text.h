#pragma once
#include <nlohmann/json.hpp>
#include <string>

#include "telar/error.h"

namespace telar {

/// A value of untrusted JSON as a message tells it: short, without control characters.
inline std::string shown(const nlohmann::json& value) {
  if (value.is_object()) return "an object";
  if (value.is_array()) return "an array of " + std::to_string(value.size());
  if (value.is_string()) return telar::quoted(value.get_ref<const std::string&>());
  return value.dump();
}

}  // namespace telar
