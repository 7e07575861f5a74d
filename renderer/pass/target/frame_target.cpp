#include "pass/target/frame_target.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <utility>

#include "gl/incomplete.h"

namespace telar::pass {
namespace {

/// 8-bit premultiplied to straight, rounded to nearest: what a browser's toBlob does.
void unpremultiply(std::uint8_t* rgba, std::size_t texels) {
  for (std::size_t i = 0; i < texels; ++i, rgba += 4) {
    const unsigned a = rgba[3];
    if (a == 255) continue;
    for (int c = 0; c < 3; ++c) {
      rgba[c] = a == 0 ? std::uint8_t{0} : static_cast<std::uint8_t>(std::min(255u, (rgba[c] * 255u + a / 2) / a));
    }
  }
}

}  // namespace

FrameTarget::FrameTarget(const gl::Context& context, int width, int height, int samples, PixelType type)
    : context_(context), width_(width), height_(height), samples_(samples), samplesAsked_(samples), type_(type) {
  const int most = std::min(samples, context.capabilities().maxSamples);
  // A GPU may lack multisampled 32-bit floats: then half floats, then one sample.
  const bool complete = type == PixelType::kRgba8
                            ? tryFormat(GL_RGBA8, most)
                            : tryFormat(GL_RGBA32F, most) || tryFormat(GL_RGBA16F, most) || tryFormat(GL_RGBA16F, 1);
  context.check("framebuffer creation");
  if (!complete) fail();
}

void FrameTarget::fail() const {
  gl::failIncomplete(context_.gl(),
                     "a picture of " + std::to_string(width_) + " x " + std::to_string(height_) + " pixels");
}

bool FrameTarget::tryFormat(GLenum format, int samples) {
  format_ = format;
  samples_ = samples;
  return pixel_.allocate(context_.gl(), format, samples, 1, 1);
}

bool FrameTarget::make() {
  const gl::Functions& gl = context_.gl();
  if (!draw_.allocate(gl, format_, samples_, width_, height_)) return false;
  if (samples_ == 1) return true;
  resolved_ = gl::Framebuffer(gl);
  resolvedColor_ = gl::Renderbuffer(gl);
  gl.BindFramebuffer(GL_FRAMEBUFFER, resolved_.get());
  gl.BindRenderbuffer(GL_RENDERBUFFER, resolvedColor_.get());
  gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, 0, format_, width_, height_);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, resolvedColor_.get());
  return gl.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

bool FrameTarget::matches(int width, int height, int samples, PixelType type) const {
  return width == width_ && height == height_ && samples == samplesAsked_ && type == type_;
}

void FrameTarget::bind() {
  if (!made_) {
    const bool complete = make();
    context_.check("framebuffer creation");
    if (!complete) fail();
    made_ = true;
  }
  draw_.bind(context_.gl());
}

void FrameTarget::bindPixel() const { pixel_.bind(context_.gl()); }

Frame FrameTarget::unread() {
  const std::size_t texels = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  const std::size_t bytes = texels * texelBytes();
  std::vector<std::byte> pixels = spare_.size() == bytes ? std::exchange(spare_, {}) : std::vector<std::byte>(bytes);
  return {static_cast<std::uint32_t>(width_), static_cast<std::uint32_t>(height_), type_, std::move(pixels)};
}

Frame FrameTarget::read() {
  const gl::Functions& gl = context_.gl();
  if (samples_ > 1) {
    draw_.resolveInto(gl, resolved_.get());
    gl.BindFramebuffer(GL_FRAMEBUFFER, resolved_.get());
  }
  Frame frame = unread();
  gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
  gl.ReadPixels(0, 0, width_, height_, GL_RGBA, type_ == PixelType::kRgba8 ? GL_UNSIGNED_BYTE : GL_FLOAT,
                frame.pixels.data());
  context_.check("readback");
  const std::size_t rows = frame.height, row = frame.pixels.size() / std::max<std::size_t>(rows, 1);
  for (std::size_t y = 0; y < rows / 2; ++y) {
    std::swap_ranges(frame.pixels.begin() + static_cast<std::ptrdiff_t>(y * row),
                     frame.pixels.begin() + static_cast<std::ptrdiff_t>((y + 1) * row),
                     frame.pixels.begin() + static_cast<std::ptrdiff_t>((rows - 1 - y) * row));
  }
  return frame;
}

Frame FrameTarget::filled(const glm::vec4& color) {
  Frame frame = unread();
  std::uint8_t bytes[4];
  for (int i = 0; i < 4; ++i) bytes[i] = static_cast<std::uint8_t>(std::lround(255 * std::clamp(color[i], 0.0f, 1.0f)));
  const std::size_t texels = frame.pixels.size() / texelBytes();
  if (type_ == PixelType::kRgba8) {
    for (std::size_t i = 0; i < texels; ++i) std::memcpy(&frame.pixels[4 * i], bytes, sizeof bytes);
  } else {
    std::fill_n(reinterpret_cast<glm::vec4*>(frame.pixels.data()), texels, color);
  }
  return frame;
}

void FrameTarget::finish(Frame& frame, bool opaque) {
  if (frame.type == PixelType::kRgba8 && !opaque)
    unpremultiply(reinterpret_cast<std::uint8_t*>(frame.pixels.data()), std::size_t{frame.width} * frame.height);
}

}  // namespace telar::pass
