#include "pass/skipped.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

namespace telar::pass {
namespace {

using Json = nlohmann::ordered_json;

/// All that a picture can have.
constexpr std::size_t PASS_KINDS = 10;

/// What a feature that is on and changes nothing adds to the time of drawing, and what a lamp adds that lights nothing,
/// in parts of it: measured on three models, on which it was 0.7 to 2 and 0 to 0.2 (js/docs/figures.md, What is left
/// out).
constexpr double FEATURE_PART = 1, LIGHT_PART = 0.06;

Json part(const char* what, std::uint64_t count, std::uint64_t of) {
  return {{"what", what}, {"count", count}, {"of", of}};
}

double rounded(double part) { return std::round(part * 1000) / 1000; }

}  // namespace

Json describeSkipped(const FramePlan& plan, const FrameCounts& counts, const Json& described) {
  Json list = Json::array();
  std::set<std::string> forced;
  for (shader::VariantKey key : plan.keys()) {
    forceAllFeatures(key);
    for (std::string& name : key.features()) forced.insert(std::move(name));
  }
  if (const std::size_t off = forced.size() - described["features"].size(); off > 0) {
    Json& features = list.emplace_back(part("features", off, forced.size()));
    features["estimatedPart"] = rounded(FEATURE_PART * static_cast<double>(off));
  }
  const std::set<std::string> kinds(described["passes"].begin(), described["passes"].end());
  list.push_back(part("passes", PASS_KINDS - kinds.size(), PASS_KINDS));
  if (const VisibilityBuffer::Count& found = counts.buffered; found.triangles > 0) {
    if (found.hidden > 0) list.push_back(part("triangles", found.hidden, found.triangles));
  } else if (const TriangleCount& drawn = counts.drawn; drawn.hidden > 0) {
    Json& triangles = list.emplace_back(part("triangles", drawn.hidden, drawn.all));
    if (drawn.pixels > 0) triangles["estimatedPart"] = rounded(drawn.hiddenPixels / drawn.pixels);
  }
  if (const TexelCount& texels = counts.texels; texels.unread > 0) {
    list.push_back(part("texels", texels.unread, texels.all));
    list.back()["bytes"] = texels.unreadBytes;
  }
  if (const LightSet& lights = plan.lights; lights.leftOut > 0) {
    list.push_back(part("lights", lights.leftOut, lights.given));
    list.back()["estimatedPart"] = rounded(LIGHT_PART * static_cast<double>(lights.leftOut));
  }
  if (const ShadowSet& shadows = plan.shadows; shadows.leftOut > 0) {
    list.push_back(part("shadowMaps", shadows.leftOut, shadows.casting));
    list.back()["texels"] = shadows.leftOutTexels;
  }
  return list;
}

}  // namespace telar::pass
