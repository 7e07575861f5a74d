#pragma once
#include <nlohmann/json.hpp>

#include "telar/picture_facts.h"

namespace telar {

/// `picture` of a frame's info.
inline nlohmann::ordered_json toJson(const PictureFacts& facts) {
  return {{"coverage", facts.coverage}, {"dark", facts.dark}, {"bright", facts.bright}, {"saturated", facts.saturated}};
}

}  // namespace telar
