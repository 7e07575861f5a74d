#include "pass/describe.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/gtc/type_ptr.hpp>
#include <set>

#include "pass/plan/fragment_estimate.h"
#include "pass/skipped.h"
#include "telar/reference.h"

namespace telar {
namespace pass {

using Json = nlohmann::ordered_json;

Json describeContext(const gl::Context& context) {
  return {{"backend", gl::backendName(context.backend())},
          {"vendor", context.vendor()},
          {"renderer", context.renderer()},
          {"version", context.version()},
          {"robust", context.capabilities().robust},
          {"maxTextureSize", context.capabilities().maxTextureSize}};
}

Json describePlan(const FramePlan& plan, const Shot& shot) {
  std::set<std::string> features;
  Json programs = Json::array();
  for (const shader::VariantKey& key : plan.keys()) {
    const auto list = key.features();
    features.insert(list.begin(), list.end());
    programs.push_back({{"features", list}});
  }
  Json passes = Json::array();
  for (const auto* maps : {&plan.shadows.flat, &plan.shadows.cube}) {
    for (const pass::ShadowMap& map : *maps) passes.push_back(std::string("shadow-") + pass::nameOf(map.type));
  }
  if (!plan.draws.transmissive.empty()) passes.push_back("transmission");
  if (plan.environmentBackground) passes.push_back("background");
  if (!plan.draws.opaque.empty()) passes.push_back("opaque");
  if (!plan.draws.transmissive.empty()) passes.push_back("transmissive");
  if (plan.ground) passes.push_back("ground");
  if (!plan.draws.blended.empty()) passes.push_back("blend");
  if (shot.samples > 1 || shot.resolve == Resolve::kLinear) passes.push_back("resolve");
  return {{"features", features}, {"programs", programs}, {"passes", passes}};
}

Json describeFrame(const FramePlan& plan, const Shot& shot, const ibl::Environment* environment,
                   const gl::Context& context, const FrameCounts& counts, const StageTimer& timer) {
  Json json = describePlan(plan, shot);
  json["backend"] = gl::backendName(context.backend());
  json["gl"] = {{"vendor", context.vendor()}, {"renderer", context.renderer()}, {"version", context.version()}};
  json["drawCalls"] = plan.draws.size();
  const VisibilityBuffer::Count& found = counts.buffered;
  json["triangles"] = found.triangles > 0 ? found.triangles : counts.drawn.all;
  json["hiddenTriangles"] = found.triangles > 0 ? found.hidden : counts.drawn.hidden;
  if (found.triangles > 0) json["shadedFragments"] = found.fragments;
  if (counts.texels.unread > 0) json["unreadTexels"] = counts.texels.unread;
  json["skipped"] = describeSkipped(plan, counts, json);
  json["environmentSource"] = environment ? Json(environment->source) : Json(nullptr);
  const glm::dmat4 toPixel = frame::worldToPixel(plan.camera, shot.width, shot.height);
  json["worldToPixel"] = std::vector<double>(glm::value_ptr(toPixel), glm::value_ptr(toPixel) + 16);
  json["ms"] = timer.json();
  return json;
}

Shot withSuns(Shot shot, const ibl::Suns& suns) {
  const glm::dmat3 toWorld = glm::transpose(glm::dmat3(frame::environmentRotation(shot.environment.rotation)));
  for (const auto& [direction, irradiance] : suns.list) {
    Shot::Light& light = shot.lights.emplace_back();
    light.type = Shot::Light::Type::kDirectional;
    const double brightest = std::max({irradiance.r, irradiance.g, irradiance.b});
    light.color = glm::vec3(irradiance / brightest);
    light.intensity = brightest * shot.environment.intensity;
    light.position = toWorld * direction;
    ++shot.suns;
  }
  return shot;
}

Json rangeWarning(double share) {
  char percent[16];
  std::snprintf(percent, sizeof percent, "%.3g", 100 * share);
  return {{"code", "W_ENVIRONMENT_RANGE"},
          {"message", std::string("shot.environment: three.js has no texel above 65504, the largest half float: ") +
                          percent + " % of the map's light is lost; every other shading keeps it"}};
}

}  // namespace pass

std::string planFrame(const Scene& scene, const Shot& shot, const Limits& limits) {
  // Neither has programs.
  const char* alone = shot.isLinesAlone() ? "flat" : shot.reference || tracedInstead(scene, shot) ? "trace" : nullptr;
  if (alone)
    return pass::Json{{"features", pass::Json::array()},
                      {"programs", pass::Json::array()},
                      {"passes", {alone}},
                      {"traceable", isTraceable(scene, shot)}}
        .dump();
  const pass::FramePlan plan = pass::planDraws(scene, shot, limits, false);
  pass::Json json = pass::describePlan(plan, shot);
  json["traceable"] = isTraceable(scene, shot);
  json["fragments"] = std::ceil(pass::fragmentsOf(plan, shot, static_cast<double>(limits.fragments), CancelToken()));
  return json.dump();
}

}  // namespace telar
