#include "ibl/octahedral_map.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/octahedron.h"
#include "gl/clamped_sampling.h"
#include "gl/program.h"
#include "ibl/cube.h"
#include "shader/library.h"

namespace telar::ibl {
namespace {

constexpr unsigned SIZE_MIN = 512;  // texels: a small map is read between its texels too

gl::Program levelProgram(const gl::Context& context, bool equirect) {
  gl::Program program(context, "octahedral_level", shader::assemble("texture/level.vert", {}),
                      shader::assemble("environment/octahedral_level.frag", {{"EQUIRECT", equirect ? 1 : 0}}));
  program.use();
  program.set("source", 0);
  return program;
}

/// The program is in use, and what it reads is bound.
void drawLevel(const gl::Context& context, const gl::Program& program, gl::DrawCost& cost, const OctahedralMap& map,
               int level, const CancelToken& cancel) {
  const int size = map.size >> level;
  program.set("size", static_cast<float>(size));
  program.set("sourceSize", static_cast<float>(2 * size));
  renderLevel(context, cost, GL_TEXTURE_2D, map.texture, level, size, cancel);
}

}  // namespace

OctahedralMap createOctahedralMap(const gl::Functions& gl, int size, int levels) {
  OctahedralMap map{gl::Texture(gl), size};
  gl.BindTexture(GL_TEXTURE_2D, map.texture.get());
  gl.TexStorage2D(GL_TEXTURE_2D, levels, GL_RGBA16F, size, size);
  // A gutter is of its level alone: no read mixes two.
  gl::setClampedSampling(gl, GL_TEXTURE_2D, levels > 1 ? GL_LINEAR_MIPMAP_NEAREST : GL_LINEAR, GL_LINEAR);
  return map;
}

glm::vec3 octahedralDirection(int x, int y, int size) {
  const auto along = [size](int i) { return static_cast<float>(2 * i + 1 - size) / static_cast<float>(size - 2); };
  glm::vec2 place(along(x), along(y));
  if (std::abs(place.x) > 1) place = {std::copysign(2.0f, place.x) - place.x, -place.y};
  if (std::abs(place.y) > 1) place = {-place.x, std::copysign(2.0f, place.y) - place.y};
  return octahedronDirection(place);
}

OctahedralMap radianceMap(const gl::Context& context, const ImageF& map, const CancelToken& cancel) {
  const gl::Functions& gl = context.gl();
  const unsigned size = std::max(SIZE_MIN, std::bit_floor(map.width / 2));
  const int levels = std::countr_zero(size) - std::countr_zero(unsigned{OctahedralMap::LEAST_SIZE}) + 1;
  OctahedralMap made = createOctahedralMap(gl, static_cast<int>(size), levels);
  gl.ActiveTexture(GL_TEXTURE0);
  gl::DrawCost cost;
  {
    const gl::Texture equirect = uploadEquirect(gl, map);
    drawLevel(context, levelProgram(context, true), cost, made, 0, cancel);
  }
  const gl::Program program = levelProgram(context, false);
  gl.BindTexture(GL_TEXTURE_2D, made.texture.get());
  const auto readLevels = [&gl](int first, int last) {
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, first);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, last);
  };
  for (int level = 1; level < levels; ++level) {
    readLevels(level - 1, level - 1);
    drawLevel(context, program, cost, made, level, cancel);
  }
  readLevels(0, levels - 1);
  context.check("environment radiance");
  return made;
}

}  // namespace telar::ibl
