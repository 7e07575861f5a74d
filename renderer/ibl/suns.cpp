#include "ibl/suns.h"

#include <cmath>
#include <glm/gtc/type_ptr.hpp>

#include "ibl/equirect_grid.h"
#include "telar/codec.h"
#include "telar/luminance.h"

namespace telar::ibl {
namespace {

/// Texels within this angle of a sun's middle belong to it: about the width of the smoothest cloth's specular lobe.
constexpr double FIRST_RADIUS = glm::radians(4.0);

struct Bright {
  glm::dvec3 direction, irradiance;
};

/// The part of each texel above the largest half float, row by row.
std::vector<Bright> excessOf(const ImageF& map, double& share) {
  const EquirectGrid grid{map.width, map.height};
  std::vector<Bright> list;
  double whole = 0, above = 0;
  for (std::uint32_t y = 0; y < map.height; ++y) {
    const double angle = grid.solidAngle(y);
    for (std::uint32_t x = 0; x < map.width; ++x) {
      const glm::dvec3 radiance(glm::make_vec3(&map.pixels[(static_cast<std::size_t>(y) * map.width + x) * 4]));
      whole += luminance(radiance) * angle;
      const glm::dvec3 excess = glm::max(radiance - double(HALF_MAX), 0.0) * angle;
      if (excess == glm::dvec3(0)) continue;
      above += luminance(excess);
      list.push_back({grid.direction(x, y), excess});
    }
  }
  share = above > 0 ? above / whole : 0;
  return list;
}

/// Gives each texel to the first sun within the radius. Empty where that makes too many suns.
std::vector<Suns::Sun> gathered(const std::vector<Bright>& texels, double radius) {
  const double least = std::cos(radius);
  std::vector<Suns::Sun> suns;
  std::vector<glm::dvec3> sums;  // of directions, by luminance
  for (const Bright& texel : texels) {
    std::size_t i = 0;
    while (i < suns.size() && glm::dot(suns[i].direction, texel.direction) < least) ++i;
    if (i == Suns::MOST) return {};
    if (i == suns.size()) {
      suns.push_back({texel.direction, glm::dvec3(0)});
      sums.emplace_back(0);
    }
    suns[i].irradiance += texel.irradiance;
    sums[i] += texel.direction * luminance(texel.irradiance);
    if (glm::dot(sums[i], sums[i]) > 0) suns[i].direction = glm::normalize(sums[i]);
  }
  return suns;
}

}  // namespace

Suns sunsOf(const ImageF& map) {
  Suns suns;
  const std::vector<Bright> texels = excessOf(map, suns.share);
  for (double radius = FIRST_RADIUS; suns.list.empty() && !texels.empty(); radius *= 2)
    suns.list = gathered(texels, std::min(radius, glm::pi<double>()));
  return suns;
}

}  // namespace telar::ibl
