#include "pass/texture/mip_levels.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstring>
#include <utility>

#include "gl/gl_object.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace telar::pass {
namespace {

/// Below, asking a GL costs more than it saves: it compiles its generator, which takes longer than many a small image.
constexpr std::uint64_t TEXELS_WORTH_A_PROBE = 1 << 16;
/// A level of this size is kept for the next image: fresh memory costs as much as the blending. Of 2048 x 2048 texels
/// it is 4 MiB.
constexpr std::size_t KEPT_BYTES = 4 << 20;
constexpr std::uint32_t PROBE_SIDE = 128;
constexpr int PROBE_LEVELS = std::bit_width(PROBE_SIDE);

/// A texel's four bytes at once. src: Dietz 2018, "The Aggregate Magic Algorithms", SIMD within a register
std::uint32_t meanRoundedUp(std::uint32_t a, std::uint32_t b) { return (a | b) - ((a ^ b) >> 1 & 0x7f7f7f7fu); }

#if defined(__x86_64__)
/// Four texels of the next level, from eight of the upper row and eight of the lower.
void halveEight(const std::uint8_t* upper, const std::uint8_t* lower, std::uint8_t* out) {
  constexpr int LEFT = 0x88, RIGHT = 0xdd;  // of each pair
  const auto across = [](const std::uint8_t* row) {
    const __m128 first = _mm_loadu_ps(reinterpret_cast<const float*>(row));
    const __m128 second = _mm_loadu_ps(reinterpret_cast<const float*>(row + 16));
    return _mm_avg_epu8(_mm_castps_si128(_mm_shuffle_ps(first, second, LEFT)),
                        _mm_castps_si128(_mm_shuffle_ps(first, second, RIGHT)));
  };
  _mm_storeu_si128(reinterpret_cast<__m128i*>(out), _mm_avg_epu8(across(upper), across(lower)));
}
#endif

std::uint32_t texelAt(const std::uint8_t* texels) {
  std::uint32_t texel;
  std::memcpy(&texel, texels, sizeof texel);
  return texel;
}

/// Neighbours that differ by little and by much, around every value.
MipLevel probeLevel() {
  MipLevel level{PROBE_SIDE, PROBE_SIDE, ZeroedBytes(std::size_t{4} * PROBE_SIDE * PROBE_SIDE)};
  std::uint32_t state = 1;
  for (std::size_t i = 0; i < level.texels.size(); ++i) {
    state = state * 1664525u + 1013904223u;  // src: Press et al. 1992, "Numerical Recipes in C", 7.1
    const std::size_t base = i / 4 * 7, spread = 1 + i / 64 % 96;
    level.texels[i] = static_cast<std::uint8_t>(base + (state >> 16) % spread);
  }
  return level;
}

void put(const gl::Functions& gl, int level, const MipLevel& made) {
  gl.TexSubImage2D(GL_TEXTURE_2D, level, 0, 0, static_cast<GLsizei>(made.width), static_cast<GLsizei>(made.height),
                   GL_RGBA, GL_UNSIGNED_BYTE, made.texels.data());
}

}  // namespace

bool halves(std::uint32_t width, std::uint32_t height) {
  return (width > 1 || height > 1) && std::has_single_bit(width) && std::has_single_bit(height);
}

void halveLinear(const std::uint8_t* texels, std::uint32_t width, std::uint32_t height, MipLevel& half) {
  half.resize(std::max(1u, width / 2), std::max(1u, height / 2));
  const std::size_t row = std::size_t{4} * width, right = width > 1 ? 4 : 0, below = height > 1 ? row : 0;
  std::uint8_t* out = half.texels.data();
  for (std::uint32_t y = 0; y < half.height; ++y) {
    const std::uint8_t* from = texels + 2 * y * below;
    std::uint32_t x = 0;
#if defined(__x86_64__)
    for (; x + 4 <= half.width && width > 4; x += 4, from += 32, out += 16) halveEight(from, from + below, out);
#endif
    for (; x < half.width; ++x, from += 2 * right, out += 4) {
      const std::uint32_t top = meanRoundedUp(texelAt(from), texelAt(from + right));
      const std::uint32_t bottom = meanRoundedUp(texelAt(from + below), texelAt(from + below + right));
      const std::uint32_t mean = meanRoundedUp(top, bottom);
      std::memcpy(out, &mean, sizeof mean);
    }
  }
}

MipMaker::MipMaker(const gl::Context& context) : context_(context) {
  // The Mesa and the kind of CPU that mip_levels_test.cpp holds against this code are not asked.
  if (canHalveSrgb() && context.renderer().starts_with("llvmpipe") &&
      context.version().find("Mesa 22.3.") != std::string::npos) {
    linearAgrees_ = true;
    srgbAgrees_ = true;
  }
}

bool MipMaker::agrees(bool srgb, Halve halve) const {
  const gl::Functions& gl = context_.gl();
  GLint boundTexture = 0, boundReads = 0;
  gl.GetIntegerv(GL_TEXTURE_BINDING_2D, &boundTexture);
  gl.GetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &boundReads);
  const gl::Texture texture(gl);
  const gl::Framebuffer framebuffer(gl);
  MipLevel level = probeLevel();
  gl.BindTexture(GL_TEXTURE_2D, texture.get());
  gl.TexStorage2D(GL_TEXTURE_2D, PROBE_LEVELS, srgb ? GL_SRGB8_ALPHA8 : GL_RGBA8, PROBE_SIDE, PROBE_SIDE);
  put(gl, 0, level);
  gl.GenerateMipmap(GL_TEXTURE_2D);
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer.get());
  bool same = true;
  for (int i = 1; same && i < PROBE_LEVELS; ++i) {
    MipLevel half;
    halve(level.texels.data(), level.width, level.height, half);
    level = std::move(half);
    gl.FramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.get(), i);
    ZeroedBytes made(level.texels.size());
    gl.ReadPixels(0, 0, static_cast<GLsizei>(level.width), static_cast<GLsizei>(level.height), GL_RGBA,
                  GL_UNSIGNED_BYTE, made.data());
    same = made == level.texels;
  }
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(boundReads));
  gl.BindTexture(GL_TEXTURE_2D, static_cast<GLuint>(boundTexture));
  return same;
}

bool MipMaker::byCpu(std::uint32_t width, std::uint32_t height, bool srgb) {
  if (!halves(width, height)) return false;
  std::optional<bool>& known = srgb ? srgbAgrees_ : linearAgrees_;
  if (!known) {
    if (std::uint64_t{width} * height < TEXELS_WORTH_A_PROBE) return false;
    known = srgb ? canHalveSrgb() && agrees(true, halveSrgb) : agrees(false, halveLinear);
  }
  return *known;
}

void MipMaker::make(const std::uint8_t* texels, std::uint32_t width, std::uint32_t height, bool srgb, int first) {
  const gl::Functions& gl = context_.gl();
  if (!byCpu(width, height, srgb)) return gl.GenerateMipmap(GL_TEXTURE_2D);
  const Halve halve = srgb ? halveSrgb : halveLinear;
  halve(texels, width, height, made_);
  if (first <= 1) put(gl, 1 - first, made_);
  for (int level = 2; halves(made_.width, made_.height); ++level) {
    halve(made_.texels.data(), made_.width, made_.height, next_);
    std::swap(made_, next_);
    if (level >= first) put(gl, level - first, made_);
  }
  if (std::max(made_.texels.capacity(), next_.texels.capacity()) > KEPT_BYTES) made_ = next_ = {};
}

}  // namespace telar::pass
