#include "reference/environment_light.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/prefetch.h"
#include "core/unaligned.h"
#include "frame/camera.h"
#include "reference/angles.h"
#include "telar/luminance.h"

namespace telar::reference {
namespace {

constexpr double PI = std::numbers::pi;

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

}  // namespace

EnvironmentLight::EnvironmentLight(const ImageF& map, double rotation, double intensity)
    : map_(map), intensity_(static_cast<float>(intensity)), toEnvironment_(frame::environmentRotation(rotation)) {
  const int width = static_cast<int>(map.width), height = static_cast<int>(map.height);
  const std::size_t w = map.width, h = map.height;
  rows_.resize(h + 1 + Cdf::SCANNED);
  columns_.resize((w + 1) * h + Cdf::SCANNED);
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
  rowGuide_.resize(guideLength(h));
  fillGuide(rows_.data(), h, rowGuide_.data());
  columnGuide_.resize(guideLength(w) * h);
  for (std::size_t y = 0; y < h; ++y) fillGuide(&columns_[y * (w + 1)], w, &columnGuide_[y * guideLength(w)]);
  for (std::size_t y = 0; y <= h; ++y) {
    heights_.push_back(std::sin(PI * (0.5 - static_cast<double>(y) / static_cast<double>(h))));
  }
  for (std::size_t y = 0; y < h; ++y) {
    const double angle = 2 * PI / width * (heights_[y] - heights_[y + 1]);
    densities_.push_back(static_cast<float>(static_cast<double>(rows_[y + 1] - rows_[y]) / angle));
  }
}

void EnvironmentLight::fillGuide(const float* begin, std::size_t count, std::uint16_t* guide) {
  const std::size_t entries = guideLength(count);
  std::size_t i = 0;
  for (std::size_t k = 0; k < entries; ++k) {
    // Rounding of u times the number may reach the next entry: each starts a little early.
    const float u = (static_cast<float>(k) - 0.01f) / static_cast<float>(entries);
    while (i + 1 < count && begin[i + 1] <= u) ++i;
    guide[k] = static_cast<std::uint16_t>(std::min<std::size_t>(i, std::numeric_limits<std::uint16_t>::max()));
  }
}

EnvironmentLight::Cdf EnvironmentLight::columns(std::size_t row) const {
  const std::size_t width = map_.width;
  return {&columns_[row * (width + 1)], &columnGuide_[row * guideLength(width)], width};
}

const std::uint16_t* EnvironmentLight::Cdf::guideOf(float u) const {
  const std::size_t entries = guideLength(count);
  return guide + std::min(static_cast<std::size_t>(u * static_cast<float>(entries)), entries - 1);
}

std::pair<std::size_t, float> EnvironmentLight::Cdf::find(float u) const {
  std::size_t i = *guideOf(u);
  // Without a branch for each step, which no processor foresees.
  for (unsigned passed = SCANNED; passed == SCANNED && i < count; i += passed) {
    unsigned below = 0;
    for (std::size_t k = 0; k < SCANNED; ++k) below |= static_cast<unsigned>(begin[i + 1 + k] <= u) << k;
    passed = static_cast<unsigned>(std::countr_one(below));
  }
  i = std::min(i, count - 1);  // u is rounded to 1, or the last value to less
  const float width = begin[i + 1] - begin[i];
  return {i, width > 0 ? std::clamp((u - begin[i]) / width, 0.0f, 0.99999994f) : 0.5f};
}

const float* EnvironmentLight::texelAt(int x, int y) const {
  const int cx = std::clamp(x, 0, static_cast<int>(map_.width) - 1),
            cy = std::clamp(y, 0, static_cast<int>(map_.height) - 1);
  return &map_.pixels[(static_cast<std::size_t>(cy) * map_.width + static_cast<std::size_t>(cx)) * 4];
}

glm::vec3 EnvironmentLight::texel(int x, int y) const {
  const float* p = texelAt(x, y);
  return {p[0], p[1], p[2]};
}

glm::vec2 EnvironmentLight::coordinates(const glm::vec3& direction) const {
  // In float, as the shaders: an eight-thousandth of a texel of the widest maps.
  const glm::vec3 d = toEnvironment_ * direction;
  constexpr float RECIPROCAL_PI = static_cast<float>(1 / PI);
  return {arcTangent(d.z, d.x) * (RECIPROCAL_PI / 2) + 0.5f,
          0.5f - arcSine(std::clamp(d.y, -1.0f, 1.0f)) * RECIPROCAL_PI};
}

EnvironmentLight::Sample EnvironmentLight::sampleRow(std::size_t row, float inRow, float u) const {
  const auto [column, inColumn] = columns(row).find(u);
  const float across = (static_cast<float>(column) + inColumn) / static_cast<float>(map_.width);
  // Uniform in height, which is uniform in solid angle. In double: at the poles a float has no digits left.
  const double top = heights_[row], y = top + (heights_[row + 1] - top) * static_cast<double>(inRow);
  const auto radius = static_cast<float>(std::sqrt(std::max(0.0, 1 - y * y)));
  const SineCosine turned = sineCosine(across - 0.5f);
  const glm::vec3 direction(radius * turned.cosine, static_cast<float>(y), radius * turned.sine);
  const glm::vec2 at(across, 0.5f - arcSine(static_cast<float>(y)) * static_cast<float>(1 / PI));
  return {direction * toEnvironment_, pdfOf(row, column), placeAt(at)};
}

EnvironmentLight::Sample EnvironmentLight::sample(const glm::vec2& u) const {
  const auto [row, inRow] = rows().find(u.y);
  return sampleRow(row, inRow, u.x);
}

void EnvironmentLight::sample(std::span<const glm::vec2> us, Sample* samples) const {
  assert(us.size() <= MAX_SAMPLES);
  std::array<std::pair<std::size_t, float>, MAX_SAMPLES> found;
  for (std::size_t i = 0; i < us.size(); ++i) {
    found[i] = rows().find(us[i].y);
    telar::prefetch(columns(found[i].first).guideOf(us[i].x));
  }
  for (std::size_t i = 0; i < us.size(); ++i) {
    const Cdf cdf = columns(found[i].first);
    telar::prefetch(cdf.begin + *cdf.guideOf(us[i].x));
  }
  for (std::size_t i = 0; i < us.size(); ++i) {
    samples[i] = sampleRow(found[i].first, found[i].second, us[i].x);
    prefetch(samples[i].place);
  }
}

float EnvironmentLight::pdf(const glm::vec3& direction) const { return pdf(placeAt(coordinates(direction))); }

glm::vec3 EnvironmentLight::radiance(const glm::vec3& direction) const {
  return radiance(placeAt(coordinates(direction)));
}

EnvironmentLight::Place EnvironmentLight::find(const glm::vec3& direction) const {
  const Place place = placeAt(coordinates(direction));
  prefetch(place);
  const auto [row, column] = rowAndColumn(place);
  telar::prefetch(columns(row).begin + column);
  return place;
}

EnvironmentLight::Place EnvironmentLight::placeAt(const glm::vec2& coordinates) const {
  const glm::vec2 at = coordinates * glm::vec2(map_.width, map_.height) - 0.5f;
  glm::ivec2 low(at);  // towards 0
  low -= glm::ivec2(at.x < 0, at.y < 0);
  return {low, at - glm::vec2(low)};
}

std::pair<std::size_t, std::size_t> EnvironmentLight::rowAndColumn(const Place& place) const {
  const int column = place.low.x + (place.part.x >= 0.5f), row = place.low.y + (place.part.y >= 0.5f);
  return {static_cast<std::size_t>(std::clamp(row, 0, static_cast<int>(map_.height) - 1)),
          static_cast<std::size_t>(std::clamp(column, 0, static_cast<int>(map_.width) - 1))};
}

float EnvironmentLight::pdf(const Place& place) const {
  const auto [row, column] = rowAndColumn(place);
  return pdfOf(row, column);
}

float EnvironmentLight::pdfOf(std::size_t row, std::size_t column) const {
  const float* columns = &columns_[row * (map_.width + 1)];
  return densities_[row] * (columns[column + 1] - columns[column]);
}

void EnvironmentLight::prefetch(const Place& place) const {
  telar::prefetch(texelAt(place.low.x, place.low.y));
  telar::prefetch(texelAt(place.low.x, place.low.y + 1));
}

glm::vec3 EnvironmentLight::radiance(const Place& place) const {
  const auto row = [&](int y) {
    return glm::mix(loadUnaligned<glm::vec4>(texelAt(place.low.x, y)),
                    loadUnaligned<glm::vec4>(texelAt(place.low.x + 1, y)), place.part.x);
  };
  return intensity_ * glm::vec3(glm::mix(row(place.low.y), row(place.low.y + 1), place.part.y));
}

}  // namespace telar::reference
