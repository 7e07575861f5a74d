#include "frame/pixel_mean.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "telar/luminance.h"

namespace telar::frame {
namespace {

constexpr int REACH = 2;  ///< pixels, half the window of the error estimate: one pixel alone may seem right by chance

/// Means over the window of REACH around each value of a line.
void blurLine(const float* from, float* to, int count, std::ptrdiff_t step) {
  for (int i = 0; i < count; ++i) {
    const int begin = std::max(i - REACH, 0), end = std::min(i + REACH + 1, count);
    float sum = 0;
    for (int k = begin; k < end; ++k) sum += from[k * step];
    to[i * step] = sum / static_cast<float>(end - begin);
  }
}

void blur(std::vector<float>& picture, int width, int height) {
  std::vector<float> rows(picture.size());
  for (std::ptrdiff_t y = 0; y < height; ++y)
    blurLine(&picture[static_cast<std::size_t>(y * width)], &rows[static_cast<std::size_t>(y * width)], width, 1);
  for (int x = 0; x < width; ++x)
    blurLine(&rows[static_cast<std::size_t>(x)], &picture[static_cast<std::size_t>(x)], height, width);
}

}  // namespace

PixelMean::PixelMean(const Shot& shot, bool exposed, bool measures, unsigned fewest)
    : shot_(shot),
      measures_(measures),
      fewest_(fewest),
      left_(static_cast<std::size_t>(shot.width) * static_cast<std::size_t>(shot.height)) {
  if (exposed) shot_.exposure = 1;
  first_.resize(left_);
  second_.resize(left_);
  count_.resize(left_);
}

bool PixelMean::add(const Frame& frame, bool last, unsigned passes) {
  const auto* pixel = reinterpret_cast<const glm::vec4*>(frame.pixels.data());
  for (std::size_t i = 0; i < second_.size(); ++i) {
    if (!settled_.empty() && settled_[i]) continue;
    second_[i] += pixel[i];
    count_[i] += passes;
  }
  if (!std::has_single_bit(passes_ += passes)) return false;
  const bool looks = (shot_.noise > 0 || measures_) && passes_ >= fewest_ && !last;
  if (looks) look();
  for (std::size_t i = 0; i < second_.size(); ++i) first_[i] += std::exchange(second_[i], glm::vec4(0));
  return looks && shot_.noise > 0;
}

/// Difference of the two halves in encoded luma, over black and over white.
glm::vec2 PixelMean::difference(std::size_t pixel, const PixelEncoder& encoded) const {
  const auto passes = passes_ / 2;
  const auto shown = [&](const glm::vec4& sum) {
    const glm::vec4 color = encoded(glm::max(sum, 0.0f) / static_cast<float>(passes));
    const float black = luminance(glm::clamp(glm::vec3(color), 0.0f, 1.0f)) * color.a;
    return glm::vec2(black, black + 1 - color.a);
  };
  return shown(first_[pixel]) - shown(second_[pixel]);
}

void PixelMean::look() {
  settled_.resize(shot_.noise > 0 ? second_.size() : 0);
  apart_.resize(second_.size());
  const PixelEncoder encoded(shot_);
  std::vector<float> squares(second_.size());
  double sum = 0;
  std::size_t moving = 0;
  for (std::size_t i = 0; i < squares.size(); ++i) {
    if (settled_.empty() || !settled_[i]) {
      const glm::vec2 apart = difference(i, encoded);
      squares[i] = std::max(apart.x * apart.x, apart.y * apart.y);
      apart_[i] = std::sqrt(squares[i]);
    }
    sum += static_cast<double>(apart_[i]);
    moving += apart_[i] > 0;
  }
  // The standard error of the mean is half of the difference of the halves.
  standardError_ = moving == 0 ? 0 : 255 * sum / (2 * static_cast<double>(moving));
  if (shot_.noise > 0) settle(std::move(squares));
}

void PixelMean::settle(std::vector<float> squares) {
  blur(squares, shot_.width, shot_.height);
  const auto most = static_cast<float>(4 * shot_.noise * shot_.noise / (255.0 * 255.0));
  for (std::size_t i = 0; i < squares.size(); ++i) {
    if (settled_[i] || squares[i] > most) continue;
    settled_[i] = 255;
    --left_;
  }
}

std::vector<glm::vec4> PixelMean::mean() const {
  std::vector<glm::vec4> picture(first_.size());
  for (std::size_t i = 0; i < picture.size(); ++i)
    picture[i] = glm::max(first_[i] + second_[i], 0.0f) / static_cast<float>(std::max(count_[i], 1u));
  return picture;
}

}  // namespace telar::frame
