#include "convert.h"

#include <array>
#include <cstring>
#include <utility>

#include "telar/error.h"
#include "telar/reused_memory.h"

namespace telar::addon {
namespace {

using LimitField = std::pair<const char*, std::uint64_t Limits::*>;
constexpr std::array LIMIT_FIELDS{
    LimitField{"L_MEMORY_BYTES", &Limits::memoryBytes},
    LimitField{"L_FILE_BYTES", &Limits::fileBytes},
    LimitField{"L_EXTERNAL_BYTES", &Limits::externalBytes},
    LimitField{"L_EXTERNAL_FILES", &Limits::externalFiles},
    LimitField{"L_JSON_BYTES", &Limits::jsonBytes},
    LimitField{"L_JSON_DEPTH", &Limits::jsonDepth},
    LimitField{"L_JSON_VALUES", &Limits::jsonValues},
    LimitField{"L_NODES", &Limits::nodes},
    LimitField{"L_NODE_DEPTH", &Limits::nodeDepth},
    LimitField{"L_DRAW_CALLS", &Limits::drawCalls},
    LimitField{"L_VERTICES", &Limits::vertices},
    LimitField{"L_TRIANGLES", &Limits::triangles},
    LimitField{"L_BUFFERS", &Limits::buffers},
    LimitField{"L_BUFFER_VIEWS", &Limits::bufferViews},
    LimitField{"L_MESHOPT_BYTES", &Limits::meshoptBytes},
    LimitField{"L_ACCESSORS", &Limits::accessors},
    LimitField{"L_MATERIALS", &Limits::materials},
    LimitField{"L_TEXTURES", &Limits::textures},
    LimitField{"L_IMAGES", &Limits::images},
    LimitField{"L_IMAGE_DIMENSION", &Limits::imageDimension},
    LimitField{"L_IMAGE_PIXELS", &Limits::imagePixels},
    LimitField{"L_IMAGE_BYTES", &Limits::imageBytes},
    LimitField{"L_IMAGE_SCANS", &Limits::imageScans},
    LimitField{"L_INSTANCES", &Limits::instances},
    LimitField{"L_VISIBILITY_RAYS", &Limits::visibilityRays},
    LimitField{"L_KEYFRAME_VALUES", &Limits::keyframeValues},
    LimitField{"L_MORPH_TARGETS", &Limits::morphTargets},
    LimitField{"L_LIGHTS", &Limits::lights},
    LimitField{"L_SHADOW_TEXELS", &Limits::shadowTexels},
    LimitField{"L_TEXTURE_UNITS", &Limits::textureUnits},
    LimitField{"L_ENVIRONMENT_PIXELS", &Limits::environmentPixels},
    LimitField{"L_PROGRAMS", &Limits::programs},
    LimitField{"L_FRAGMENTS", &Limits::fragments},
};
static_assert(sizeof(Limits) == LIMIT_FIELDS.size() * sizeof(std::uint64_t), "each limit has its row");

constexpr std::array<std::pair<const char*, Backend>, 4> BACKENDS{{
    {"auto", Backend::kAuto},
    {"egl-device", Backend::kEglDevice},
    {"egl-surfaceless", Backend::kEglSurfaceless},
    {"osmesa", Backend::kOsmesa},
}};

[[noreturn]] void expected(Napi::Env env, const std::string& what) {
  throw Napi::TypeError::New(env, "native telar expected " + what);
}

}  // namespace

Napi::Object limitsToJs(Napi::Env env, const Limits& limits) {
  Napi::Object object = Napi::Object::New(env);
  for (const auto& [name, field] : LIMIT_FIELDS) object[name] = static_cast<double>(limits.*field);
  return object;
}

Limits limitsFromJs(const Napi::Value& value) {
  Limits limits;
  if (!value.IsObject()) return limits;
  const Napi::Object object = value.As<Napi::Object>();
  for (const auto& [name, field] : LIMIT_FIELDS) {
    const Napi::Value given = object.Get(name);
    if (given.IsUndefined()) continue;
    const double number = given.IsNumber() ? given.As<Napi::Number>().DoubleValue() : -1;
    if (!(number >= 0 && number <= 9007199254740991.0)) expected(value.Env(), std::string("a count for ") + name);
    limits.*field = static_cast<std::uint64_t>(number);
  }
  return limits;
}

RendererOptions rendererOptionsFromJs(const Napi::Object& object) {
  RendererOptions options;
  const std::string backend = stringFromJs(object.Get("backend"), "a backend");
  bool known = false;
  for (const auto& [name, value] : BACKENDS) {
    if (backend == name) options.backend = value, known = true;
  }
  if (!known) expected(object.Env(), "a known backend");
  options.assetDirectory = stringFromJs(object.Get("assetDirectory"), "assetDirectory");
  options.cacheDirectory = stringFromJs(object.Get("cacheDirectory"), "cacheDirectory");
  options.cacheBytes = static_cast<std::uint64_t>(object.Get("cacheBytes").ToNumber().Int64Value());
  options.limits = limitsFromJs(object.Get("limits"));
  options.allFeatures = object.Get("allFeatures").ToBoolean();
  return options;
}

std::string stringFromJs(const Napi::Value& value, const char* what) {
  if (!value.IsString()) expected(value.Env(), std::string(what) + " as a string");
  return value.As<Napi::String>();
}

std::shared_ptr<const FileBytes> copyBytes(const Napi::Value& value, double maxBytes) {
  if (!value.IsTypedArray()) expected(value.Env(), "a Uint8Array");
  const Napi::Uint8Array array = value.As<Napi::Uint8Array>();
  if (array.TypedArrayType() != napi_uint8_array) expected(value.Env(), "a Uint8Array");
  checkLimit("L_FILE_BYTES", maxBytes, static_cast<double>(array.ByteLength()));
  const ReusesMemory yes;  // each byte is written
  auto bytes = std::make_shared<FileBytes>(array.ByteLength());
  if (!bytes->empty()) std::memcpy(bytes->data(), array.Data(), bytes->size());
  return bytes;
}

Napi::Buffer<std::uint8_t> bytesToJs(Napi::Env env, Bytes bytes) {
  auto owner = std::make_unique<Bytes>(std::move(bytes));
  auto* data = reinterpret_cast<std::uint8_t*>(owner->data());
  const auto release = [](Napi::Env, std::uint8_t*, Bytes* held) { delete held; };
  auto buffer = Napi::Buffer<std::uint8_t>::NewOrCopy(env, data, owner->size(), release, owner.get());
  (void)owner.release();  // the buffer's now
  return buffer;
}

}  // namespace telar::addon
