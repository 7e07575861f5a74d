#include "pass/texture/mip_levels.h"

#include <gtest/gtest.h>

#include <bit>

#include "gl/gl_object.h"

namespace telar {
namespace {

using pass::MipLevel;

class MipLevels : public testing::Test {
 protected:
  MipLevels() : context(gl::Context::create(Backend::kAuto)) {}

  /// All levels below level 0, one after the other: made by the maker, or by the GL alone.
  std::vector<std::uint8_t> levels(const MipLevel& image, bool srgb, pass::MipMaker* maker) const {
    const gl::Functions& gl = context->gl();
    const gl::Texture texture(gl);
    gl.BindTexture(GL_TEXTURE_2D, texture.get());
    const auto width = static_cast<GLsizei>(image.width), height = static_cast<GLsizei>(image.height);
    const int count = std::bit_width(std::max(image.width, image.height));
    gl.TexStorage2D(GL_TEXTURE_2D, count, srgb ? GL_SRGB8_ALPHA8 : GL_RGBA8, width, height);
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, image.texels.data());
    if (maker) {
      maker->make(image.texels.data(), image.width, image.height, srgb);
    } else {
      gl.GenerateMipmap(GL_TEXTURE_2D);
    }
    const gl::Framebuffer framebuffer(gl);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.get());
    std::vector<std::uint8_t> all;
    for (int level = 1; level < count; ++level) {
      const int w = std::max(1, width >> level), h = std::max(1, height >> level);
      gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.get(), level);
      const std::size_t before = all.size();
      all.resize(before + std::size_t{4} * static_cast<std::size_t>(w) * static_cast<std::size_t>(h));
      gl.ReadPixels(0, 0, w, h, GL_RGBA, GL_UNSIGNED_BYTE, &all[before]);
    }
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
    context->check("levels");
    return all;
  }

  std::unique_ptr<gl::Context> context;
};

/// Noise of every size about every value.
MipLevel noiseLevel(std::uint32_t width, std::uint32_t height) {
  MipLevel image{width, height, {}};
  image.texels.resize(std::size_t{4} * width * height);
  std::uint32_t state = width * 31 + height;
  for (std::size_t i = 0; i < image.texels.size(); ++i) {
    state = state * 1664525u + 1013904223u;
    const std::size_t spread = 1 + i / 256 % 255;
    image.texels[i] = static_cast<std::uint8_t>(i / 4 * 3 + (state >> 16) % spread);
  }
  return image;
}

/// Means that are rounded down once, and not up twice.
void halveRoundingDown(const std::uint8_t* texels, std::uint32_t width, std::uint32_t height, MipLevel& half) {
  half.resize(std::max(1u, width / 2), std::max(1u, height / 2));
  const std::size_t row = std::size_t{4} * width, right = width > 1 ? 4 : 0, below = height > 1 ? row : 0;
  for (std::size_t i = 0; i < half.texels.size(); ++i) {
    const std::size_t x = i / 4 % half.width, y = i / 4 / half.width;
    const std::uint8_t* from = texels + 2 * y * below + 2 * x * right + i % 4;
    half.texels[i] = static_cast<std::uint8_t>((from[0] + from[right] + from[below] + from[below + right]) / 4);
  }
}

// Byte for byte: a picture must not tell who made its levels.
TEST_F(MipLevels, ThoseOfTheMakerAreThoseOfTheGl) {
  pass::MipMaker maker(*context);
  for (const bool srgb : {false, true}) {
    for (const auto& [width, height] : {std::pair{1024u, 1024u},
                                        {2048u, 64u},
                                        {512u, 1024u},
                                        {300u, 520u},
                                        {255u, 300u},
                                        {8192u, 2u},
                                        {1u, 2048u},
                                        {4096u, 1u},
                                        {4u, 4u}}) {
      const MipLevel image = noiseLevel(width, height);
      EXPECT_TRUE(levels(image, srgb, &maker) == levels(image, srgb, nullptr))
          << width << " x " << height << " srgb " << srgb << " " << context->version();
    }
  }
}

TEST_F(MipLevels, TheProbeTellsAnotherRounding) {
  const pass::MipMaker maker(*context);
  EXPECT_FALSE(maker.agrees(false, halveRoundingDown));
  EXPECT_FALSE(maker.agrees(true, pass::halveLinear));
  if (!context->renderer().starts_with("llvmpipe")) GTEST_SKIP() << "another GL may round as it likes";
  EXPECT_TRUE(maker.agrees(false, pass::halveLinear)) << context->version();
  EXPECT_EQ(pass::canHalveSrgb() && maker.agrees(true, pass::halveSrgb), pass::canHalveSrgb()) << context->version();
}

TEST_F(MipLevels, SidesThatHalve) {
  EXPECT_TRUE(pass::halves(2, 1) && pass::halves(1, 2) && pass::halves(8, 4));
  EXPECT_FALSE(pass::halves(1, 1) || pass::halves(3, 2) || pass::halves(2, 6));
}

}  // namespace
}  // namespace telar
