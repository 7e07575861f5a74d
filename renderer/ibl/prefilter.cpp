#include "ibl/prefilter.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "shader/library.h"

namespace telar::ibl {
namespace {

constexpr int FACE_SIZE_MIN = 256;     // px; smaller maps are enlarged so that every chain has enough levels
constexpr int LAST_LEVEL_LOG2 = 3;     // the roughest level is 8 px
constexpr int INTEGRATION_SIZE = 16;   // px of the source level that the rough levels sum
constexpr int INTEGRATION_LEVELS = 3;  // how many rough levels

double roughnessOf(int level, int maxLod) { return 1.0 - std::sqrt(1.0 - static_cast<double>(level) / maxLod); }

/// Level of the source whose texel has a sample's solid angle, less what depends on the sample. 0.5 is three r187's: it
/// hides the grain of so few samples.
double lodBias(int faceSize, int samples, double roughness) {
  return roughness > 0 ? std::log2(faceSize) + 0.5 * std::log2(6.0 / (samples * std::pow(roughness, 4))) + 0.5 : 0.0;
}

/// An equirectangular map as a cube with all its levels, each texel the mean of those of the level before.
/// @return face size max(256, largest power of two <= width / 4), or `least` where that is larger
CubeMap radianceCube(const gl::Context& context, const ImageF& map, const CancelToken& cancel, int least) {
  const gl::Functions& gl = context.gl();
  const int faceSize = std::max({FACE_SIZE_MIN, least, static_cast<int>(std::bit_floor(map.width / 4))});
  const int levels = std::countr_zero(static_cast<unsigned>(faceSize)) + 1;
  CubeMap cube = equirectToCube(context, uploadEquirect(gl, map), faceSize, levels, true, cancel);
  gl.BindTexture(GL_TEXTURE_CUBE_MAP, cube.texture.get());
  gl.GenerateMipmap(GL_TEXTURE_CUBE_MAP);
  context.check("environment cube");
  return cube;
}

}  // namespace

int maxLodOf(const CubeMap& cube) { return cube.levels - 1; }

CubeMap prefilterEquirect(const gl::Context& context, const ImageF& map, const CancelToken& cancel,
                          const PrefilterSettings& settings) {
  const gl::Functions& gl = context.gl();
  const CubeMap source = radianceCube(context, map, cancel, settings.faceSize);
  const int faceSize = settings.faceSize > 0 ? settings.faceSize : source.faceSize;
  const int maxLod = std::countr_zero(static_cast<unsigned>(faceSize)) - LAST_LEVEL_LOG2;

  CubeMap target = createCube(gl, faceSize, maxLod + 1);
  const std::string vertex = shader::assemble("environment/cube_face.vert", {});
  const gl::Program sample(
      context, "prefilter_sample", vertex,
      shader::assemble("environment/prefilter_sample.frag",
                       {{"SAMPLE_BITS", std::countr_zero(static_cast<unsigned>(settings.samples))}}));
  const gl::Program integrate(context, "prefilter_integrate", vertex,
                              shader::assemble("environment/prefilter_integrate.frag", {}));
  gl::DrawCost sampleCost(settings.samples / 32.0), integrateCost(INTEGRATION_SIZE * INTEGRATION_SIZE * 6 / 32.0);
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindTexture(GL_TEXTURE_CUBE_MAP, source.texture.get());
  for (int level = 0; level <= maxLod; ++level) {
    const double roughness = roughnessOf(level, maxLod);
    const bool rough = level > maxLod - INTEGRATION_LEVELS;
    const gl::Program& program = rough ? integrate : sample;
    program.use();
    program.set("sourceMap", 0);
    program.set("perceptualRoughness", static_cast<float>(roughness));
    program.set("lodBias", static_cast<float>(lodBias(source.faceSize, settings.samples, roughness)));
    program.set("mirrorLod", static_cast<float>(std::log2(source.faceSize / faceSize)));
    program.set("sourceLod", static_cast<float>(std::log2(source.faceSize / INTEGRATION_SIZE)));
    program.set("sourceSize", INTEGRATION_SIZE);
    renderFaces(context, program, rough ? integrateCost : sampleCost, target, level, cancel);
  }
  context.check("environment prefilter");
  return target;
}

}  // namespace telar::ibl
