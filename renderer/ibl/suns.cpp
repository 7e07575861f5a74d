#include "ibl/suns.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>

#include "ibl/equirect_grid.h"
#include "telar/codec.h"
#include "telar/luminance.h"

namespace telar::ibl {
namespace {

/// Texels within this angle of a sun's middle belong to it: about the width of the smoothest cloth's specular lobe.
constexpr double FIRST_RADIUS = glm::radians(4.0);

/// A texel of a small light is this many times as bright as the mean of the map: all such texels together fill less
/// than a hundredth of the sphere.
constexpr double SMALL_OVER_MEAN = 100;

/// Small lights that are told apart at the most: each costs a fragment time.
constexpr std::size_t MOST_SMALL = 3;

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

/// Gives each texel to the first sun within the radius. Empty where that makes more than `most` suns.
std::vector<Suns::Sun> gathered(const std::vector<Bright>& texels, double radius, std::size_t most) {
  const double least = std::cos(radius);
  std::vector<Suns::Sun> suns;
  std::vector<glm::dvec3> sums;  // of directions, by luminance
  for (const Bright& texel : texels) {
    std::size_t i = 0;
    while (i < suns.size() && glm::dot(suns[i].direction, texel.direction) < least) ++i;
    if (i == most) return {};
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

/// Mean luminance of a map over the sphere.
double meanOf(const ImageF& map) {
  const EquirectGrid grid{map.width, map.height};
  double sum = 0;
  for (std::uint32_t y = 0; y < map.height; ++y) {
    double row = 0;
    for (std::uint32_t x = 0; x < map.width; ++x)
      row += luminance(glm::dvec3(glm::make_vec3(&map.pixels[(static_cast<std::size_t>(y) * map.width + x) * 4])));
    sum += row * grid.solidAngle(y);
  }
  return sum / (4 * glm::pi<double>());
}

/// Calls `use` with each texel above a luminance, its place and the share of its light that a sun takes: what is left
/// is as bright as that, and half floats hold it.
template <class Use>
void forBright(const ImageF& map, double threshold, const Use& use) {
  for (std::size_t i = 0; i < map.pixels.size(); i += 4) {
    const glm::dvec3 radiance(glm::make_vec3(&map.pixels[i]));
    const double whole = luminance(radiance);
    const double brightest = std::max({radiance.r, radiance.g, radiance.b});
    if (whole > threshold) use(i, 1 - std::min(threshold / whole, double(HALF_MAX) / brightest));
  }
}

}  // namespace

Suns takeSuns(ImageF& map) {
  const EquirectGrid grid{map.width, map.height};
  const double threshold = SMALL_OVER_MEAN * meanOf(map);
  std::vector<Bright> texels;
  forBright(map, threshold, [&](std::size_t i, double share) {
    const auto x = static_cast<std::uint32_t>(i / 4 % map.width), y = static_cast<std::uint32_t>(i / 4 / map.width);
    const glm::dvec3 radiance(glm::make_vec3(&map.pixels[i]));
    texels.push_back({grid.direction(x, y), radiance * (share * grid.solidAngle(y))});
  });
  const std::vector<Suns::Sun> small = gathered(texels, FIRST_RADIUS, MOST_SMALL);
  if (small.empty()) return sunsOf(map);
  forBright(map, threshold, [&](std::size_t i, double share) {
    for (std::size_t c = 0; c < 3; ++c) map.pixels[i + c] = static_cast<float>(map.pixels[i + c] * (1 - share));
  });
  Suns suns = sunsOf(map);
  suns.list.insert(suns.list.begin(), small.begin(), small.end());
  return suns;
}

Suns sunsOf(const ImageF& map) {
  Suns suns;
  const std::vector<Bright> texels = excessOf(map, suns.share);
  for (double radius = FIRST_RADIUS; suns.list.empty() && !texels.empty(); radius *= 2)
    suns.list = gathered(texels, std::min(radius, glm::pi<double>()), Suns::MOST);
  return suns;
}

}  // namespace telar::ibl
