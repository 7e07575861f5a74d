#include "telar/render_frame.h"

#include <chrono>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "telar/flat.h"
#include "telar/reference.h"

namespace telar {
namespace {

using Clock = std::chrono::steady_clock;

bool drawsLines(const Shot& shot) { return shot.style == Style::kFlat || shot.hasLayer(Layer::kLine); }

/// The picture is another one than elsewhere: the tracer's noise and light differ a little from the raster's.
void warnOfRaster(FrameInfo& info, const std::string& missing) {
  auto json = nlohmann::ordered_json::parse(info.json);
  json["warnings"].push_back(
      {{"code", "W_LIBRARY_MISSING"},
       {"message", "shot.quality: the raster draws \"high\" where the path tracer would, for less. " + missing},
       {"pointer", "/quality"}});
  info.json = json.dump();
}

}  // namespace

Frame renderFrame(Renderer& raster, const std::shared_ptr<const Scene>& scene, const Shot& shot,
                  std::span<const std::byte> environment, const RendererOptions& options, const CancelToken& cancel,
                  const Progress& progress, FrameInfo& info) {
  const auto shaded = [&] {
    const auto traced = [&](const Shot& how) {
      waitForImages(*scene, cancel);
      return drawReference(*scene, how, environment, options, cancel, progress, info);
    };
    if (shot.reference) return traced(shot);
    std::string missing;
    if (const auto instead = tracedInstead(*scene, shot)) {
      try {
        return traced(*instead);
      } catch (const Error& error) {
        // A host without Embree draws everything but "reference".
        if (error.code != "X_LIBRARY_MISSING") throw;
        missing = error.what();
      }
    }
    Frame frame = raster.draw(scene, shot, environment, cancel, info, progress);
    if (!missing.empty()) warnOfRaster(info, missing);
    return frame;
  };
  if (!drawsLines(shot)) return shaded();
  const Clock::time_point start = Clock::now();
  LayerImage lines = drawLines(*scene, shot, cancel);
  Frame frame;
  if (shot.isLinesAlone()) {
    waitForImages(*scene, cancel);  // a damaged one is told, whatever the picture shows
    info.json = describeFlat(shot, std::chrono::duration<double, std::milli>(Clock::now() - start).count());
  } else {
    frame = shaded();
  }
  if (shot.style == Style::kFlat) {
    Frame flat = flatFrame(lines, shot);
    flat.layers = std::move(frame.layers);
    frame = std::move(flat);
  }
  if (shot.hasLayer(Layer::kLine)) frame.layers.push_back(std::move(lines));
  return frame;
}

}  // namespace telar
