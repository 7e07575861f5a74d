#pragma once
#include "gl/context.h"
#include "gl/gl_object.h"
#include "pass/sample_buffer.h"

namespace telar::pass {

/// What lies behind transmissive surfaces: linear Rec.709 radiance and coverage in half floats, with mip levels for
/// rough surfaces. It has four samples a pixel whatever the frame has, as in three.js 0.187. The transmissive draws
/// read it.
class TransmissionTarget {
 public:
  /// @throws Error{X_GL, X_GL_MEMORY}
  TransmissionTarget(const gl::Context& context, int width, int height);

  bool matches(int width, int height) const { return width == width_ && height == height_; }
  /// Makes it the target of the draws that follow; what is drawn shows in texture() after resolve().
  void bind() const { draw_.bind(context_.gl()); }
  /// Averages the samples and makes the mip levels. More may be drawn on top and resolved again.
  void resolve() const;
  GLuint texture() const { return color_.get(); }

 private:
  const gl::Context& context_;
  int width_, height_;
  gl::Texture color_;
  SampleBuffer draw_;
  gl::Framebuffer resolved_;
};

}  // namespace telar::pass
