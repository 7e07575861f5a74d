#include "shown.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "convert.h"
#include "handles.h"
#include "state.h"
#include "telar/part.h"
#include "telar/part_opacities.h"
#include "telar/shot.h"

namespace telar::addon {
namespace {

/// What of a model a shot shows: {variant, ghost}, the ghosts as JSON.
struct Shown {
  std::string variant;
  std::vector<Shot::Ghost> ghost;
};

Shown shownFromJs(const Napi::Value& value) {
  const auto shown = value.As<Napi::Object>();
  return {stringFromJs(shown.Get("variant"), "the variant"),
          parseGhosts(stringFromJs(shown.Get("ghost"), "the ghosts"))};
}

std::shared_ptr<Job> jobOf(const Napi::Value& token) { return std::make_shared<Job>(unwrap<TokenHandle>(token).token); }

}  // namespace

Napi::Value measurePart(const Napi::CallbackInfo& info) {
  auto scene = unwrap<SceneHandle>(info[0]).scene();
  PartQuery query;
  if (stringFromJs(info[1], "a kind of part") == "material") query.kind = PartQuery::Kind::kMaterial;
  if (info[2].IsNumber()) {
    query.which = info[2].As<Napi::Number>().Int32Value();
  } else {
    query.which = stringFromJs(info[2], "a name");
  }
  const Shown shown = shownFromJs(info[3]);
  query.variant = shown.variant;
  const auto job = jobOf(info[4]);
  return textOnPool(info.Env(), job,
                    [scene, query, shown, job] { return describePart(*scene, query, shown.ghost, job->cancel); });
}

Napi::Value measureShown(const Napi::CallbackInfo& info) {
  auto scene = unwrap<SceneHandle>(info[0]).scene();
  const Shown shown = shownFromJs(info[1]);
  const auto job = jobOf(info[2]);
  return textOnPool(info.Env(), job,
                    [scene, shown, job] { return describeShown(*scene, shown.variant, shown.ghost, job->cancel); });
}

Napi::Value rangesAlong(const Napi::CallbackInfo& info) {
  auto scene = unwrap<SceneHandle>(info[0]).scene();
  std::array<glm::dvec3, 3> axes{};
  const auto numbers = info[1].As<Napi::Array>();
  for (std::uint32_t i = 0; i < 9; ++i) axes[i / 3][static_cast<int>(i % 3)] = numbers.Get(i).ToNumber().DoubleValue();
  const Shown shown = shownFromJs(info[2]);
  const auto job = jobOf(info[3]);
  return textOnPool(info.Env(), job, [scene, axes, shown, job] {
    return describeRanges(*scene, axes, shown.variant, shown.ghost, job->cancel);
  });
}

}  // namespace telar::addon
