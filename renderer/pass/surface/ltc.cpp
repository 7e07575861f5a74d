#include "pass/surface/ltc.h"

#include "gl/clamped_sampling.h"

namespace telar::pass {
namespace {

constexpr GLsizei LTC_SIZE = 64;

#include "pass/surface/ltc_tables.inc"

static_assert(sizeof LTC_INVERSE == LTC_SIZE * LTC_SIZE * 4 * sizeof(float));
static_assert(sizeof LTC_ALBEDO == LTC_SIZE * LTC_SIZE * 2 * sizeof(float));

gl::Texture tableTexture(const gl::Functions& gl, GLenum internalFormat, GLenum format, const float* texels) {
  gl::Texture texture(gl);
  gl.BindTexture(GL_TEXTURE_2D, texture.get());
  gl.TexStorage2D(GL_TEXTURE_2D, 1, internalFormat, LTC_SIZE, LTC_SIZE);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, LTC_SIZE, LTC_SIZE, format, GL_FLOAT, texels);
  // Nearest where a pixel spans more than a texel: three.js's choice, which shows on small round things.
  gl::setClampedSampling(gl, GL_TEXTURE_2D, GL_NEAREST, GL_LINEAR);
  return texture;
}

}  // namespace

LtcTextures createLtcTextures(const gl::Context& context) {
  const bool full = context.capabilities().floatLinear;
  return {tableTexture(context.gl(), full ? GL_RGBA32F : GL_RGBA16F, GL_RGBA, LTC_INVERSE),
          tableTexture(context.gl(), full ? GL_RG32F : GL_RG16F, GL_RG, LTC_ALBEDO)};
}

}  // namespace telar::pass
