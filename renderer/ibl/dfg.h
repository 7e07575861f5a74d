#pragma once
#include "gl/gl_object.h"
#include "telar/shading.h"

namespace telar::ibl {

/// The table of the split sum that a release of three.js reads, as an RG16F texture, linear, clamped: x =
/// perceptualRoughness, y = NoV, RG = (A, B).
gl::Texture createDfgTexture(const gl::Functions& gl, const ThreeTerms& three = {});

}  // namespace telar::ibl
