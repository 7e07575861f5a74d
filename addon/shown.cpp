#include "shown.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>

#include "convert.h"
#include "handles.h"
#include "state.h"
#include "telar/part.h"
#include "telar/part_opacities.h"

namespace telar::addon {

Napi::Value measurePart(const Napi::CallbackInfo& info) {
  auto scene = unwrap<SceneHandle>(info[0]).scene();
  PartQuery query;
  if (stringFromJs(info[1], "a kind of part") == "material") query.kind = PartQuery::Kind::kMaterial;
  if (info[2].IsNumber()) {
    query.which = info[2].As<Napi::Number>().Int32Value();
  } else {
    query.which = stringFromJs(info[2], "a name");
  }
  const auto shown = info[3].As<Napi::Object>();
  query.variant = stringFromJs(shown.Get("variant"), "the variant");
  const auto ghost = parseGhosts(stringFromJs(shown.Get("ghost"), "the ghosts"));
  auto job = std::make_shared<Job>(unwrap<TokenHandle>(info[4]).token);
  return textOnPool(info.Env(), job,
                    [scene, query, ghost, job] { return describePart(*scene, query, ghost, job->cancel); });
}

Napi::Value measureShown(const Napi::CallbackInfo& info) {
  auto scene = unwrap<SceneHandle>(info[0]).scene();
  const auto shown = info[1].As<Napi::Object>();
  const auto variant = stringFromJs(shown.Get("variant"), "the variant");
  const auto ghost = parseGhosts(stringFromJs(shown.Get("ghost"), "the ghosts"));
  auto job = std::make_shared<Job>(unwrap<TokenHandle>(info[2]).token);
  return textOnPool(info.Env(), job,
                    [scene, variant, ghost, job] { return describeShown(*scene, variant, ghost, job->cancel); });
}

Napi::Value rangesAlong(const Napi::CallbackInfo& info) {
  auto scene = unwrap<SceneHandle>(info[0]).scene();
  std::array<glm::dvec3, 3> axes{};
  const auto numbers = info[1].As<Napi::Array>();
  for (std::uint32_t i = 0; i < 9; ++i) axes[i / 3][static_cast<int>(i % 3)] = numbers.Get(i).ToNumber().DoubleValue();
  const auto shown = info[2].As<Napi::Object>();
  const auto variant = stringFromJs(shown.Get("variant"), "the variant");
  const auto ghost = parseGhosts(stringFromJs(shown.Get("ghost"), "the ghosts"));
  auto job = std::make_shared<Job>(unwrap<TokenHandle>(info[3]).token);
  return textOnPool(info.Env(), job, [scene, axes, variant, ghost, job] {
    return describeRanges(*scene, axes, variant, ghost, job->cancel);
  });
}

}  // namespace telar::addon
