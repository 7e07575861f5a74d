#include "ibl/cube.h"

#include <algorithm>
#include <glm/gtc/packing.hpp>

#include "gl/clamped_sampling.h"
#include "gl/incomplete.h"
#include "shader/library.h"
#include "telar/codec.h"

namespace telar::ibl {
namespace {

struct Face {
  glm::vec3 centre, right, up;  // direction = centre + s right + t up, s and t in [-1, 1] (OpenGL ES 3.0 table 3.21)
};

constexpr Face FACES[6] = {
    {{1, 0, 0}, {0, 0, -1}, {0, -1, 0}}, {{-1, 0, 0}, {0, 0, 1}, {0, -1, 0}}, {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}},
    {{0, -1, 0}, {1, 0, 0}, {0, 0, -1}}, {{0, 0, 1}, {1, 0, 0}, {0, -1, 0}},  {{0, 0, -1}, {-1, 0, 0}, {0, -1, 0}},
};

}  // namespace

glm::vec3 faceDirection(int face, float s, float t) {
  const Face& f = FACES[face];
  return f.centre + f.right * s + f.up * t;
}

CubeMap createCube(const gl::Functions& gl, int faceSize, int levels) {
  CubeMap cube{gl::Texture(gl), faceSize, levels};
  gl.BindTexture(GL_TEXTURE_CUBE_MAP, cube.texture.get());
  gl.TexStorage2D(GL_TEXTURE_CUBE_MAP, levels, GL_RGBA16F, faceSize, faceSize);
  gl::setClampedSampling(gl, GL_TEXTURE_CUBE_MAP, levels > 1 ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR, GL_LINEAR);
  return cube;
}

void renderLevel(const gl::Context& context, gl::DrawCost& cost, GLenum image, const gl::Texture& texture, int level,
                 int size, const CancelToken& cancel) {
  cancel.check();
  const gl::Functions& gl = context.gl();
  const gl::Framebuffer framebuffer(gl);
  const gl::VertexArray noVertices(gl);
  gl.BindVertexArray(noVertices.get());
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.get());
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, image, texture.get(), level);
  if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) gl::failIncomplete(gl, "the environment");
  gl.Viewport(0, 0, size, size);
  for (const GLenum capability : {GL_DEPTH_TEST, GL_BLEND, GL_CULL_FACE, GL_SCISSOR_TEST}) gl.Disable(capability);
  const gl::Pacer::Rectangle whole{0, 0, size, size};
  context.pacer().draw(cost, whole.area(), whole, [&gl] { gl.DrawArrays(GL_TRIANGLES, 0, 3); });
  context.pacer().finish();
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
}

void renderFaces(const gl::Context& context, const gl::Program& program, gl::DrawCost& cost, const CubeMap& target,
                 int level, const CancelToken& cancel) {
  for (int i = 0; i < 6; ++i) {
    program.set("faceCentre", FACES[i].centre);
    program.set("faceRight", FACES[i].right);
    program.set("faceUp", FACES[i].up);
    renderLevel(context, cost, GL_TEXTURE_CUBE_MAP_POSITIVE_X + static_cast<GLenum>(i), target.texture, level,
                target.faceSize >> level, cancel);
  }
}

gl::Texture uploadEquirect(const gl::Functions& gl, const ImageF& map) {
  const std::size_t row = static_cast<std::size_t>(map.width) * 4;
  std::vector<std::uint16_t> halfs(row * map.height);
  for (std::uint32_t y = 0; y < map.height; ++y) {
    const float* from = &map.pixels[y * row];
    std::uint16_t* to = &halfs[(map.height - 1 - y) * row];
    std::transform(from, from + row, to, [](float x) { return glm::packHalf1x16(std::min(x, HALF_MAX)); });
  }
  gl::Texture texture(gl);
  gl.BindTexture(GL_TEXTURE_2D, texture.get());
  gl.TexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA16F, static_cast<GLsizei>(map.width), static_cast<GLsizei>(map.height));
  gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, static_cast<GLsizei>(map.width), static_cast<GLsizei>(map.height), GL_RGBA,
                   GL_HALF_FLOAT, halfs.data());
  gl::setClampedSampling(gl, GL_TEXTURE_2D, GL_LINEAR, GL_LINEAR);
  return texture;
}

CubeMap equirectToCube(const gl::Context& context, const gl::Texture& equirect, int faceSize, int levels,
                       bool supersample, const CancelToken& cancel) {
  const gl::Functions& gl = context.gl();
  CubeMap cube = createCube(gl, faceSize, levels);
  const gl::Program program(
      context, "equirect_to_cube", shader::assemble("environment/cube_face.vert", {}),
      shader::assemble("environment/equirect_to_cube.frag", {{"SUPERSAMPLE", supersample ? 1 : 0}}));
  program.use();
  program.set("equirectMap", 0);
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindTexture(GL_TEXTURE_2D, equirect.get());
  gl::DrawCost cost;
  renderFaces(context, program, cost, cube, 0, cancel);
  return cube;
}

}  // namespace telar::ibl
