#include <napi.h>

#include <cstdlib>

#include "allocations.h"
#include "convert.h"
#include "handles.h"
#include "images.h"
#include "isolation.h"
#include "loading.h"
#include "lobes.h"
#include "shown.h"
#include "state.h"
#include "telar/dress.h"
#include "telar/explode.h"
#include "telar/flat.h"
#include "telar/load.h"
#include "telar/measure.h"
#include "telar/part_opacities.h"
#include "telar/pose.h"
#include "telar/reference.h"
#include "telar/shot.h"
#include "telar/swatch.h"
#include "thread_heap.h"
#include "visibility.h"

/// The export table. Every function is called by js/ alone, with arguments that js/ has checked.
namespace telar::addon {
namespace {

/// load(path: string | Bytes, limits, {tolerant?: boolean, decodesLater?: boolean, parts?: Parts}, token)
///   -> Promise<{scene, facts: string}>
Napi::Value load(const Napi::CallbackInfo& info) {
  const Limits limits = limitsFromJs(info[1]);
  const Loading how(info[2], limits);
  auto job = std::make_shared<Job>(unwrap<TokenHandle>(info[3]).token);
  return how.run(info.Env(), job, [job, limits, how, source = Source(info[0])] {
    LoadOptions options = how.options;
    options.owner = source.bytes;
    auto scene = source.bytes ? loadBytes(*source.bytes, limits, job->cancel, options)
                              : loadPath(source.path, limits, job->cancel, options);
    std::string facts = describeScene(*scene, job->cancel);
    job->value = [scene, facts = std::move(facts)](Napi::Env env) { return sceneToJs(env, scene, facts); };
  });
}

/// explode(scene, distance: number, token) -> Promise<{scene, facts: string}>
Napi::Value explode(const Napi::CallbackInfo& info) {
  auto model = unwrap<SceneHandle>(info[0]).scene();
  const double distance = info[1].ToNumber().DoubleValue();
  auto job = std::make_shared<Job>(unwrap<TokenHandle>(info[2]).token);
  return State::of(info.Env()).runOnPool(info.Env(), job, [job, distance, model = std::move(model)]() mutable {
    auto scene = explodeScene(model, distance, job->cancel);
    model.reset();
    std::string facts = describeScene(*scene, job->cancel);
    job->value = [scene, facts = std::move(facts)](Napi::Env env) { return sceneToJs(env, scene, facts); };
  });
}

/// pose(scene, animation: number, time: number, forget: boolean, token) -> Promise<{scene, facts: string}>
/// forget: the model is free to go with the pose.
Napi::Value pose(const Napi::CallbackInfo& info) {
  SceneHandle& handle = unwrap<SceneHandle>(info[0]);
  const Pose pose{info[1].ToNumber().Int32Value(), info[2].ToNumber().DoubleValue()};
  auto job = std::make_shared<Job>(unwrap<TokenHandle>(info[4]).token);
  auto model = info[3].ToBoolean() ? handle.detach() : handle.scene();
  return State::of(info.Env()).runOnPool(info.Env(), job, [job, pose, model = std::move(model)]() mutable {
    auto scene = poseScene(model, pose, job->cancel);
    model.reset();
    std::string facts = describeScene(*scene, job->cancel);
    job->value = [scene, facts = std::move(facts)](Napi::Env env) { return sceneToJs(env, scene, facts); };
  });
}

std::vector<int> indicesFromJs(const Napi::Value& value) {
  const auto list = value.As<Napi::Array>();
  std::vector<int> out;
  for (std::uint32_t i = 0; i < list.Length(); ++i) out.push_back(list.Get(i).ToNumber().Int32Value());
  return out;
}

/// {materials: number[], nodes: number[], cloth?: scene, color?: [r, g, b], scale: number, rotation: number,
/// metresPerUv?: [u, v]}
Dressing dressingFromJs(const Napi::Object& value) {
  Dressing out;
  out.materials = indicesFromJs(value.Get("materials"));
  out.nodes = indicesFromJs(value.Get("nodes"));
  if (value.Get("cloth").IsObject()) out.cloth = unwrap<SceneHandle>(value.Get("cloth")).scene();
  if (value.Get("color").IsArray()) {
    const auto color = value.Get("color").As<Napi::Array>();
    const auto part = [&color](std::uint32_t i) { return color.Get(i).ToNumber().FloatValue(); };
    out.color = {part(0), part(1), part(2)};
  }
  out.scale = value.Get("scale").ToNumber().DoubleValue();
  out.rotation = value.Get("rotation").ToNumber().DoubleValue();
  if (value.Get("metresPerUv").IsArray()) {
    const auto metres = value.Get("metresPerUv").As<Napi::Array>();
    out.metresPerUv = {metres.Get(0u).ToNumber().DoubleValue(), metres.Get(1u).ToNumber().DoubleValue()};
  }
  return out;
}

/// dress(scene, dressings: object[], forget: boolean, token) -> Promise<{scene, facts: string}>
/// facts: of describeDressed(). forget: the model is freed with what is made of it.
Napi::Value dress(const Napi::CallbackInfo& info) {
  SceneHandle& handle = unwrap<SceneHandle>(info[0]);
  const auto list = info[1].As<Napi::Array>();
  std::vector<Dressing> dressings;
  for (std::uint32_t i = 0; i < list.Length(); ++i) dressings.push_back(dressingFromJs(list.Get(i).ToObject()));
  auto job = std::make_shared<Job>(unwrap<TokenHandle>(info[3]).token);
  auto model = info[2].ToBoolean() ? handle.detach() : handle.scene();
  const auto work = [job, model = std::move(model), dressings = std::move(dressings)]() mutable {
    auto scene = dressScene(model, dressings, job->cancel);
    model.reset();
    std::string facts = describeDressed(*scene);
    job->value = [scene, facts = std::move(facts)](Napi::Env env) { return sceneToJs(env, scene, facts); };
  };
  return State::of(info.Env()).runOnPool(info.Env(), job, work);
}

/// namesOf(scene, token) -> Promise<string>
Napi::Value names(const Napi::CallbackInfo& info) {
  auto scene = unwrap<SceneHandle>(info[0]).scene();
  auto job = std::make_shared<Job>(unwrap<TokenHandle>(info[1]).token);
  return textOnPool(info.Env(), job, [scene] { return describeNames(*scene); });
}

/// uvScales(scene, token) -> Promise<string>
Napi::Value uvScales(const Napi::CallbackInfo& info) {
  auto scene = unwrap<SceneHandle>(info[0]).scene();
  auto job = std::make_shared<Job>(unwrap<TokenHandle>(info[1]).token);
  return textOnPool(info.Env(), job, [scene, job] { return describeUvScales(*scene, job->cancel); });
}

/// measure(scene, request: string, token) -> Promise<string>
Napi::Value measure(const Napi::CallbackInfo& info) {
  auto scene = unwrap<SceneHandle>(info[0]).scene();
  auto request = stringFromJs(info[1], "a request");
  auto job = std::make_shared<Job>(unwrap<TokenHandle>(info[2]).token);
  return textOnPool(info.Env(), job, [scene, request, job] { return measureScene(*scene, request, job->cancel); });
}

/// swatch(scene, request: string, token) -> Promise<{scene, facts: string, meanBaseColor: number[] | null}>
Napi::Value swatch(const Napi::CallbackInfo& info) {
  auto scene = unwrap<SceneHandle>(info[0]).scene();
  auto request = stringFromJs(info[1], "a request");
  auto job = std::make_shared<Job>(unwrap<TokenHandle>(info[2]).token);
  return State::of(info.Env()).runOnPool(info.Env(), job, [job, scene, request] {
    Swatch square = swatchOf(scene, request, job->cancel);
    std::string facts = describeScene(*square.scene, job->cancel);
    job->value = [square = std::move(square), facts = std::move(facts)](Napi::Env env) {
      Napi::Object made = sceneToJs(env, square.scene, facts);
      if (square.meanBaseColor) {
        auto color = Napi::Array::New(env, 3);
        for (std::uint32_t c = 0; c < 3; ++c)
          color[c] = Napi::Number::New(env, (*square.meanBaseColor)[static_cast<int>(c)]);
        made.Set("meanBaseColor", color);
      } else {
        made.Set("meanBaseColor", env.Null());
      }
      return made;
    };
  });
}

/// drawFlat(scene, shot: string, request: string, token) -> Promise<string>
Napi::Value drawFlat(const Napi::CallbackInfo& info) {
  auto scene = unwrap<SceneHandle>(info[0]).scene();
  auto shot = stringFromJs(info[1], "the shot"), request = stringFromJs(info[2], "a request");
  auto job = std::make_shared<Job>(unwrap<TokenHandle>(info[3]).token);
  return textOnPool(info.Env(), job, [scene, shot, request, job] {
    return telar::drawFlat(*scene, parseShot(shot), request, job->cancel);
  });
}

/// hashModel(path: string | Bytes, limits, {tolerant?: boolean, parts?: Parts}, token) -> Promise<string>
Napi::Value hashModel(const Napi::CallbackInfo& info) {
  const Limits limits = limitsFromJs(info[1]);
  const Loading how(info[2], limits);
  auto job = std::make_shared<Job>(unwrap<TokenHandle>(info[3]).token);
  return how.run(info.Env(), job, [job, limits, how, source = Source(info[0])] {
    std::string text = source.bytes ? telar::hashModel(*source.bytes, limits, job->cancel, how.options)
                                    : telar::hashModel(source.path, limits, job->cancel, how.options);
    job->value = [text = std::move(text)](Napi::Env to) { return Napi::String::New(to, text); };
  });
}

/// hashFile(path: string | Bytes, limits, token) -> Promise<string>
Napi::Value hashFile(const Napi::CallbackInfo& info) {
  const Limits limits = limitsFromJs(info[1]);
  auto job = std::make_shared<Job>(unwrap<TokenHandle>(info[2]).token);
  return textOnPool(info.Env(), job, [job, limits, source = Source(info[0])] {
    return source.bytes ? telar::hashFile(*source.bytes) : telar::hashFile(source.path, limits, job->cancel);
  });
}

/// hashText(text: string) -> string: of its UTF-8, here and now
Napi::Value hashText(const Napi::CallbackInfo& info) {
  const std::string text = stringFromJs(info[0], "a text");
  return Napi::String::New(info.Env(), telar::hashFile(std::as_bytes(std::span(text))));
}

/// plan(scene, shot: string, limits, token, keep?: boolean) -> Promise<string>; the scene is gone afterwards unless it
/// is kept
Napi::Value plan(const Napi::CallbackInfo& info) {
  auto shot = stringFromJs(info[1], "the shot");
  const Limits limits = limitsFromJs(info[2]);
  auto job = std::make_shared<Job>(unwrap<TokenHandle>(info[3]).token);
  SceneHandle& handle = unwrap<SceneHandle>(info[0]);
  auto scene = info[4].ToBoolean() ? handle.scene() : handle.detach();
  return textOnPool(info.Env(), job, [scene, shot, limits] { return planFrame(*scene, parseShot(shot), limits); });
}

/// probe() -> Promise<string>
Napi::Value probe(const Napi::CallbackInfo& info) {
  return textOnPool(info.Env(), std::make_shared<Job>(CancelToken()), probeBackends);
}

/// probeReference() -> Promise<string>
Napi::Value probeTracer(const Napi::CallbackInfo& info) {
  return textOnPool(info.Env(), std::make_shared<Job>(CancelToken()), probeReference);
}

/// failureOfImageFiles() -> Promise<string>
Napi::Value probeFormats(const Napi::CallbackInfo& info) {
  return textOnPool(info.Env(), std::make_shared<Job>(CancelToken()), failureOfImageFiles);
}

/// probeIsolation(withFirst: boolean) -> Promise<string>
Napi::Value probeRights(const Napi::CallbackInfo& info) {
  const bool withFirst = info[0].ToBoolean();
  return textOnPool(info.Env(), std::make_shared<Job>(CancelToken()),
                    [withFirst] { return probeIsolation(withFirst); });
}

/// isolate(dataBytes: number) -> string; for a worker of the pool, which has nothing else to do
Napi::Value isolate(const Napi::CallbackInfo& info) {
  const double dataBytes = info[0].ToNumber().DoubleValue();
  return Napi::String::New(info.Env(), isolateProcess(dataBytes >= 1 ? static_cast<std::uint64_t>(dataBytes) : 0));
}

/// failedAllocations() -> number | null; null where libtelar_worker.so does not count them
Napi::Value countFailures(const Napi::CallbackInfo& info) {
  const std::optional<unsigned> failures = failedAllocations();
  return failures ? Napi::Number::New(info.Env(), *failures) : info.Env().Null();
}

/// createRenderer({backend, assetDirectory, cacheDirectory, cacheBytes, limits, allFeatures, maxQueued}, token)
///   -> Promise<{renderer, facts: string}>
Napi::Value createRenderer(const Napi::CallbackInfo& info) {
  const Napi::Env env = info.Env();
  const Napi::Object object = info[0].As<Napi::Object>();
  const RendererOptions options = rendererOptionsFromJs(object);
  const double maxQueued = object.Get("maxQueued").ToNumber().DoubleValue();
  auto job = std::make_shared<Job>(unwrap<TokenHandle>(info[1]).token);

  State& state = State::of(env);
  const std::shared_ptr<Mailbox> mailbox = state.mailbox();
  const Napi::Value promise = mailbox->begin(env, job);
  std::shared_ptr<GlThread> thread;
  try {
    thread = state.startGlThread(maxQueued >= 1 ? static_cast<std::size_t>(maxQueued) : 1);
  } catch (...) {
    job->fault = Fault::current();
    mailbox->deliver(job);
    return promise;
  }
  thread->post([mailbox, job, options, thread](std::unique_ptr<Renderer>& renderer) {
    mailbox->perform(job, [&] {
      growHeapOfThread();
      renderer = Renderer::create(options);
      job->value = [thread, options, facts = renderer->describe()](Napi::Env to) {
        Napi::Object result = Napi::Object::New(to);
        result["renderer"] = RendererHandle::make(to, {thread, options});
        result["facts"] = facts;
        return result;
      };
      return true;
    });
    if (!renderer) thread->finish();
  });
  return promise;
}

/// shutDown(exitCode?: number): for the process's "exit" event. process.exit() runs no cleanup hooks on the main
/// thread, and the GL driver's own exit handlers must not find a frame being drawn. With an exit code, a process whose
/// driver is stuck ends here and now with that code, as those handlers would crash it.
void shutDown(const Napi::CallbackInfo& info) {
  const bool ended = State::of(info.Env()).shutDown();
  if (!ended && info[0].IsNumber()) std::_Exit(info[0].As<Napi::Number>().Int32Value());
}

Napi::Object init(Napi::Env env, Napi::Object exports) {
  auto* state = new State(env);
  env.SetInstanceData<State>(state);
  state->sceneClass = Napi::Persistent(SceneHandle::define(env));
  state->rendererClass = Napi::Persistent(RendererHandle::define(env));
  exports["CancelToken"] = TokenHandle::define(env);
  exports["Bytes"] = BytesHandle::define(env);
  exports["Parts"] = PartsHandle::define(env);
  exports["load"] = Napi::Function::New(env, load, "load");
  exports["dress"] = Napi::Function::New(env, dress, "dress");
  exports["namesOf"] = Napi::Function::New(env, names, "namesOf");
  exports["uvScales"] = Napi::Function::New(env, uvScales, "uvScales");
  exports["withVisibility"] = Napi::Function::New(env, withVisibility, "withVisibility");
  exports["visibilityOf"] = Napi::Function::New(env, visibilityOf, "visibilityOf");
  exports["explode"] = Napi::Function::New(env, explode, "explode");
  exports["pose"] = Napi::Function::New(env, pose, "pose");
  exports["measurePart"] = Napi::Function::New(env, measurePart, "measurePart");
  exports["measureShown"] = Napi::Function::New(env, measureShown, "measureShown");
  exports["rangesAlong"] = Napi::Function::New(env, rangesAlong, "rangesAlong");
  exports["measure"] = Napi::Function::New(env, measure, "measure");
  exports["swatch"] = Napi::Function::New(env, swatch, "swatch");
  exports["drawFlat"] = Napi::Function::New(env, drawFlat, "drawFlat");
  exports["hashModel"] = Napi::Function::New(env, hashModel, "hashModel");
  exports["hashFile"] = Napi::Function::New(env, hashFile, "hashFile");
  exports["hashText"] = Napi::Function::New(env, hashText, "hashText");
  exports["plan"] = Napi::Function::New(env, plan, "plan");
  exports["probe"] = Napi::Function::New(env, probe, "probe");
  exports["probeReference"] = Napi::Function::New(env, probeTracer, "probeReference");
  exports["failureOfImageFiles"] = Napi::Function::New(env, probeFormats, "failureOfImageFiles");
  exports["probeIsolation"] = Napi::Function::New(env, probeRights, "probeIsolation");
  exports["isolate"] = Napi::Function::New(env, isolate, "isolate");
  exports["failedAllocations"] = Napi::Function::New(env, countFailures, "failedAllocations");
  exports["decodeImage"] = Napi::Function::New(env, decodeImage, "decodeImage");
  exports["encodePng"] = Napi::Function::New(env, encodePng, "encodePng");
  exports["evaluateLobes"] = Napi::Function::New(env, evaluateLobes, "evaluateLobes");
  exports["createRenderer"] = Napi::Function::New(env, createRenderer, "createRenderer");
  exports["shutDown"] = Napi::Function::New(env, shutDown, "shutDown");
  exports["limits"] = limitsToJs(env, Limits());
  return exports;
}

}  // namespace
}  // namespace telar::addon

static Napi::Object initTelar(Napi::Env env, Napi::Object exports) { return telar::addon::init(env, exports); }
NODE_API_MODULE(telar, initTelar)
