#pragma once
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "frame/camera.h"
#include "telar/ambient.h"

namespace telar::pass {

/// What a pass has found of a picture's pixels, row 0 on top.
struct SurfacePixels {
  std::span<const glm::vec4> place;   ///< w metres along the view
  std::span<const glm::vec4> number;  ///< x 0 where nothing is seen; zw geometric normal, view space, on an octahedron
  int width = 0, height = 0;
};

/// Ambient occlusion of each pixel, 0..1; 0 where nothing is seen. Pixels of a square of 4 x 4 cast rays of different
/// sets, which together fill the hemisphere evenly, and each takes the mean of those about it on the same surface.
/// src: Keller and Heidrich 2001, "Interleaved Sampling"
/// @throws as ambientOcclusion()
std::vector<float> ambientLayer(const SurfacePixels& pixels, const frame::Camera& camera, const Scene& scene,
                                const Shot& shot, const CancelToken& cancel);

}  // namespace telar::pass
