#pragma once
#include <cmath>
#include <nlohmann/json.hpp>

#include "telar/progress.h"

namespace telar {

/// What info tells of a picture that may end before its last sample.
/// @pre  json has its samples
inline void tellEnd(nlohmann::ordered_json& json, const Progress& progress, const Ending& end) {
  if (end.early) json["ended"] = json["samples"];
  if (progress.isErrorAllowed() && std::isfinite(end.standardError)) json["standardError"] = end.standardError;
  if (progress.isCpuAllowed()) json["spentMs"] = progress.spentMs();
}

}  // namespace telar
