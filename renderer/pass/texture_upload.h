#pragma once
#include "gl/context.h"
#include "pass/mip_levels.h"
#include "telar/image.h"

namespace telar::pass {

/// Fills the bound 2D texture with an image and its mip levels: SRGB8_ALPHA8 or RGBA8, RGBA16F, RGBA32F, or blocks as
/// the file has them. Levels that the file lacks are generated, or made as MissingLevels says.
/// @throws Error{E_IMAGE_FORMAT} where this GL does not read such blocks, as a browser on the same GPU does not
void uploadTexture(const gl::Context& context, MipMaker& mips, const Image8& image, bool srgb);

}  // namespace telar::pass
