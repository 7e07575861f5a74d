#include "handles.h"

#include "fault.h"
#include "state.h"

namespace telar::addon {
namespace {

/// Reads no pixels of 8-bit images: threads may be writing them.
std::size_t bytesOf(const Image8& image) {
  if (image.type == TexelType::kByte && !image.ownLevels) return std::size_t{4} * image.width * image.height;
  std::size_t bytes = image.pixels.size();
  for (const auto& level : image.smallerLevels) bytes += level.size();
  return bytes;
}

std::size_t bytesOf(const Primitive& p) {
  std::size_t bytes = p.positions.size() * sizeof(glm::vec3) + p.normals.size() * sizeof(glm::vec3);
  bytes += p.tangents.size() * sizeof(glm::vec4) + p.colors.size() * sizeof(glm::vec4);
  for (const auto& uv : p.uvs) bytes += uv.size() * sizeof(glm::vec2);
  bytes += p.indices.size() * sizeof(std::uint32_t);
  if (!p.deformers) return bytes;
  bytes += p.deformers->joints.size() * sizeof(glm::u16vec4) + p.deformers->weights.size() * sizeof(glm::vec4);
  for (const MorphTarget& target : p.deformers->targets) {
    bytes += (target.positions.size() + target.normals.size()) * sizeof(glm::vec3);
    bytes += target.colors.size() * sizeof(glm::vec4);
  }
  return bytes;
}

/// @param given  milliseconds, or another token, whose time and end it has; undefined = any time
CancelToken tokenFromJs(const Napi::Value& given) {
  if (given.IsObject()) return unwrap<TokenHandle>(given).token;
  if (!given.IsNumber()) return {};
  return CancelToken(std::chrono::milliseconds(given.As<Napi::Number>().Int64Value()));
}

/// What a decoded scene holds beyond its small parts, so that V8 knows what collecting its handle would free. A pose
/// shares all but its deformed meshes.
std::int64_t sceneBytes(const Scene& scene) {
  std::size_t bytes = 0;
  if (!scene.model) {
    for (const Image8& image : scene.images) bytes += bytesOf(image);
  }
  for (std::size_t i = scene.model ? scene.fileMeshes : 0; i < scene.meshes.size(); ++i) {
    for (const Primitive& primitive : scene.meshes[i].primitives) bytes += bytesOf(primitive);
  }
  return static_cast<std::int64_t>(bytes);
}

}  // namespace

Napi::Function TokenHandle::define(Napi::Env env) {
  return DefineClass(
      env, "CancelToken",
      {InstanceMethod("cancel", &TokenHandle::cancel), InstanceMethod("allowAnyTime", &TokenHandle::allowAnyTime),
       InstanceMethod("progress", &TokenHandle::reached), InstanceMethod("askPreviews", &TokenHandle::askPreviews),
       InstanceMethod("takePreview", &TokenHandle::takePreview), InstanceMethod("settle", &TokenHandle::settle),
       InstanceMethod("allowCpu", &TokenHandle::allowCpu), InstanceMethod("allowError", &TokenHandle::allowError)});
}

Napi::Value TokenHandle::takePreview(const Napi::CallbackInfo& info) {
  const std::optional<Preview> preview = progress.previews.take();
  if (!preview) return info.Env().Undefined();
  const Frame& frame = preview->frame;
  Napi::Object taken = Napi::Object::New(info.Env());
  taken.Set("width", frame.width);
  taken.Set("height", frame.height);
  taken.Set("bitDepth", frame.type == PixelType::kRgba8 ? 8 : 32);
  taken.Set("samples", preview->samples);
  taken.Set("data", Napi::Buffer<std::byte>::Copy(info.Env(), frame.pixels.data(), frame.pixels.size()));
  return taken;
}

TokenHandle::TokenHandle(const Napi::CallbackInfo& info) : ObjectWrap(info), token(tokenFromJs(info[0])) {
  info.This().As<Napi::Object>().TypeTag(&TAG);
}

Napi::Function BytesHandle::define(Napi::Env env) { return DefineClass(env, "Bytes", {}); }

BytesHandle::BytesHandle(const Napi::CallbackInfo& info) : ObjectWrap(info) {
  info.This().As<Napi::Object>().TypeTag(&TAG);
  try {
    bytes_ = copyBytes(info[0], info[1].ToNumber().DoubleValue());
  } catch (const Napi::Error&) {
    throw;
  } catch (...) {
    throw Napi::Error(info.Env(), Fault::current().toJs(info.Env()));
  }
  Napi::MemoryManagement::AdjustExternalMemory(info.Env(), static_cast<std::int64_t>(bytes_->size()));
}

void BytesHandle::Finalize(Napi::BasicEnv env) {
  if (bytes_) Napi::MemoryManagement::AdjustExternalMemory(env, -static_cast<std::int64_t>(bytes_->size()));
}

std::shared_ptr<const FileBytes> BytesHandle::bytes() const {
  if (!bytes_) throw Napi::TypeError::New(Env(), "native telar has read these bytes for the last time");
  return bytes_;
}

std::shared_ptr<const FileBytes> BytesHandle::detach() {
  std::shared_ptr<const FileBytes> bytes = this->bytes();
  Finalize(Env());
  bytes_.reset();
  return bytes;
}

Napi::Function SceneHandle::define(Napi::Env env) { return DefineClass(env, "Scene", {}); }

Napi::Object SceneHandle::make(Napi::Env env, std::shared_ptr<const Scene> scene) {
  return construct(State::of(env).sceneClass, std::move(scene));
}

Napi::Object sceneToJs(Napi::Env env, const std::shared_ptr<const Scene>& scene, const std::string& facts) {
  Napi::Object result = Napi::Object::New(env);
  result["scene"] = SceneHandle::make(env, scene);
  result["facts"] = facts;
  return result;
}

SceneHandle::SceneHandle(const Napi::CallbackInfo& info)
    : ObjectWrap(info), scene_(take<std::shared_ptr<const Scene>>(info)), accounted_(sceneBytes(*scene_)) {
  info.This().As<Napi::Object>().TypeTag(&TAG);
  Napi::MemoryManagement::AdjustExternalMemory(info.Env(), accounted_);
}

std::shared_ptr<const Scene> SceneHandle::scene() const {
  if (!scene_) throw Napi::TypeError::New(Env(), "native telar drew this model for the last time");
  return scene_;
}

std::shared_ptr<const Scene> SceneHandle::detach() {
  std::shared_ptr<const Scene> scene = this->scene();
  Finalize(Env());
  scene_.reset();
  return scene;
}

void SceneHandle::Finalize(Napi::BasicEnv env) {
  Napi::MemoryManagement::AdjustExternalMemory(env, -accounted_);
  accounted_ = 0;
}

}  // namespace telar::addon
