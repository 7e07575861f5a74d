#include <algorithm>
#include <chrono>
#include <glm/gtc/type_ptr.hpp>
#include <nlohmann/json.hpp>
#include <thread>

#include "core/picture_json.h"
#include "core/progress_json.h"
#include "frame/camera.h"
#include "frame/layers.h"
#include "telar/ambient.h"
#include "telar/reference.h"
#include "trace/library.h"

namespace telar {
namespace {

using Json = nlohmann::ordered_json;
using Source = Shot::Environment::Source;

ImageF readMap(const Shot& shot, std::span<const std::byte> bytes, const RendererOptions& options,
               const CancelToken& cancel) {
  std::vector<std::byte> own;
  if (shot.environment.source == Source::kPath) own = readEnvironmentFile(shot.environment.path, options.limits);
  if (shot.environment.source == Source::kStudio) own = readStudioFile(options.assetDirectory, options.limits);
  return readEnvironment(own.empty() ? bytes : std::span<const std::byte>(own), options.limits, cancel,
                         EnvironmentRange::kFull);
}

const char* nameOf(Source source) { return source == Source::kStudio ? "bundled" : "file"; }

Json describe(const Shot& shot, const TraceFacts& facts, double environmentMs) {
  const glm::dmat4 toPixel = frame::worldToPixel(frame::cameraOf(shot), shot.width, shot.height);
  const bool lit = shot.environment.source != Source::kNone;
  Json json = {{"features", Json::array()},
               {"programs", Json::array()},
               {"passes", {"trace"}},
               {"backend", "reference"},
               {"gl", Json::object()},
               {"samples", facts.samples},
               {"drawCalls", 0},
               {"programsCompiled", 0},
               {"environmentSource", lit ? Json(nameOf(shot.environment.source)) : Json(nullptr)},
               {"threads", facts.threads},
               {"triangles", facts.triangles},
               {"rays", facts.rays},
               {"worldToPixel", std::vector<double>(glm::value_ptr(toPixel), glm::value_ptr(toPixel) + 16)},
               {"ms", {{"environment", environmentMs}, {"hierarchy", facts.hierarchyMs}, {"draw", facts.traceMs}}}};
  if (facts.picture) json["picture"] = toJson(*facts.picture);
  return json;
}

}  // namespace

Frame drawReference(const Scene& scene, const Shot& shot, std::span<const std::byte> environment,
                    const RendererOptions& options, const CancelToken& cancel, const Progress& progress,
                    FrameInfo& info) {
  using Clock = std::chrono::steady_clock;
  if (shot.debugOutput != DebugOutput::kNone)
    throw Error("E_SHOT_UNAVAILABLE", "a quantity of the shading is drawn by the raster: use quality \"standard\"")
        .at("/quality");
  const trace::Library library;
  const Clock::time_point start = Clock::now();
  const bool lit = shot.environment.source != Source::kNone;
  const ImageF map = lit ? readMap(shot, environment, options, cancel) : ImageF();
  const double environmentMs = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
  TraceJob job{scene, shot, lit ? &map : nullptr, options.limits, cancel, progress};
  library.function<TelarReferenceDrawFunction>("telar_reference_draw")(&job);
  if (job.failure) trace::throwFailure(*job.failure);
  Json json = describe(shot, job.facts, environmentMs);
  tellEnd(json, progress, job.facts.end);
  if (!job.frame.layers.empty()) json["layers"] = frame::describeLayers(scene, shot, job.frame.layers);
  info.json = json.dump();
  return std::move(job.frame);
}

std::vector<float> ambientOcclusion(const Scene& scene, const Shot& shot, std::span<const SurfacePoint> points,
                                    const CancelToken& cancel) {
  const trace::Library library;
  const int threads = static_cast<int>(std::max(std::thread::hardware_concurrency(), 1u));
  AmbientJob job{scene, shot, points, threads, cancel};
  library.function<TelarReferenceAmbientFunction>("telar_reference_ambient")(&job);
  if (job.failure) trace::throwFailure(*job.failure);
  return std::move(job.open);
}

std::string probeReference() {
  try {
    const trace::Library library;
    return Json{{"works", true},
                {"version", library.function<TelarReferenceVersionFunction>("telar_reference_version")()}}
        .dump();
  } catch (const Error& error) {
    return Json{{"works", false}, {"failure", error.what()}}.dump();
  }
}

}  // namespace telar
