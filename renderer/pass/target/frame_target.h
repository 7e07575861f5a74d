#pragma once
#include <utility>
#include <vector>

#include "gl/context.h"
#include "gl/gl_object.h"
#include "pass/target/sample_buffer.h"
#include "telar/image.h"

namespace telar::pass {

/// The framebuffer of one picture. kRgba8 holds sRGB-encoded values, and the multisample resolve averages those, as the
/// browser's drawing buffer does; kRgbaF32 holds linear radiance and resolves it. Its storage is made when it is first
/// bound: 32 bytes a pixel with four samples, which a picture of dense rows has no use for.
class FrameTarget {
 public:
  /// @param samples  1 or 4, lowered to what the driver has for the format
  /// @throws Error{X_GL, X_GL_MEMORY}
  FrameTarget(const gl::Context& context, int width, int height, int samples, PixelType type);

  bool matches(int width, int height, int samples, PixelType type) const;
  /// Makes it the target of the draws that follow. @throws Error{X_GL, X_GL_MEMORY}
  void bind();
  /// One pixel with the same samples, for draws that shade nothing and for the places of the samples.
  void bindPixel() const;
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
  bool make();
  [[noreturn]] void fail() const;
  std::size_t texelBytes() const { return type_ == PixelType::kRgba8 ? 4 : 16; }
  Frame unread();

  const gl::Context& context_;
  int width_, height_, samples_, samplesAsked_;
  PixelType type_;
  GLenum format_ = GL_NONE;
  SampleBuffer pixel_, draw_;
  bool made_ = false;         ///< what follows, and the storage of draw_
  gl::Framebuffer resolved_;  ///< none where a pixel has one sample
  gl::Renderbuffer resolvedColor_;
  std::vector<std::byte> spare_;
};

}  // namespace telar::pass
