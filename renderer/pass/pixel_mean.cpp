#include "pass/pixel_mean.h"

#include <algorithm>
#include <cstring>

#include "pass/linear_output.h"

namespace telar::pass {
namespace {

float luma(const glm::vec3& encoded) { return glm::dot(encoded, glm::vec3(0.2126f, 0.7152f, 0.0722f)); }

/// Mean of a pixel and its neighbours, row by row then column by column.
float pooled(const std::vector<float>& values, int width, int height, int x, int y) {
  float sum = 0;
  int count = 0;
  for (int v = std::max(y - 1, 0); v <= std::min(y + 1, height - 1); ++v) {
    for (int u = std::max(x - 1, 0); u <= std::min(x + 1, width - 1); ++u, ++count) {
      sum += values[static_cast<std::size_t>(v) * static_cast<std::size_t>(width) + static_cast<std::size_t>(u)];
    }
  }
  return sum / static_cast<float>(count);
}

}  // namespace

float PixelMean::Spread::variance(int rounds) const {
  const auto n = static_cast<float>(rounds);
  const glm::vec2 mean = sum / n;
  const glm::vec2 ofOne = (squares / n - mean * mean) * (n / (n - 1));
  return std::max(std::max(ofOne.x, ofOne.y), 0.0f) / n;
}

PixelMean::PixelMean(const Shot& shot) : shot_(shot) {
  shot_.exposure = 1;  // the passes were exposed
  const std::size_t pixels = static_cast<std::size_t>(shot.width) * static_cast<std::size_t>(shot.height);
  sum_.resize(pixels);
  round_.resize(pixels);
  count_.resize(pixels);
  if (shot.noise == 0) return;
  spreads_.resize(pixels);
  variances_.resize(pixels);
}

void PixelMean::add(const Frame& frame) {
  const auto* pixel = reinterpret_cast<const glm::vec4*>(frame.pixels.data());
  for (std::size_t i = 0; i < sum_.size(); ++i) {
    if (!settled_.empty() && settled_[i]) continue;
    round_[i] += pixel[i];
    ++count_[i];
  }
}

bool PixelMean::settle() {
  if (spreads_.empty()) return true;
  ++rounds_;
  const PixelEncoder encoded(shot_);
  for (std::size_t i = 0; i < sum_.size(); ++i) {
    if (!settled_.empty() && settled_[i]) continue;
    const glm::vec4 color = encoded(glm::max(round_[i], 0.0f) / static_cast<float>(ROUND));
    const float black = luma(glm::clamp(glm::vec3(color), 0.0f, 1.0f)) * color.a;
    const glm::vec2 value(black, black + 1 - color.a);
    spreads_[i].sum += value;
    spreads_[i].squares += value * value;
    sum_[i] += round_[i];
    round_[i] = glm::vec4(0);
    if (rounds_ > 1) variances_[i] = spreads_[i].variance(rounds_);
  }
  if (rounds_ < 2) return true;
  if (settled_.empty()) settled_.resize(sum_.size());
  const auto most = static_cast<float>(shot_.noise * shot_.noise / (255.0 * 255.0));
  std::size_t i = 0;
  bool left = false;
  for (int y = 0; y < shot_.height; ++y) {
    for (int x = 0; x < shot_.width; ++x, ++i) {
      if (!settled_[i] && pooled(variances_, shot_.width, shot_.height, x, y) <= most) settled_[i] = 255;
      left |= !settled_[i];
    }
  }
  return left;
}

std::vector<glm::vec4> PixelMean::mean() const {
  std::vector<glm::vec4> picture(sum_.size());
  for (std::size_t i = 0; i < picture.size(); ++i)
    picture[i] = glm::max(sum_[i] + round_[i], 0.0f) / static_cast<float>(std::max<int>(count_[i], 1));
  return picture;
}

double PixelMean::meanCount() const {
  double sum = 0;
  for (const std::uint16_t count : count_) sum += count;
  return sum / static_cast<double>(count_.size());
}

}  // namespace telar::pass
