#pragma once
#include <cstdint>
#include <vector>

#include "gl/context.h"
#include "gl/program.h"
#include "telar/cancel.h"

namespace telar::ibl {

/// What three.js to 0.186 prefilters an environment to: the levels of a cube as tiles of one texture, laid out as
/// shaders/environment/atlas.glsl has it. RGBA16F, linear Rec.709.
struct Atlas {
  gl::Texture texture;
  int faceSize = 0;  ///< px of the sharpest level, power of two

  int width() const;
  int height() const { return 4 * faceSize; }
  int maxMip() const;  ///< log2(faceSize)
  int levels() const;
  int edgeOf(int level) const;                             ///< px
  int mipOf(int level) const { return maxMip() - level; }  ///< as the shaders count
  gl::Pacer::Rectangle tilesOf(int level) const;           ///< the six faces of a level
  glm::vec2 texel() const;                                 ///< 1 / size
};

/// Its texels are not set. @throws Error{X_GL} where the GL has no texture of that size
Atlas createAtlas(const gl::Context& context, int faceSize);

/// RGBA halfs, row by row from the bottom. What no level covers is 0.
std::vector<std::uint16_t> readAtlas(const gl::Context& context, const Atlas& atlas);

/// Runs a fragment program over the tiles of one level. The program, of environment/atlas_tiles.vert, is in use and its
/// uniforms are set.
void renderTiles(const gl::Context& context, gl::DrawCost& cost, const Atlas& target, int level,
                 const CancelToken& cancel);

}  // namespace telar::ibl
