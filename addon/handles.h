#pragma once
#include <napi.h>

#include <functional>
#include <memory>

#include "convert.h"
#include "freed_memory.h"
#include "gl_thread.h"
#include "job.h"
#include "telar/cancel.h"
#include "telar/progress.h"
#include "telar/scene.h"

/// JavaScript objects that own something native. js/ keeps them in private fields; users never see them.
/// Each class has a type tag, so that one is never taken for another.
namespace telar::addon {

/// new CancelToken(timeoutMs?: number); cancel(); allowAnyTime(); progress(): 0..1 of the job that it was given
/// to; askPreviews(); takePreview(): {width, height, bitDepth, samples, data: Buffer} | undefined; settle(): the
/// picture as it is will do; allowCpu(ms), allowError(error): it will from then on
class TokenHandle : public Napi::ObjectWrap<TokenHandle> {
 public:
  static constexpr napi_type_tag TAG{0x74656c6172000001, 0x9a3f5c1e7b2d4860};
  static Napi::Function define(Napi::Env env);
  explicit TokenHandle(const Napi::CallbackInfo& info);

  const CancelToken token;
  const Progress progress;

 private:
  void cancel(const Napi::CallbackInfo&) { token.cancel(); }
  void allowAnyTime(const Napi::CallbackInfo&) { token.allowAnyTime(); }
  void askPreviews(const Napi::CallbackInfo&) { progress.previews.ask(); }
  void settle(const Napi::CallbackInfo&) { progress.settle(); }
  void allowCpu(const Napi::CallbackInfo& info) { progress.allowCpu(info[0].ToNumber()); }
  void allowError(const Napi::CallbackInfo& info) { progress.allowError(info[0].ToNumber()); }
  Napi::Value takePreview(const Napi::CallbackInfo& info);
  Napi::Value reached(const Napi::CallbackInfo& info) { return Napi::Number::New(info.Env(), progress.part()); }
};

/// new Bytes(uint8Array, maxBytes): a copy, so that later writes of JavaScript cannot reach work on another thread.
/// Throws {code: "L_FILE_BYTES", ...} before it copies too much. A model's are given away with detach(), so that the
/// next file has their memory before this is collected.
class BytesHandle : public Napi::ObjectWrap<BytesHandle> {
 public:
  static constexpr napi_type_tag TAG{0x74656c6172000002, 0x9a3f5c1e7b2d4860};
  static Napi::Function define(Napi::Env env);
  explicit BytesHandle(const Napi::CallbackInfo& info);
  void Finalize(Napi::BasicEnv env) override;
  /// @throws Napi::TypeError after detach()
  std::shared_ptr<const FileBytes> bytes() const;
  std::shared_ptr<const FileBytes> detach();

 private:
  std::shared_ptr<const FileBytes> bytes_;
};

/// A decoded model. One that is drawn once gives it away with detach(), rather than hold it until it is collected.
class SceneHandle : public Napi::ObjectWrap<SceneHandle> {
 public:
  static constexpr napi_type_tag TAG{0x74656c6172000003, 0x9a3f5c1e7b2d4860};
  static Napi::Function define(Napi::Env env);
  static Napi::Object make(Napi::Env env, std::shared_ptr<const Scene> scene);
  explicit SceneHandle(const Napi::CallbackInfo& info);
  void Finalize(Napi::BasicEnv env) override;

  /// @throws Napi::TypeError after detach()
  std::shared_ptr<const Scene> scene() const;
  std::shared_ptr<const Scene> detach();

 private:
  std::shared_ptr<const Scene> scene_;
  std::int64_t accounted_ = 0;
};

/// {scene, facts: string}
Napi::Object sceneToJs(Napi::Env env, const std::shared_ptr<const Scene>& scene, const std::string& facts);

/// A renderer on its thread. Collected without close(), it still ends its thread.
class RendererHandle : public Napi::ObjectWrap<RendererHandle> {
 public:
  static constexpr napi_type_tag TAG{0x74656c6172000004, 0x9a3f5c1e7b2d4860};
  static Napi::Function define(Napi::Env env);
  /// What the object is made of.
  struct Parts {
    std::shared_ptr<GlThread> thread;
    RendererOptions options;
  };
  static Napi::Object make(Napi::Env env, Parts parts);
  explicit RendererHandle(const Napi::CallbackInfo& info);
  ~RendererHandle() override;

 private:
  Napi::Value render(const Napi::CallbackInfo& info);
  Napi::Value release(const Napi::CallbackInfo& info);
  Napi::Value liveObjects(const Napi::CallbackInfo& info);
  Napi::Value close(const Napi::CallbackInfo& info);
  /// A job on the thread; rejects with X_BUSY where its queue is full, with X_CLOSED where it is ending.
  /// @param next  what to do on the thread where the work returned false: the job goes on elsewhere
  Napi::Value run(Napi::Env env, const std::shared_ptr<Job>& job, std::function<bool(Renderer&)> work,
                  std::function<void()> next = {});

  std::shared_ptr<GlThread> thread_;
  RendererOptions options_;
  std::shared_ptr<FreedMemory> freed_ = std::make_shared<FreedMemory>();  ///< touched by the thread only
  bool closing_ = false;
};

/// Makes a handle around a C++ value, which travels in an External to the constructor.
template <class T>
Napi::Object construct(const Napi::FunctionReference& constructor, T value) {
  return constructor.New({Napi::External<T>::New(constructor.Env(), &value)});
}

/// In the constructor: the value that construct() sent. @throws Napi::TypeError where JavaScript called it
template <class T>
T take(const Napi::CallbackInfo& info) {
  if (!info[0].IsExternal()) throw Napi::TypeError::New(info.Env(), "native telar makes this handle itself");
  return std::move(*info[0].As<Napi::External<T>>().Data());
}

/// The C++ object behind a JavaScript one. @throws Napi::TypeError for anything else
template <class Handle>
Handle& unwrap(const Napi::Value& value) {
  if (value.IsObject() && value.As<Napi::Object>().CheckTypeTag(&Handle::TAG)) {
    return *Handle::Unwrap(value.As<Napi::Object>());
  }
  throw Napi::TypeError::New(value.Env(), "native telar expected a handle of another kind");
}

}  // namespace telar::addon
