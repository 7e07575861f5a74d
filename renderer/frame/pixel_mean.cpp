#include "frame/pixel_mean.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>

#include "telar/luminance.h"

namespace telar::frame {
namespace {

constexpr unsigned FEWEST_TO_JOIN = 8;  ///< passes whose halves tell the noise

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

/// Encoded luma of greys, as a table: errors are told by it.
class EncodedGrey {
 public:
  explicit EncodedGrey(const PixelEncoder& encoder) {
    for (std::size_t i = 0; i < values_.size(); ++i) {
      const float root = static_cast<float>(i) / LAST, radiance = BRIGHTEST * root * root;
      values_[i] = std::clamp(encoder(glm::vec4(glm::vec3(radiance), 1)).g, 0.0f, 1.0f);
    }
  }
  float operator()(float radiance) const {
    const float place = LAST * std::sqrt(std::clamp(radiance / BRIGHTEST, 0.0f, 1.0f));
    const auto at = std::min(static_cast<std::size_t>(place), values_.size() - 2);
    return values_[at] + (values_[at + 1] - values_[at]) * (place - static_cast<float>(at));
  }

 private:
  static constexpr float LAST = 1024;  ///< by the root of the radiance, of which black has more values
  std::array<float, 1025> values_{};
};

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

void PixelMean::setGuide(std::vector<glm::vec4> picture) {
  guide_ = std::move(picture);
  apart_.resize(guide_.size());
}

bool PixelMean::add(const Frame& frame, bool last, unsigned passes) {
  const auto* pixel = reinterpret_cast<const glm::vec4*>(frame.pixels.data());
  for (std::size_t i = 0; i < second_.size(); ++i) {
    if (!settled_.empty() && settled_[i]) continue;
    second_[i] += pixel[i];
    count_[i] += passes;
  }
  joined_.clear();
  if (!std::has_single_bit(passes_ += passes)) return false;
  if (!guide_.empty() && passes_ >= FEWEST_TO_JOIN) setHalvesApart();
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

void PixelMean::setHalvesApart() {
  for (std::size_t i = 0; i < apart_.size(); ++i) {
    if (!settled_.empty() && settled_[i]) continue;
    const glm::vec4 &a = first_[i], &b = second_[i];
    const glm::vec3 color = a.a > 0 && b.a > 0 ? glm::vec3(b) / b.a - glm::vec3(a) / a.a : glm::vec3(0);
    apart_[i] = glm::vec4(color / 2.0f, (b.a - a.a) / static_cast<float>(passes_));
  }
}

void PixelMean::look() {
  settled_.resize(shot_.noise > 0 ? second_.size() : 0);
  error_.resize(second_.size());
  std::vector<float> squares = guide_.empty() ? squaresOfHalves() : squaresOfDenoised();
  double sum = 0;
  std::size_t moving = 0;
  for (std::size_t i = 0; i < squares.size(); ++i) {
    if (settled_.empty() || !settled_[i]) error_[i] = std::sqrt(squares[i]);
    sum += static_cast<double>(error_[i]);
    moving += error_[i] > 0;
  }
  standardError_ = moving == 0 ? 0 : 255 * sum / static_cast<double>(moving);
  if (shot_.noise > 0) settle(std::move(squares));
}

std::vector<float> PixelMean::squaresOfHalves() const {
  const PixelEncoder encoded(shot_);
  std::vector<float> squares(second_.size());
  for (std::size_t i = 0; i < squares.size(); ++i) {
    if (!settled_.empty() && settled_[i]) continue;
    // The standard error of the mean is half of the difference of the halves.
    const glm::vec2 apart = difference(i, encoded) / 2.0f;
    squares[i] = std::max(apart.x * apart.x, apart.y * apart.y);
  }
  return squares;
}

std::vector<float> PixelMean::squaresOfDenoised() {
  const EncodedGrey encoded{PixelEncoder(shot_)};
  Denoised now = denoised(true);
  std::vector<float> squares(second_.size());
  for (std::size_t i = 0; i < squares.size(); ++i) {
    if (!settled_.empty() && settled_[i]) continue;
    const glm::vec4& pixel = now.picture[i];
    const float shown = pixel.a > 0 ? luminance(glm::vec3(pixel)) / pixel.a : 0;
    const float ofColor = (encoded(shown + now.error[i].x) - encoded(shown)) * pixel.a;
    squares[i] = std::max(ofColor * ofColor, now.error[i].y * now.error[i].y);
  }
  joined_ = std::move(now.picture);
  return squares;
}

void PixelMean::settle(std::vector<float> squares) {
  blur(squares, shot_.width, shot_.height);
  const auto most = static_cast<float>(shot_.noise * shot_.noise / (255.0 * 255.0));
  for (std::size_t i = 0; i < settled_.size(); ++i) {
    if (settled_[i] || squares[i] > most) continue;
    settled_[i] = 255;
    --left_;
  }
}

std::vector<glm::vec4> PixelMean::plainMean() const {
  std::vector<glm::vec4> picture(first_.size());
  for (std::size_t i = 0; i < picture.size(); ++i)
    picture[i] = (first_[i] + second_[i]) / static_cast<float>(std::max(count_[i], 1u));
  return picture;
}

Denoised PixelMean::denoised(bool asksError) const {
  return denoise({shot_.width, shot_.height, plainMean(), apart_, guide_, count_, asksError});
}

std::vector<glm::vec4> PixelMean::mean() const {
  std::vector<glm::vec4> picture = joined_;
  if (picture.empty()) picture = guide_.empty() || passes_ < FEWEST_TO_JOIN ? plainMean() : denoised(false).picture;
  for (glm::vec4& pixel : picture) pixel = glm::max(pixel, 0.0f);
  return picture;
}

}  // namespace telar::frame
