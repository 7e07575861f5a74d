#pragma once

#include "gl/context.h"
#include "gl/program.h"
#include "telar/cancel.h"
#include "telar/image.h"

namespace telar::ibl {

/// A cube map in standard GL orientation: read with the world direction. RGBA16F, linear Rec.709.
struct CubeMap {
  gl::Texture texture;
  int faceSize = 0;  ///< px, power of two
  int levels = 0;
};

/// Direction of a place on a face, not unit. @param face  0..5 in the order of GL    @param s, t  [-1, 1]
glm::vec3 faceDirection(int face, float s, float t);

CubeMap createCube(const gl::Functions& gl, int faceSize, int levels);

/// Draws a triangle over one level of a square image of a texture, by the program that is in use.
/// @param image  GL_TEXTURE_2D or a face of a cube    @param size  px of the level
void renderLevel(const gl::Context& context, gl::DrawCost& cost, GLenum image, const gl::Texture& texture, int level,
                 int size, const CancelToken& cancel);

/// Runs a fragment program over the six faces of one level. The program is in use and its uniforms are set; it reads
/// vDirection of environment/cube_face.vert.
void renderFaces(const gl::Context& context, const gl::Program& program, gl::DrawCost& cost, const CubeMap& target,
                 int level, const CancelToken& cancel);

/// An equirectangular map as an RGBA16F texture, bilinear, clamped: row 0 of the image (+Y) is at v = 1. What is more
/// than 65504 becomes so much.
gl::Texture uploadEquirect(const gl::Functions& gl, const ImageF& map);

/// Equirectangular map to level 0 of a cube. `supersample` as in environment/equirect_to_cube.frag.
CubeMap equirectToCube(const gl::Context& context, const gl::Texture& equirect, int faceSize, int levels,
                       bool supersample, const CancelToken& cancel);

}  // namespace telar::ibl
