#include "ibl/irradiance.h"

#include <algorithm>
#include <glm/gtc/packing.hpp>

#include "ibl/equirect_grid.h"

namespace telar::ibl {
namespace {

constexpr int FACE_SIZE = 32;
constexpr std::uint32_t ROWS_OF_BLOCKS = 32, COLUMNS_OF_BLOCKS = 64;

/// Light of a part of the sphere, small enough for one direction.
struct Block {
  glm::vec3 direction;
  glm::vec3 flux;  ///< radiance times solid angle
};

/// Blocks of neighbouring texels of a map.
std::vector<Block> blocksOf(const ImageF& map) {
  const std::uint32_t rows = std::min(ROWS_OF_BLOCKS, map.height), columns = std::min(COLUMNS_OF_BLOCKS, map.width);
  const EquirectGrid grid{map.width, map.height};
  struct Sum {
    glm::dvec3 flux{0}, direction{0};
  };
  std::vector<Sum> sums(static_cast<std::size_t>(rows) * columns);
  for (std::uint32_t y = 0; y < map.height; ++y) {
    const double angle = grid.solidAngle(y);
    const std::size_t row = static_cast<std::size_t>(y) * rows / map.height * columns;
    for (std::uint32_t x = 0; x < map.width; ++x) {
      const float* rgb = &map.pixels[(static_cast<std::size_t>(y) * map.width + x) * 4];
      Sum& sum = sums[row + static_cast<std::size_t>(x) * columns / map.width];
      const glm::dvec3 flux = glm::dvec3(rgb[0], rgb[1], rgb[2]) * angle;
      sum.flux += flux;
      // The direction is the mean by flux: a lamp at the edge of a block stays at the edge.
      sum.direction += grid.direction(x, y) * (flux.x + flux.y + flux.z);
    }
  }
  std::vector<Block> blocks;
  for (const Sum& sum : sums) {
    if (glm::dot(sum.direction, sum.direction) > 0)
      blocks.push_back({glm::vec3(glm::normalize(sum.direction)), glm::vec3(sum.flux)});
  }
  return blocks;
}

}  // namespace

CubeMap irradianceCube(const gl::Context& context, const ImageF& map, const CancelToken& cancel) {
  const gl::Functions& gl = context.gl();
  const std::vector<Block> blocks = blocksOf(map);
  CubeMap cube = createCube(gl, FACE_SIZE, 1);
  gl.BindTexture(GL_TEXTURE_CUBE_MAP, cube.texture.get());
  std::vector<std::uint64_t> texels(FACE_SIZE * FACE_SIZE);
  for (int face = 0; face < 6; ++face) {
    cancel.check();
    for (int y = 0; y < FACE_SIZE; ++y) {
      for (int x = 0; x < FACE_SIZE; ++x) {
        const auto place = [](int i) { return (static_cast<float>(i) + 0.5f) * (2.0f / FACE_SIZE) - 1; };
        const glm::vec3 n = glm::normalize(faceDirection(face, place(x), place(y)));
        glm::vec3 irradiance(0);
        for (const Block& block : blocks) irradiance += block.flux * std::max(glm::dot(block.direction, n), 0.0f);
        texels[static_cast<std::size_t>(y * FACE_SIZE + x)] =
            glm::packHalf4x16(glm::vec4(irradiance * glm::one_over_pi<float>(), 1));
      }
    }
    gl.TexSubImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + static_cast<GLenum>(face), 0, 0, 0, FACE_SIZE, FACE_SIZE, GL_RGBA,
                     GL_HALF_FLOAT, texels.data());
  }
  context.check("environment irradiance");
  return cube;
}

}  // namespace telar::ibl
