#pragma once
#include <cmath>
#include <vector>

#include "ibl/cube.h"

/// Maps made in code, and texels of cubes.
namespace telar::ibl::test {

/// Radiance 1 + 0.8 y.
inline ImageF gradient(std::uint32_t width) {
  ImageF map{width, width / 2, std::vector<float>(static_cast<std::size_t>(width) * width / 2 * 4, 1.0f)};
  for (std::uint32_t y = 0; y < map.height; ++y) {
    const double latitude = (0.5 - (y + 0.5) / map.height) * 3.14159265358979;
    for (std::uint32_t x = 0; x < width; ++x) {
      for (int c = 0; c < 3; ++c)
        map.pixels[(static_cast<std::size_t>(y) * width + x) * 4 + static_cast<std::size_t>(c)] =
            static_cast<float>(1 + 0.8 * std::sin(latitude));
    }
  }
  return map;
}

/// RGBA halfs of a level of a square image. @param image  GL_TEXTURE_2D or a face of a cube
inline std::vector<std::uint16_t> halfs(const gl::Context& context, GLenum image, const gl::Texture& texture, int lod,
                                        int size) {
  const gl::Functions& gl = context.gl();
  const gl::Framebuffer framebuffer(gl);
  std::vector<std::uint16_t> rgba(static_cast<std::size_t>(size) * static_cast<std::size_t>(size) * 4);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.get());
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, image, texture.get(), lod);
  gl.ReadPixels(0, 0, size, size, GL_RGBA, GL_HALF_FLOAT, rgba.data());
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  return rgba;
}

/// The same of a face.
inline std::vector<std::uint16_t> level(const gl::Context& context, const CubeMap& cube, int lod, GLenum face) {
  return halfs(context, face, cube.texture, lod, cube.faceSize >> lod);
}

inline float half(std::uint16_t bits) {
  return std::ldexp(static_cast<float>((bits & 0x3ff) | 0x400), (bits >> 10) - 25);
}

}  // namespace telar::ibl::test
