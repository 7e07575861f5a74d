#include "ibl/bright_directions.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>

#include "ibl/equirect_grid.h"
#include "telar/codec.h"
#include "telar/luminance.h"

namespace telar::ibl {
namespace {

/// Radiance above this multiple of the mean is sampled. Below it, samples of the material suffice.
constexpr double EXCESS_OVER_MEAN = 4;

/// A texel this many times as bright as its surroundings belongs to a compact light.
constexpr double COMPACT_OVER_LOCAL = 3;
constexpr double LOCAL_RADIUS = 0.1;  ///< of the surroundings, radians

constexpr std::size_t PARTS = 2048;  ///< of equal energy, that the excess is divided into

/// Position along Morton's curve, which keeps neighbours close.
std::uint64_t alongCurve(std::uint32_t x, std::uint32_t y) {
  const auto spread = [](std::uint64_t v) {
    v = (v | v << 16) & 0x0000ffff0000ffffull;
    v = (v | v << 8) & 0x00ff00ff00ff00ffull;
    v = (v | v << 4) & 0x0f0f0f0f0f0f0f0full;
    v = (v | v << 2) & 0x3333333333333333ull;
    return (v | v << 1) & 0x5555555555555555ull;
  };
  return spread(x) | spread(y) << 1;
}

/// Mean luminance of the map about a texel, from sums over all texels above and to the left.
class LocalMean {
 public:
  LocalMean(const ImageF& map, const EquirectGrid& grid)
      : grid_(grid), sums_(static_cast<std::size_t>(grid.width + 1) * (grid.height + 1)) {
    for (std::uint32_t y = 0; y < grid.height; ++y) {
      const double angle = grid.solidAngle(y);
      double row = 0;
      for (std::uint32_t x = 0; x < grid.width; ++x) {
        const float* rgba = &map.pixels[(static_cast<std::size_t>(y) * grid.width + x) * 4];
        row += luminance(glm::make_vec3(rgba)) * angle;
        sum(x + 1, y + 1) = sum(x + 1, y) + row;
      }
    }
  }
  double overall() { return sum(grid_.width, grid_.height) / (4 * glm::pi<double>()); }
  double at(std::uint32_t x, std::uint32_t y) {
    const double rows = LOCAL_RADIUS / glm::pi<double>() * grid_.height;
    const double columns = rows / std::max(std::sin(grid_.polar(y + 0.5)), 1e-3);
    const auto top = static_cast<std::uint32_t>(std::max(y - rows, 0.0));
    const auto bottom = static_cast<std::uint32_t>(std::min(y + 1 + rows, static_cast<double>(grid_.height)));
    const double angle = std::cos(grid_.polar(top)) - std::cos(grid_.polar(bottom));
    const auto width = static_cast<std::int64_t>(grid_.width);
    const auto half = static_cast<std::int64_t>(std::min(columns, (grid_.width - 1) / 2.0));
    const std::int64_t left = x - half, right = x + half + 1;
    double total = between(std::max(left, std::int64_t{0}), std::min(right, width), top, bottom);
    if (left < 0) total += between(left + width, width, top, bottom);
    if (right > width) total += between(0, right - width, top, bottom);
    return total / (angle * glm::two_pi<double>() * static_cast<double>(right - left) / grid_.width);
  }

 private:
  double& sum(std::uint32_t x, std::uint32_t y) { return sums_[static_cast<std::size_t>(y) * (grid_.width + 1) + x]; }
  double between(std::int64_t left, std::int64_t right, std::uint32_t top, std::uint32_t bottom) {
    const auto l = static_cast<std::uint32_t>(left), r = static_cast<std::uint32_t>(right);
    return sum(r, bottom) - sum(l, bottom) - sum(r, top) + sum(l, top);
  }
  EquirectGrid grid_;
  std::vector<double> sums_;
};

}  // namespace

BrightDirections::BrightDirections(ImageF& map) {
  const EquirectGrid grid{map.width, map.height};
  const auto texel = [&](std::uint32_t x, std::uint32_t y) {
    return &map.pixels[(static_cast<std::size_t>(y) * map.width + x) * 4];
  };
  LocalMean local(map, grid);
  const auto threshold = static_cast<float>(std::min(local.overall() * EXCESS_OVER_MEAN, double(HALF_MAX)));
  std::vector<std::pair<std::uint64_t, std::uint32_t>> found;  // place along the curve, index
  for (std::uint32_t y = 0; y < map.height; ++y) {
    const double angle = grid.solidAngle(y);
    for (std::uint32_t x = 0; x < map.width; ++x) {
      float* rgba = texel(x, y);
      rgba[3] = std::max(luminance(glm::make_vec3(rgba)) - threshold, 0.0f);
      energy_ += rgba[3] * angle;
      if (rgba[3] > 0) found.emplace_back(alongCurve(x, y), y * map.width + x);
    }
  }
  std::sort(found.begin(), found.end());
  double sum = 0;
  for (const auto& [place, index] : found) {
    const std::uint32_t x = index % map.width, y = index / map.width;
    float* rgba = texel(x, y);
    const glm::vec3 colour = glm::make_vec3(rgba);
    const float whole = luminance(colour);
    sum += rgba[3] * grid.solidAngle(y);
    // The rest of the map is stored as half floats.
    const bool compact = whole > HALF_MAX || whole > COMPACT_OVER_LOCAL * local.at(x, y);
    const Part part{glm::vec3(grid.direction(x, y)), colour / whole, rgba[3], compact};
    while (parts_.size() < PARTS && energy_ * (static_cast<double>(parts_.size()) + 0.5) / PARTS <= sum)
      parts_.push_back(part);
    if (!compact) continue;
    for (int c = 0; c < 3; ++c) rgba[c] *= threshold / whole;
    rgba[3] = 0;
  }
  while (!parts_.empty() && parts_.size() < PARTS) parts_.push_back(parts_.back());
}

std::vector<BrightDirections::Direction> BrightDirections::directions(int count, int first, int step) const {
  std::vector<Direction> list;
  for (int i = first; i < count && !parts_.empty(); i += step) {
    const Part& part = parts_[static_cast<std::size_t>((i + 0.5) * PARTS / count)];
    const auto density = static_cast<float>(static_cast<float>(count) * part.excess / energy_);
    list.push_back({part.direction, part.colour * static_cast<float>(energy_ / count),
                    part.compact ? BrightDirections::COMPACT : density});
  }
  return list;
}

}  // namespace telar::ibl
