#pragma once
#include "gl/context.h"
#include "gl/gl_object.h"

namespace telar::pass {

/// Tables of the GGX lobe as a linearly transformed cosine, 64 x 64, for light/area.glsl: x = perceptualRoughness,
/// y = sqrt(1 - NoV), texel centres at i / 63. Empty until a frame has a rect light.
struct LtcTextures {
  gl::Texture inverse;  ///< RGBA: the entries of the inverse matrix that are not 0 or 1
  gl::Texture albedo;   ///< RG: scale and bias of f0

  explicit operator bool() const { return static_cast<bool>(inverse); }
};

/// fp32 where the driver filters it, else fp16: as three.js 0.187 chooses.
LtcTextures createLtcTextures(const gl::Context& context);

}  // namespace telar::pass
