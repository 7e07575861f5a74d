#include "pass/target/settled_mask.h"

#include "gl/nearest_texture.h"
#include "shader/library.h"

namespace telar::pass {

void SettledMask::set(std::span<const std::uint8_t> settled, int width, int height) {
  const gl::Functions& gl = context_.gl();
  gl.ActiveTexture(GL_TEXTURE0);
  texture_ = gl::nearestTexture(gl, GL_R8, width, height);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RED, GL_UNSIGNED_BYTE, settled.data());
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
}

void SettledMask::draw() {
  const gl::Functions& gl = context_.gl();
  if (!noVertices_) {
    program_ = gl::Program(context_, "settled", shader::assemble("settled/settled.vert", {}),
                           shader::assemble("settled/settled.frag", {}));
    noVertices_ = gl::VertexArray(gl);
  }
  program_.use();
  program_.set("settledMap", 0);
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindTexture(GL_TEXTURE_2D, texture_.get());
  gl.BindSampler(0, 0);
  gl.BindVertexArray(noVertices_.get());
  for (const GLenum capability : {GL_BLEND, GL_CULL_FACE, GL_SCISSOR_TEST}) gl.Disable(capability);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_ALWAYS);
  gl.DepthMask(GL_TRUE);
  gl.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

}  // namespace telar::pass
