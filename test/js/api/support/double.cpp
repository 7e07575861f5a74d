#include <array>
#include <chrono>
#include <cstring>
#include <new>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

#include "telar/codec.h"
#include "telar/dress.h"
#include "telar/explode.h"
#include "telar/load.h"
#include "telar/part.h"
#include "telar/pose.h"
#include "telar/reference.h"
#include "telar/renderer.h"
#include "telar/visibility.h"

/// Stands in for the loader, the renderer and the encoder in tests of threads, cancellation and lifetimes. The model is
/// JSON that says what each stage does:
/// {"loadMs", "poseMs", "drawMs", "encodeMs": how long it works, "stubborn": whether it ignores cancellation,
///  "fail": {"stage": "load" | "pose" | "draw" | "encode", "as": "error" | "memory" | "exception" | "number"}}
namespace telar {
namespace {

using nlohmann::json;
using Clock = std::chrono::steady_clock;

void work(const json& plan, const char* stage, const CancelToken& cancel) {
  const auto end = Clock::now() + std::chrono::milliseconds(plan.value(std::string(stage) + "Ms", 0));
  const bool stubborn = plan.value("stubborn", false);
  while (Clock::now() < end) {
    if (!stubborn) cancel.check();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  const json fail = plan.value("fail", json::object());
  if (fail.value("stage", "") != stage) return;
  const std::string as = fail.value("as", "error");
  if (as == "memory") throw std::bad_alloc();
  if (as == "exception") throw std::logic_error("the double was told to fail");
  if (as == "number") throw 42;
  Error error("L_VERTICES", "the double was told to fail");
  throw error.at("/accessors/3").atOffset(5'000'000'000).withLimit("L_VERTICES", 10, 11);
}

std::shared_ptr<const Scene> load(std::string text, const CancelToken& cancel) {
  work(json::parse(text), "load", cancel);
  auto scene = std::make_shared<Scene>();
  scene->name = std::move(text);
  scene->bounds.add(glm::dvec3(-1));
  scene->bounds.add(glm::dvec3(1));
  return scene;
}

class Double : public Renderer {
 public:
  Frame draw(const std::shared_ptr<const Scene>& scene, const Shot& shot, std::span<const std::byte> environment,
             const CancelToken& cancel, FrameInfo& info, const Progress&) override {
    if (std::this_thread::get_id() != thread_)
      throw std::logic_error("draw() was called on another thread than create()");
    const json plan = json::parse(scene->name);
    scenes_.insert(scene.get());
    work(plan, "draw", cancel);
    Frame frame{static_cast<std::uint32_t>(shot.width), static_cast<std::uint32_t>(shot.height), PixelType::kRgba8, {}};
    frame.pixels.resize(std::size_t{4} * frame.width * frame.height, std::byte{0x7f});
    // encode() sees no scene: the plan travels in front of the pixels.
    std::vector<std::byte> head(scene->name.size() + 1);
    std::memcpy(head.data(), scene->name.c_str(), head.size());
    frame.pixels.insert(frame.pixels.begin(), head.begin(), head.end());
    std::uint32_t sum = 0;
    for (const std::byte byte : environment) sum += std::to_integer<std::uint32_t>(byte);
    info.json = json{{"features", json::array()},
                     {"passes", {"wait"}},
                     {"environmentBytes", environment.size()},
                     {"environmentSum", sum},
                     {"environmentPath", shot.environment.path}}
                    .dump();
    return frame;
  }
  void release(const Scene& scene) override { scenes_.erase(&scene); }
  std::string describe() const override {
    return R"({"backend": "double", "vendor": "telar", "renderer": "none", "version": "0"})";
  }
  int liveObjects() const override { return static_cast<int>(scenes_.size()); }

 private:
  std::thread::id thread_ = std::this_thread::get_id();
  std::set<const Scene*> scenes_;
};

}  // namespace

std::string hashModel(const std::filesystem::path& file, const Limits&, const CancelToken&, const LoadOptions&) {
  return file.string();
}
std::string hashModel(std::span<const std::byte> file, const Limits&, const CancelToken&, const LoadOptions&) {
  return std::to_string(file.size());
}
std::string hashFile(const std::filesystem::path& file, const Limits&, const CancelToken&) { return file.string(); }
std::string hashFile(std::span<const std::byte> file) { return std::to_string(file.size()); }

std::shared_ptr<const Scene> loadPath(const std::filesystem::path& file, const Limits&, const CancelToken& cancel,
                                      const LoadOptions&) {
  return load(file.stem().string(), cancel);
}

std::shared_ptr<const Scene> loadBytes(std::span<const std::byte> file, const Limits&, const CancelToken& cancel,
                                       const LoadOptions&) {
  return load(std::string(reinterpret_cast<const char*>(file.data()), file.size()), cancel);
}

std::shared_ptr<const Scene> poseScene(const std::shared_ptr<const Scene>& model, const Pose&,
                                       const CancelToken& cancel) {
  work(json::parse(model->name), "pose", cancel);
  auto scene = std::make_shared<Scene>(*model);
  scene->model = model;
  return scene;
}

std::string describeScene(const Scene& scene, const CancelToken&) {
  return json{{"bounds", {{"min", {-1, -1, -1}}, {"max", {1, 1, 1}}}},
              {"size", {2, 2, 2}},
              {"cameras", json::array()},
              {"animations", {{{"name", "wait"}, {"duration", 1}}}},
              {"variants", json::array()},
              {"warnings", json::array({{{"code", "W_IMAGE"}, {"message", "from the model"}}})},
              {"plan", scene.name}}
      .dump();
}

std::string describePart(const Scene&, const PartQuery&, const std::vector<Shot::Ghost>&, const CancelToken&) {
  return R"({"found": false, "bounds": null, "outline": [], "names": []})";
}

std::string describeShown(const Scene&, const std::string&, const std::vector<Shot::Ghost>&, const CancelToken&) {
  return R"({"bounds": null, "outline": []})";
}

std::string describeRanges(const Scene&, const std::array<glm::dvec3, 3>&, const std::string&,
                           const std::vector<Shot::Ghost>&, const CancelToken&) {
  return "null";
}

std::vector<std::byte> encode(const Frame& frame, const OutputOptions&, const CancelToken& cancel) {
  work(json::parse(reinterpret_cast<const char*>(frame.pixels.data())), "encode", cancel);
  return frame.pixels;
}

std::unique_ptr<Renderer> Renderer::create(const RendererOptions& options) {
  if (options.backend == Backend::kOsmesa) throw Error("X_GL", "the double has no OSMesa");
  // cacheDirectory doubles as a delay, to abort creation.
  if (options.cacheDirectory.ends_with("/slow")) std::this_thread::sleep_for(std::chrono::milliseconds(200));
  return std::make_unique<Double>();
}

std::string planFrame(const Scene&, const Shot&, const Limits&) {
  return R"({"features": ["wait"], "programs": [], "passes": ["wait"]})";
}

Frame drawReference(const Scene& scene, const Shot& shot, std::span<const std::byte>, const RendererOptions&,
                    const CancelToken& cancel, const Progress& progress, FrameInfo& info) {
  const json plan = json::parse(scene.name);
  progress.reach(0.5f);
  work(plan, "draw", cancel);
  progress.reach(1);
  Frame frame{static_cast<std::uint32_t>(shot.width), static_cast<std::uint32_t>(shot.height), PixelType::kRgba8, {}};
  const auto* head = reinterpret_cast<const std::byte*>(scene.name.c_str());
  frame.pixels.assign(head, head + scene.name.size() + 1);
  info.json = json{{"features", json::array()}, {"passes", {"trace"}}, {"backend", "reference"}}.dump();
  return frame;
}

std::shared_ptr<const Scene> withAmbientVisibility(const std::shared_ptr<const Scene>& model, int,
                                                   const VisibilityCache&, const Limits&, const CancelToken&) {
  return model;
}

std::shared_ptr<const Scene> explodeScene(const std::shared_ptr<const Scene>& model, double, const CancelToken&) {
  return model;
}

std::shared_ptr<const Scene> dressScene(const std::shared_ptr<const Scene>& model, const std::vector<Dressing>&,
                                        const CancelToken&) {
  return model;
}

std::string describeDressed(const Scene&) { return "{}"; }

std::string describeNames(const Scene&) { return R"({"materials": [], "nodes": []})"; }

std::string describeUvScales(const Scene&, const CancelToken&) { return "[]"; }

std::string probeReference() { return R"({"works": true, "version": "double"})"; }

std::string probeBackends() { return R"({"chosen": "double", "backends": []})"; }

}  // namespace telar
