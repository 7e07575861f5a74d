#pragma once
#include <span>

#include "gl/program.h"

namespace telar::pass {

/// Keeps draws off the pixels that are settled: gives them the nearest depth before anything else is drawn.
class SettledMask {
 public:
  explicit SettledMask(const gl::Context& context) : context_(context) {}

  /// @param settled  255 or 0 a pixel, row 0 on top
  void set(std::span<const std::uint8_t> settled, int width, int height);
  /// Into the depth of the bound target, which has just been cleared.
  void draw();

 private:
  const gl::Context& context_;
  gl::Program program_;
  gl::VertexArray noVertices_;
  gl::Texture texture_;
};

}  // namespace telar::pass
