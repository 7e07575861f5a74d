#include "lobes.h"

#include <numbers>
#include <utility>

#include "handles.h"
#include "state.h"
#include "telar/lobes.h"

namespace telar::addon {
namespace {

constexpr std::size_t DIRECTIONS_MAX = 65536;
constexpr std::size_t DIRECTIONS_PER_CHECK = 1024;

struct Request {
  std::size_t material = 0;
  std::string shot;
  double viewAngle = 0;
  std::vector<double> directions;  ///< x, y, z of each
  bool albedo = false;
};

[[noreturn]] void expected(Napi::Env env, const char* what) {
  throw Napi::TypeError::New(env, std::string("native telar expected ") + what);
}

Request requestFromJs(const Napi::Object& object, const Scene& scene) {
  const Napi::Env env = object.Env();
  Request request;
  request.material = object.Get("material").ToNumber().Uint32Value();
  if (request.material >= scene.materials.size()) expected(env, "a material of the scene");
  request.shot = stringFromJs(object.Get("shot"), "the shot");
  request.viewAngle = object.Get("viewAngle").ToNumber().DoubleValue();
  if (!(request.viewAngle >= 0 && request.viewAngle < std::numbers::pi / 2)) expected(env, "an angle below pi / 2");
  const Napi::Value directions = object.Get("directions");
  if (!directions.IsTypedArray() || directions.As<Napi::TypedArray>().TypedArrayType() != napi_float64_array) {
    expected(env, "directions as a Float64Array");
  }
  const auto numbers = directions.As<Napi::Float64Array>();
  const std::size_t count = numbers.ElementLength();
  if (count % 3 != 0 || count > 3 * DIRECTIONS_MAX) expected(env, "three numbers for each of at most 65536 directions");
  request.directions.assign(numbers.Data(), numbers.Data() + count);
  request.albedo = object.Get("albedo").ToBoolean();
  return request;
}

void append(std::vector<double>& numbers, const LobeRadiance& lobes) {
  for (const glm::dvec3& rgb : {lobes.diffuse, lobes.specular, lobes.sheen, lobes.coat, lobes.total}) {
    for (int c = 0; c < 3; ++c) numbers.push_back(rgb[c]);
  }
}

struct Evaluated {
  std::vector<double> radiance, albedo;  ///< of the albedo, values first, then their errors
};

Evaluated evaluate(const Scene& scene, const Request& request, const CancelToken& cancel) {
  const ShadedMaterial material(scene, request.material, parseShot(request.shot), request.viewAngle);
  Evaluated out;
  for (std::size_t i = 0; i < request.directions.size(); i += 3) {
    if (i % (3 * DIRECTIONS_PER_CHECK) == 0) cancel.check();
    const double* l = &request.directions[i];
    append(out.radiance, material.radiance({l[0], l[1], l[2]}));
  }
  if (request.albedo) {
    const Albedo albedo = material.albedo(cancel);
    append(out.albedo, albedo.value);
    append(out.albedo, albedo.error);
  }
  return out;
}

Napi::Float64Array numbersToJs(Napi::Env env, const std::vector<double>& numbers) {
  auto array = Napi::Float64Array::New(env, numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) array[i] = numbers[i];
  return array;
}

}  // namespace

Napi::Value evaluateLobes(const Napi::CallbackInfo& info) {
  auto scene = unwrap<SceneHandle>(info[0]).scene();
  auto request = requestFromJs(info[1].As<Napi::Object>(), *scene);
  auto job = std::make_shared<Job>(unwrap<TokenHandle>(info[2]).token);
  return State::of(info.Env()).runOnPool(info.Env(), job, [job, scene, request = std::move(request)] {
    const Evaluated out = evaluate(*scene, request, job->cancel);
    job->value = [out](Napi::Env env) {
      Napi::Object result = Napi::Object::New(env);
      result["radiance"] = numbersToJs(env, out.radiance);
      result["albedo"] = numbersToJs(env, out.albedo);
      return result;
    };
  });
}

}  // namespace telar::addon
