#pragma once
#include "gl/context.h"
#include "gl/gl_object.h"
#include "pass/sample_buffer.h"

namespace telar::pass {

/// The picture that transmissive surfaces look through: linear Rec.709 radiance and coverage in half floats, four
/// samples a pixel, with mip levels for rough surfaces. As three.js 0.187 makes it, whatever the frame's own samples
/// are.
class TransmissionTarget {
 public:
  /// @throws Error{X_GL, X_GL_MEMORY}
  TransmissionTarget(const gl::Context& context, int width, int height);

  bool matches(int width, int height) const { return width == width_ && height == height_; }
  /// Makes it the target of the draws that follow; what is drawn shows in texture() after resolve().
  void bind() const { draw_.bind(context_.gl()); }
  /// The mean of the samples, and of it the mip levels. More may be drawn on top and resolved again.
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
