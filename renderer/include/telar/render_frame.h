#pragma once
#include <memory>
#include <span>

#include "telar/progress.h"
#include "telar/renderer.h"

namespace telar {

/// Draws one frame by what the shot asks for: by following paths of light where it has `reference`, or where
/// tracedInstead() (telar/reference.h) says so and Embree is there; else by the raster. Call it on the raster's thread,
/// also for a frame that makes no GL call: the frames of one renderer stay in order.
/// @param environment  file bytes when shot.environment.source is kBytes
/// @param options  those that the raster was created with
/// @param progress  told by the path tracer alone
/// @throws Error as Renderer::draw() and drawReference(); never a partial frame
Frame renderFrame(Renderer& raster, const std::shared_ptr<const Scene>& scene, const Shot& shot,
                  std::span<const std::byte> environment, const RendererOptions& options, const CancelToken& cancel,
                  const Progress& progress, FrameInfo& info);

}  // namespace telar
