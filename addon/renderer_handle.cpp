#include <chrono>

#include "handles.h"
#include "state.h"
#include "telar/codec.h"
#include "telar/layers.h"
#include "telar/render_frame.h"
#include "telar/reused_memory.h"

namespace telar::addon {
namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// One render on its way: drawn on the renderer's thread, then encoded on the pool while that thread draws the next.
struct Render {
  std::shared_ptr<const Scene> scene;
  std::string shotJson;
  std::shared_ptr<const FileBytes> environment;
  RendererOptions options;
  Progress progress;
  bool releaseScene = false;  ///< nobody draws it again: free its GPU copies after this frame

  Clock::time_point since = Clock::now();  ///< begin of the current stage
  double queueMs = 0, drawMs = 0, encodeMs = 0;
  OutputOptions output;
  Frame frame;
  FrameInfo info;
  Bytes encoded;
  std::vector<std::pair<std::string, Bytes>> layers;  ///< encoded, by name

  double lap() {
    const double ms = millisecondsSince(since);
    since = Clock::now();
    return ms;
  }
};

void draw(Render& render, Renderer& renderer, FreedMemory& freed, const CancelToken& cancel) {
  render.queueMs = render.lap();
  const Shot shot = parseShot(render.shotJson);
  render.output = shot.output;
  const std::span<const std::byte> environment =
      render.environment ? std::span(*render.environment) : std::span<const std::byte>();
  try {
    render.frame =
        renderFrame(renderer, render.scene, shot, environment, render.options, cancel, render.progress, render.info);
  } catch (...) {
    if (render.releaseScene) renderer.release(*render.scene);
    throw;
  }
  if (render.releaseScene) renderer.release(*render.scene);
  const std::uint64_t bytes = render.releaseScene ? render.scene->memoryBytes : 0;
  render.scene.reset();
  freed.add(bytes);
  render.drawMs = render.lap();
}

Napi::Value toJs(Napi::Env env, Render& render) {
  Napi::Object object = Napi::Object::New(env);
  object["data"] = bytesToJs(env, std::move(render.encoded));
  Napi::Object layers = Napi::Object::New(env);
  for (auto& [name, bytes] : render.layers) layers[name] = bytesToJs(env, std::move(bytes));
  object["layers"] = layers;
  object["width"] = render.frame.width;
  object["height"] = render.frame.height;
  object["info"] = render.info.json;
  object["environmentSha256"] = render.info.environmentSha256;
  object["queueMs"] = render.queueMs;
  object["drawMs"] = render.drawMs;
  object["encodeMs"] = render.encodeMs;
  return object;
}

void encodeInto(Render& render, const CancelToken& cancel) {
  if (render.output.layers.together && !render.frame.layers.empty()) {
    render.encoded = encodeTogether(render.frame, render.output, cancel);
  } else {
    render.encoded = encode(render.frame, render.output, cancel);
    for (const LayerImage& layer : render.frame.layers) {
      const auto names = namesOf(layer.layer);
      render.layers.emplace_back(names[static_cast<std::size_t>(layer.layer)],
                                 encodeLayer(render.frame, layer, render.output, cancel));
    }
  }
  std::vector<std::byte>().swap(render.frame.pixels);
  std::vector<LayerImage>().swap(render.frame.layers);
  render.encodeMs = render.lap();
}

}  // namespace

Napi::Function RendererHandle::define(Napi::Env env) {
  return DefineClass(
      env, "Renderer",
      {InstanceMethod("render", &RendererHandle::render), InstanceMethod("release", &RendererHandle::release),
       InstanceMethod("liveObjects", &RendererHandle::liveObjects), InstanceMethod("close", &RendererHandle::close)});
}

Napi::Object RendererHandle::make(Napi::Env env, Parts parts) {
  return construct(State::of(env).rendererClass, std::move(parts));
}

RendererHandle::RendererHandle(const Napi::CallbackInfo& info) : ObjectWrap(info) {
  auto [thread, options] = take<Parts>(info);
  thread_ = std::move(thread);
  options_ = std::move(options);
  info.This().As<Napi::Object>().TypeTag(&TAG);
}

RendererHandle::~RendererHandle() {
  if (thread_) thread_->finish();
}

