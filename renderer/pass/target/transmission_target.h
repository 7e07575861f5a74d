#pragma once
#include "gl/context.h"
#include "gl/gl_object.h"
#include "pass/target/sample_buffer.h"
#include "telar/shot.h"

namespace telar::pass {

/// What lies behind transmissive surfaces: linear Rec.709 radiance and coverage in half floats, with mip levels for
/// rough surfaces. The transmissive draws read it.
class TransmissionTarget {
 public:
  /// How large it is, in texels and samples a texel.
  struct Extent {
    int width = 0, height = 0, samples = 1;
    bool operator==(const Extent&) const = default;
  };

  /// That of a shot in a release of three.js: in 0.187 four samples whatever the frame has. As large as the quality's
  /// transmissionScale makes it.
  static Extent extentOf(const Shot& shot, const ThreeTerms& three);

  /// @throws Error{X_GL, X_GL_MEMORY}
  TransmissionTarget(const gl::Context& context, const Extent& extent);

  bool matches(const Extent& extent) const { return extent == extent_; }
  /// Makes it the target of the draws that follow; what is drawn shows in texture() after resolve().
  void bind() const { draw_.bind(context_.gl()); }
  /// Averages the samples and makes the mip levels. More may be drawn on top and resolved again.
  void resolve() const;
  GLuint texture() const { return color_.get(); }

 private:
  const gl::Context& context_;
  Extent extent_;
  gl::Texture color_;
  SampleBuffer draw_;
  gl::Framebuffer resolved_;
};

}  // namespace telar::pass
