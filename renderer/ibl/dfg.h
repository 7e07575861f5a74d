#pragma once
#include "gl/gl_object.h"

namespace telar::ibl {

/// The split-sum table as a 16 x 16 RG16F texture, linear, clamped: x = perceptualRoughness, y = NoV, RG = (A, B).
gl::Texture createDfgTexture(const gl::Functions& gl);

}  // namespace telar::ibl