Napi::Value RendererHandle::run(Napi::Env env, const std::shared_ptr<Job>& job, std::function<bool(Renderer&)> work,
                                std::function<void()> next) {
  const std::shared_ptr<Mailbox> mailbox = State::of(env).mailbox();
  const Napi::Value promise = mailbox->begin(env, job);
  const bool taken = thread_->post(
      [mailbox, job, work = std::move(work), next = std::move(next)](std::unique_ptr<Renderer>& renderer) {
        if (mailbox->perform(job, [&] { return work(*renderer); })) next();
      });
  if (!taken) {
    job->fault = closing_ ? Fault{"X_CLOSED", "the renderer was closed", {}, {}, {}}
                          : Fault{"X_BUSY", "too many frames wait for this renderer; try again later", {}, {}, {}};
    mailbox->deliver(job);
  }
  return promise;
}

/// render({scene, shot: string, environment?: Bytes, releaseScene: boolean}, token)
Napi::Value RendererHandle::render(const Napi::CallbackInfo& info) {
  const Napi::Env env = info.Env();
  const Napi::Object request = info[0].As<Napi::Object>();
  auto render = std::make_shared<Render>();
  render->shotJson = stringFromJs(request.Get("shot"), "the shot");
  const Napi::Value environment = request.Get("environment");
  if (!environment.IsUndefined()) render->environment = unwrap<BytesHandle>(environment).bytes();
  render->releaseScene = request.Get("releaseScene").ToBoolean();
  SceneHandle& handle = unwrap<SceneHandle>(request.Get("scene"));
  render->scene = render->releaseScene ? handle.detach() : handle.scene();

  TokenHandle& token = unwrap<TokenHandle>(info[1]);
  render->options = options_;
  render->progress = token.progress;
  auto job = std::make_shared<Job>(token.token);
  State& state = State::of(env);
  const auto drawn = [render, job, freed = freed_](Renderer& renderer) {
    draw(*render, renderer, *freed, job->cancel);
    return false;
  };
  const auto encoded = [render, job, mailbox = state.mailbox(), pool = state.pool()] {
    // First in line: a drawn frame is memory that waits.
    pool->postFirst([render, job, mailbox] {
      mailbox->perform(job, [&] {
        encodeInto(*render, job->cancel);
        job->value = [render](Napi::Env to) { return toJs(to, *render); };
        return true;
      });
    });
  };
  return run(env, job, drawn, encoded);
}

/// release(scene, forget: boolean): frees the GPU copies of a model; forget: it is not drawn again, free all of it.
Napi::Value RendererHandle::release(const Napi::CallbackInfo& info) {
  auto job = std::make_shared<Job>(CancelToken());
  SceneHandle& handle = unwrap<SceneHandle>(info[0]);
  auto scene = info[1].ToBoolean() ? handle.detach() : handle.scene();
  return run(info.Env(), job, [scene = std::move(scene), freed = freed_](Renderer& renderer) mutable {
    renderer.release(*scene);
    const std::uint64_t bytes = scene->memoryBytes;
    scene.reset();
    freed->add(bytes);
    return true;
  });
}

Napi::Value RendererHandle::liveObjects(const Napi::CallbackInfo& info) {
  auto job = std::make_shared<Job>(CancelToken());
  return run(info.Env(), job, [job](Renderer& renderer) {
    const int count = renderer.liveObjects();
    job->value = [count](Napi::Env env) { return Napi::Number::New(env, count); };
    return true;
  });
}

/// Resolves when every frame that waits is drawn, and the context is destroyed.
Napi::Value RendererHandle::close(const Napi::CallbackInfo& info) {
  const Napi::Env env = info.Env();
  auto job = std::make_shared<Job>(CancelToken());
  const std::shared_ptr<Mailbox> mailbox = State::of(env).mailbox();
  const Napi::Value promise = mailbox->begin(env, job);
  closing_ = true;
  const bool taken = thread_->finish([mailbox, job, freed = freed_](std::unique_ptr<Renderer>& renderer) {
    renderer.reset();
    freed->giveBack();
    giveFreedBack();
    mailbox->deliver(job);
  });
  if (!taken) mailbox->deliver(job);
  return promise;
}

}  // namespace telar::addon
