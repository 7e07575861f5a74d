#include "reference/environment_light.h"

#include <algorithm>
#include <cmath>

#include "frame/camera.h"
#include "telar/luminance.h"

namespace telar::reference {
namespace {

constexpr double PI = 3.141592653589793;

/// Turns weights into a CDF, uniform where all are 0. @return their sum
float toCdf(float* begin, std::size_t count) {
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) {
    sum += begin[i + 1];
    begin[i + 1] = static_cast<float>(sum);
  }
  begin[0] = 0;
  for (std::size_t i = 1; i <= count; ++i) {
    begin[i] = sum > 0 ? static_cast<float>(begin[i] / sum) : static_cast<float>(i) / static_cast<float>(count);
  }
  return static_cast<float>(sum);
}

/// The interval of a CDF that u falls in, and the place within it.
std::pair<std::size_t, float> find(const float* begin, std::size_t count, float u) {
  const float* above = std::upper_bound(begin, begin + count, u);
  const std::size_t i = std::min(static_cast<std::size_t>(std::max<std::ptrdiff_t>(above - begin - 1, 0)), count - 1);
  const float width = begin[i + 1] - begin[i];
  return {i, width > 0 ? std::clamp((u - begin[i]) / width, 0.0f, 0.99999994f) : 0.5f};
}

}  // namespace

EnvironmentLight::EnvironmentLight(const ImageF& map, double rotation, double intensity)
    : map_(map), intensity_(static_cast<float>(intensity)), toEnvironment_(frame::environmentRotation(rotation)) {
  const int width = static_cast<int>(map.width), height = static_cast<int>(map.height);
  const std::size_t w = map.width, h = map.height;
  rows_.resize(h + 1);
  columns_.resize((w + 1) * h);
  for (int y = 0; y < height; ++y) {
    float* row = &columns_[static_cast<std::size_t>(y) * (w + 1)];
    for (int x = 0; x < width; ++x) {
      // A bilinear read spreads a texel over its neighbours, so they are sampled with it.
      float most = 0;
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) most = std::max(most, luminance(texel(x + dx, y + dy)));
      }
      row[x + 1] = most;
    }
    const double sine = std::sin(PI * (y + 0.5) / height);
    rows_[static_cast<std::size_t>(y) + 1] = static_cast<float>(toCdf(row, w) * sine);
  }
  toCdf(rows_.data(), h);
  for (std::size_t y = 0; y <= h; ++y) {
    heights_.push_back(std::sin(PI * (0.5 - static_cast<double>(y) / static_cast<double>(h))));
  }
}

glm::vec3 EnvironmentLight::texel(int x, int y) const {
  const int cx = std::clamp(x, 0, static_cast<int>(map_.width) - 1),
            cy = std::clamp(y, 0, static_cast<int>(map_.height) - 1);
  const float* p = &map_.pixels[(static_cast<std::size_t>(cy) * map_.width + static_cast<std::size_t>(cx)) * 4];
  return {p[0], p[1], p[2]};
}

glm::vec2 EnvironmentLight::coordinates(const glm::vec3& direction) const {
  const glm::dvec3 d(toEnvironment_ * direction);
  return {static_cast<float>(std::atan2(d.z, d.x) / (2 * PI) + 0.5),
          static_cast<float>(0.5 - std::asin(std::clamp(d.y, -1.0, 1.0)) / PI)};
}

EnvironmentLight::Sample EnvironmentLight::sample(const glm::vec2& u) const {
  const auto [row, inRow] = find(rows_.data(), map_.height, u.y);
  const auto [column, inColumn] = find(&columns_[row * (map_.width + 1)], map_.width, u.x);
  const double phi = ((static_cast<double>(column) + inColumn) / map_.width - 0.5) * 2 * PI;
  // Uniform in height, which is uniform in solid angle.
  const double top = heights_[row], y = top + (heights_[row + 1] - top) * inRow,
               radius = std::sqrt(std::max(0.0, 1 - y * y));
  const glm::vec3 direction(glm::dvec3(radius * std::cos(phi), y, radius * std::sin(phi)));
  return {glm::normalize(glm::transpose(toEnvironment_) * direction), pdfOf(row, column)};
}

float EnvironmentLight::pdf(const glm::vec3& direction) const {
  const glm::vec2 at = coordinates(direction);
  const auto row = std::min(static_cast<std::size_t>(std::max(at.y, 0.0f) * static_cast<float>(map_.height)),
                            static_cast<std::size_t>(map_.height - 1));
  const auto column = std::min(static_cast<std::size_t>(std::max(at.x, 0.0f) * static_cast<float>(map_.width)),
                               static_cast<std::size_t>(map_.width - 1));
  return pdfOf(row, column);
}

float EnvironmentLight::pdfOf(std::size_t row, std::size_t column) const {
  const float* columns = &columns_[row * (map_.width + 1)];
  const double share = static_cast<double>(rows_[row + 1] - rows_[row]) * (columns[column + 1] - columns[column]);
  const double angle = 2 * PI / map_.width * (heights_[row] - heights_[row + 1]);
  return static_cast<float>(share / angle);
}

glm::vec3 EnvironmentLight::radiance(const glm::vec3& direction) const {
  const glm::vec2 at = coordinates(direction) * glm::vec2(map_.width, map_.height) - 0.5f;
  const glm::vec2 low = glm::floor(at), part = at - low;
  const int x = static_cast<int>(low.x), y = static_cast<int>(low.y);
  return intensity_ * glm::mix(glm::mix(texel(x, y), texel(x + 1, y), part.x),
                               glm::mix(texel(x, y + 1), texel(x + 1, y + 1), part.x), part.y);
}

}  // namespace telar::reference
