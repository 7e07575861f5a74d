#include "telar/render_frame.h"

#include "telar/reference.h"

namespace telar {

Frame renderFrame(Renderer& raster, const std::shared_ptr<const Scene>& scene, const Shot& shot,
                  std::span<const std::byte> environment, const RendererOptions& options, const CancelToken& cancel,
                  const Progress& progress, FrameInfo& info) {
  if (shot.reference) return drawReference(*scene, shot, environment, options, cancel, progress, info);
  return raster.draw(scene, shot, environment, cancel, info);
}

}  // namespace telar
