#pragma once
#include <utility>
#include <vector>

#include "gl/context.h"
#include "gl/gl_object.h"
#include "pass/target/sample_buffer.h"
#include "telar/image.h"

namespace telar::pass {

/// The framebuffer of one picture. kRgba8 holds sRGB-encoded values, and the multisample resolve averages those, as the
/// browser's drawing buffer does; kRgbaF32 holds linear radiance and resolves it.
class FrameTarget {
 public:
  /// @param samples  1 or 4, lowered to what the driver has for the format
  /// @throws Error{X_GL, X_GL_MEMORY}
  FrameTarget(const gl::Context& context, int width, int height, int samples, PixelType type);

  bool matches(int width, int height, int samples, PixelType type) const;
  void bind() const;
  /// Resolves and reads: row 0 is the top row, colours are premultiplied.
  Frame read();
  /// What it would read after it was cleared, without drawing.
  Frame filled(const glm::vec4& color);
  /// Gives the memory of a frame that was read back, for the next one.
  void reuse(Frame&& frame) { spare_ = std::move(frame.pixels); }
  /// Turns what was read into a picture: kRgba8 has straight alpha, kRgbaF32 premultiplied.
  /// @param opaque  a background is drawn whose alpha was not: alpha is what covers it, and colours stay as they are
  static void finish(Frame& frame, bool opaque);
  int samples() const { return samples_; }
  PixelType type() const { return type_; }

 private:
  bool tryFormat(GLenum format, int samples);
  std::size_t texelBytes() const { return type_ == PixelType::kRgba8 ? 4 : 16; }
  Frame unread();

  const gl::Context& context_;
  int width_, height_, samples_, samplesAsked_;
  PixelType type_;
  SampleBuffer draw_;
  std::vector<std::byte> spare_;
  gl::Framebuffer resolved_;  // none where a pixel has one sample
  gl::Renderbuffer resolvedColor_;
};

}  // namespace telar::pass
