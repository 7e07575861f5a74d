#pragma once
#include "gl/context.h"
#include "gl/gl_object.h"

namespace telar::pass {

/// Colour and depth with one or several samples a pixel. Draws go into it; then it is resolved.
class SampleBuffer {
 public:
  /// Replaces the storage. @return false where the driver does not render to it
  bool allocate(const gl::Functions& gl, GLenum colorFormat, int samples, int width, int height);

  /// Makes it the target of the draws that follow.
  void bind(const gl::Functions& gl) const;
  /// The mean of the samples into another framebuffer of the same size, which stays bound for drawing.
  void resolveInto(const gl::Functions& gl, GLuint framebuffer) const;

 private:
  int width_ = 0, height_ = 0;
  gl::Framebuffer framebuffer_;
  gl::Renderbuffer color_, depth_;
};

}  // namespace telar::pass
