#include "telar/render_frame.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "telar/flat.h"
#include "telar/reference.h"

namespace telar {
namespace {

using Clock = std::chrono::steady_clock;

bool drawsLines(const Shot& shot) { return shot.style == Style::kFlat || shot.hasLayer(Layer::kLine); }

/// Whether lines are all that the shot shows.
bool isLinesAlone(const Shot& shot) {
  return shot.style == Style::kFlat &&
         std::all_of(shot.layers.begin(), shot.layers.end(), [](Layer layer) { return layer == Layer::kLine; });
}

}  // namespace

Frame renderFrame(Renderer& raster, const std::shared_ptr<const Scene>& scene, const Shot& shot,
                  std::span<const std::byte> environment, const RendererOptions& options, const CancelToken& cancel,
                  const Progress& progress, FrameInfo& info) {
  const auto shaded = [&] {
    if (shot.reference) return drawReference(*scene, shot, environment, options, cancel, progress, info);
    return raster.draw(scene, shot, environment, cancel, info);
  };
  if (!drawsLines(shot)) return shaded();
  const Clock::time_point start = Clock::now();
  LayerImage lines = drawLines(*scene, shot, cancel);
  Frame frame;
  if (isLinesAlone(shot)) {
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
