#pragma once
#include "gl/context.h"
#include "gl/gl_object.h"
#include "telar/cancel.h"
#include "telar/image.h"

namespace telar::ibl {

/// The sphere on a square texture, as shaders/environment/octahedral_map.glsl reads it: each level has a gutter of one
/// texel. RGBA16F, linear Rec.709.
struct OctahedralMap {
  static constexpr int LEAST_SIZE = 16;  ///< texels on the edge of the last level of a radianceMap()
  gl::Texture texture;
  int size = 0;  ///< texels on the edge of level 0, a power of two, the gutter with them
};

OctahedralMap createOctahedralMap(const gl::Functions& gl, int size, int levels);

/// Direction of a texel's middle in a level, unit. @param size  texels on its edge
glm::vec3 octahedralDirection(int x, int y, int size);

/// An equirectangular map with all its levels, each texel the mean of those of the level before.
/// @return size half of the map's width, a power of two of 512 or more
/// @throws Error{X_GL, X_CANCELLED}. Needs a current context.
OctahedralMap radianceMap(const gl::Context& context, const ImageF& map, const CancelToken& cancel);

}  // namespace telar::ibl
