#include "ibl/dfg.h"

#include "brdf/dfg_lookup.h"
#include "gl/clamped_sampling.h"

namespace telar::ibl {
gl::Texture createDfgTexture(const gl::Functions& gl, const ThreeTerms& three) {
  const brdf::DfgTable table = brdf::dfgTableOf(three);
  gl::Texture texture(gl);
  gl.BindTexture(GL_TEXTURE_2D, texture.get());
  gl.TexStorage2D(GL_TEXTURE_2D, 1, GL_RG16F, table.size, table.size);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, table.size, table.size, GL_RG, GL_HALF_FLOAT, table.halfs);
  gl::setClampedSampling(gl, GL_TEXTURE_2D, GL_LINEAR, GL_LINEAR);
  return texture;
}

}  // namespace telar::ibl
