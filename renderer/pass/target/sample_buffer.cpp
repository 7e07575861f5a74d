#include "pass/target/sample_buffer.h"

namespace telar::pass {

bool SampleBuffer::allocate(const gl::Functions& gl, GLenum colorFormat, int samples, int width, int height) {
  width_ = width;
  height_ = height;
  framebuffer_ = gl::Framebuffer(gl);
  color_ = gl::Renderbuffer(gl);
  depth_ = gl::Renderbuffer(gl);
  const GLsizei count = samples > 1 ? samples : 0;
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.get());
  gl.BindRenderbuffer(GL_RENDERBUFFER, color_.get());
  gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, count, colorFormat, width, height);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color_.get());
  gl.BindRenderbuffer(GL_RENDERBUFFER, depth_.get());
  gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, count, GL_DEPTH24_STENCIL8, width, height);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, depth_.get());
  return gl.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

void SampleBuffer::bind(const gl::Functions& gl) const {
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.get());
  gl.Viewport(0, 0, width_, height_);
}

void SampleBuffer::resolveInto(const gl::Functions& gl, GLuint framebuffer) const {
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.get());
  gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
  gl.BlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

}  // namespace telar::pass
