#include "ibl/irradiance.h"

#include <algorithm>
#include <glm/gtc/packing.hpp>

#include "ibl/equirect_grid.h"

namespace telar::ibl {
namespace {

constexpr int SIZE = 64;
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

OctahedralMap irradianceMap(const gl::Context& context, const ImageF& map, const CancelToken& cancel) {
  const gl::Functions& gl = context.gl();
  const std::vector<Block> blocks = blocksOf(map);
  OctahedralMap made = createOctahedralMap(gl, SIZE, 1);
  std::vector<std::uint64_t> texels;
  texels.reserve(std::size_t{SIZE} * SIZE);
  for (int y = 0; y < SIZE; ++y) {
    cancel.check();
    for (int x = 0; x < SIZE; ++x) {
      const glm::vec3 n = octahedralDirection(x, y, SIZE);
      glm::vec3 irradiance(0);
      for (const Block& block : blocks) irradiance += block.flux * std::max(glm::dot(block.direction, n), 0.0f);
      texels.push_back(glm::packHalf4x16(glm::vec4(irradiance * glm::one_over_pi<float>(), 1)));
    }
  }
  gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, SIZE, SIZE, GL_RGBA, GL_HALF_FLOAT, texels.data());
  context.check("environment irradiance");
  return made;
}

}  // namespace telar::ibl
