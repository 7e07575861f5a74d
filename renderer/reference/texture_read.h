#pragma once
#include <glm/glm.hpp>

#include "telar/scene.h"

namespace telar::reference {

/// One use of a texture at a point, at full resolution: the tracer's many samples do what mip levels do in the raster.
/// @param uv    as in the file: the reference's own transform is applied here
/// @param srgb  decode to linear light before filtering
/// @return white where the reference has no texture
glm::vec4 readTexture(const Scene& scene, const TextureRef& texture, const glm::vec2& uv, bool srgb);

}  // namespace telar::reference
