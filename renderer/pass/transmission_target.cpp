#include "pass/transmission_target.h"

#include <algorithm>
#include <bit>

#include "telar/error.h"

namespace telar::pass {

TransmissionTarget::TransmissionTarget(const gl::Context& context, int width, int height)
    : context_(context), width_(width), height_(height), color_(context.gl()), resolved_(context.gl()) {
  const gl::Functions& gl = context_.gl();
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindTexture(GL_TEXTURE_2D, color_.get());
  gl.TexStorage2D(GL_TEXTURE_2D, std::bit_width(static_cast<unsigned>(std::max(width, height))), GL_RGBA16F, width,
                  height);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  gl.BindFramebuffer(GL_FRAMEBUFFER, resolved_.get());
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color_.get(), 0);
  constexpr int SAMPLES = 4;
  // A GPU may lack multisampled half floats.
  const bool complete = tryStorage(std::min(SAMPLES, context.capabilities().maxSamples)) || tryStorage(0);
  context_.check("creation of the transmission target");
  if (!complete) throw Error("X_GL", "this GL driver does not render to half floats, which transmission needs");
}

bool TransmissionTarget::tryStorage(int samples) {
  const gl::Functions& gl = context_.gl();
  draw_ = gl::Framebuffer(gl);
  samplesColor_ = gl::Renderbuffer(gl);
  samplesDepth_ = gl::Renderbuffer(gl);
  const GLsizei count = samples > 1 ? samples : 0;
  gl.BindFramebuffer(GL_FRAMEBUFFER, draw_.get());
  gl.BindRenderbuffer(GL_RENDERBUFFER, samplesColor_.get());
  gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, count, GL_RGBA16F, width_, height_);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, samplesColor_.get());
  gl.BindRenderbuffer(GL_RENDERBUFFER, samplesDepth_.get());
  gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, count, GL_DEPTH_COMPONENT24, width_, height_);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, samplesDepth_.get());
  return gl.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

void TransmissionTarget::bind() const {
  const gl::Functions& gl = context_.gl();
  gl.BindFramebuffer(GL_FRAMEBUFFER, draw_.get());
  gl.Viewport(0, 0, width_, height_);
}

void TransmissionTarget::resolve() const {
  const gl::Functions& gl = context_.gl();
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, draw_.get());
  gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_.get());
  gl.BlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  gl.BindFramebuffer(GL_FRAMEBUFFER, draw_.get());
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindTexture(GL_TEXTURE_2D, color_.get());
  gl.GenerateMipmap(GL_TEXTURE_2D);
  context_.check("transmission target");
}

}  // namespace telar::pass
