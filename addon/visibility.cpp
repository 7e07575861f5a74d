#include "visibility.h"

#include <bit>
#include <cmath>
#include <cstring>
#include <utility>
#include <vector>

#include "convert.h"
#include "handles.h"
#include "state.h"
#include "telar/load.h"
#include "telar/visibility.h"

namespace telar::addon {
namespace {

static_assert(std::endian::native == std::endian::little, "glTF's order of bytes");

/// One primitive of the file.
struct Baked {
  int mesh = 0, primitive = 0;
  std::size_t vertices = 0;
  Bytes front, back;
};

Bytes normalizedShorts(const std::vector<glm::vec4>& stream) {
  std::vector<std::int16_t> shorts;
  shorts.reserve(stream.size() * 4);
  for (const glm::vec4& v : stream) {
    for (int k = 0; k < 4; ++k) shorts.push_back(static_cast<std::int16_t>(std::lround(v[k] * 32767.0f)));
  }
  Bytes bytes(shorts.size() * sizeof(std::int16_t));
  if (!bytes.empty()) std::memcpy(bytes.data(), shorts.data(), bytes.size());
  return bytes;
}

std::vector<Baked> bakedOf(const Scene& scene, const CancelToken& cancel) {
  std::vector<Baked> out;
  for (std::size_t i = 0; i < scene.fileMeshes; ++i) {
    const Mesh& mesh = scene.meshes[i];
    for (const Primitive& primitive : mesh.primitives) {
      cancel.check();
      if (primitive.visibility[0].empty()) continue;
      out.push_back({mesh.file, primitive.file, primitive.positions.size(), normalizedShorts(primitive.visibility[0]),
                     normalizedShorts(primitive.visibility[1])});
    }
  }
  return out;
}

VisibilityCache cacheFromJs(const Napi::Object& value) {
  return {stringFromJs(value.Get("directory"), "directory"),
          static_cast<std::uint64_t>(value.Get("bytes").ToNumber().Int64Value()),
          stringFromJs(value.Get("version"), "version")};
}

Napi::Array toJs(Napi::Env env, std::vector<Baked> baked) {
  auto list = Napi::Array::New(env, baked.size());
  for (std::size_t i = 0; i < baked.size(); ++i) {
    Napi::Object item = Napi::Object::New(env);
    item["mesh"] = baked[i].mesh;
    item["primitive"] = baked[i].primitive;
    item["vertices"] = static_cast<double>(baked[i].vertices);
    item["front"] = bytesToJs(env, std::move(baked[i].front));
    item["back"] = baked[i].back.empty() ? env.Null() : Napi::Value(bytesToJs(env, std::move(baked[i].back)));
    list[static_cast<std::uint32_t>(i)] = item;
  }
  return list;
}

}  // namespace

Napi::Value withVisibility(const Napi::CallbackInfo& info) {
  const int rays = info[1].ToNumber().Int32Value();
  if (rays < VisibilityRays::LEAST || rays > VisibilityRays::MOST)
    throw Napi::TypeError::New(info.Env(), "native telar expected a number of rays in range");
  const VisibilityCache cache = cacheFromJs(info[2].ToObject());
  const Limits limits = limitsFromJs(info[3]);
  auto job = std::make_shared<Job>(unwrap<TokenHandle>(info[4]).token);
  auto model = unwrap<SceneHandle>(info[0]).detach();
  return State::of(info.Env())
      .runOnPool(info.Env(), job, [job, rays, cache, limits, model = std::move(model)]() mutable {
        auto scene = withAmbientVisibility(model, rays, cache, limits, job->cancel);
        model.reset();
        std::string facts = describeScene(*scene, job->cancel);
        job->value = [scene, facts = std::move(facts)](Napi::Env env) { return sceneToJs(env, scene, facts); };
      });
}

Napi::Value visibilityOf(const Napi::CallbackInfo& info) {
  auto scene = unwrap<SceneHandle>(info[0]).scene();
  auto job = std::make_shared<Job>(unwrap<TokenHandle>(info[1]).token);
  return State::of(info.Env()).runOnPool(info.Env(), job, [job, scene] {
    auto baked = std::make_shared<std::vector<Baked>>(bakedOf(*scene, job->cancel));
    job->value = [baked](Napi::Env env) { return toJs(env, std::move(*baked)); };
  });
}

}  // namespace telar::addon
