#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "gl/context.h"
#include "pass/texture/texture_bake.h"
#include "renderer/cloth_images.h"

namespace telar::test {

inline constexpr double STEEPEST = 8;

inline glm::dvec4 storedTexel(const std::uint8_t* p) { return glm::dvec4(p[0], p[1], p[2], p[3]) / 255.0; }

inline glm::dvec2 slopeOf(const glm::dvec4& texel) {
  const glm::dvec3 n = glm::dvec3(texel) * 2.0 - 1.0;
  return glm::dvec2(n) / std::max(n.z, glm::length(n) / STEEPEST);
}

inline glm::dvec4 texelAt(const Image8& image, int x, int y) {
  const int w = int(image.width), h = int(image.height);
  return storedTexel(&image.pixels[4 * (std::size_t((y + h) % h) * image.width + std::size_t((x + w) % w))]);
}

/// f at the point of a texel that lies towards a neighbour. f is given a function: what a sampler shows of an image there,
/// blended of four texels.   dx, dy  -1 or 1
template <typename F>
glm::dvec4 atPoint(int x, int y, int dx, int dy, const F& f) {
  return f([&](const Image8& image) {
    const glm::dvec4 row = 0.75 * texelAt(image, x, y) + 0.25 * texelAt(image, x + dx, y);
    const glm::dvec4 next = 0.75 * texelAt(image, x, y + dy) + 0.25 * texelAt(image, x + dx, y + dy);
    return 0.75 * row + 0.25 * next;
  });
}

/// Mean of f over the four points of a texel.
template <typename F>
glm::dvec4 meanOverPoints(int x, int y, const F& f) {
  glm::dvec4 sum(0);
  for (const int dy : {-1, 1}) {
    for (const int dx : {-1, 1}) sum += atPoint(x, y, dx, dy, f);
  }
  return sum / 4.0;
}

/// f at the one point of a texel that is looked at where sides halve: another one in each of four texels.
template <typename F>
glm::dvec4 atOwnPoint(int x, int y, const F& f) {
  return atPoint(x, y, x % 2 == y % 2 ? -1 : 1, x % 2 == 0 ? -1 : 1, f);
}

/// Mean of f over the part of the image that a texel of a mip level covers, by area.
template <typename F>
glm::dvec4 meanOver(const Image8& image, glm::ivec2 at, glm::ivec2 levelSize, const F& f) {
  const glm::dvec2 ratio(double(image.width) / levelSize.x, double(image.height) / levelSize.y);
  glm::dvec4 sum(0);
  double area = 0;
  for (int y = 0; y < int(image.height); ++y) {
    const double h = std::min(y + 1.0, (at.y + 1) * ratio.y) - std::max(double(y), at.y * ratio.y);
    for (int x = 0; h > 0 && x < int(image.width); ++x) {
      const double w = std::min(x + 1.0, (at.x + 1) * ratio.x) - std::max(double(x), at.x * ratio.x);
      if (w <= 0) continue;
      sum += w * h * f(x, y);
      area += w * h;
    }
  }
  return sum / area;
}

/// Draws maps and reads them back.
class TextureBake : public testing::Test {
 protected:
  const gl::Functions& gl() const { return context_->gl(); }
  gl::Texture upload(const Image8& image, GLenum format) const {
    gl::Texture texture(gl());
    gl().BindTexture(GL_TEXTURE_2D, texture.get());
    gl().TexStorage2D(GL_TEXTURE_2D, 1, format, GLsizei(image.width), GLsizei(image.height));
    gl().TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, GLsizei(image.width), GLsizei(image.height), GL_RGBA, GL_UNSIGNED_BYTE,
                       image.pixels.data());
    return texture;
  }
  template <typename Value>
  std::vector<Value> read(const gl::Texture& texture, int level, glm::ivec2 size) const {
    const gl::Framebuffer framebuffer(gl());
    gl().BindFramebuffer(GL_FRAMEBUFFER, framebuffer.get());
    gl().FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.get(), level);
    std::vector<Value> pixels(std::size_t(size.x * size.y) * 4);
    gl().PixelStorei(GL_PACK_ALIGNMENT, 4);
    gl().ReadPixels(0, 0, size.x, size.y, GL_RGBA, sizeof(Value) == 1 ? GL_UNSIGNED_BYTE : GL_FLOAT, pixels.data());
    context_->check("read");
    return pixels;
  }
  static glm::ivec2 sizeAt(const Image8& image, int level) {
    return glm::max(glm::ivec2(image.width, image.height) >> level, 1);
  }

  std::unique_ptr<gl::Context> context_ = gl::Context::create(Backend::kAuto);
  pass::TextureBaker baker_{*context_};
};

}  // namespace telar::test
