#include "frame/guided_denoise.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "frame/wavelet_shrinkage.h"
#include "telar/luminance.h"

namespace telar::frame {
namespace {

constexpr int TILE = 1024;  ///< pixels on a side: bounds what the fields take
static_assert(TILE % FIELD_GRID == 0);

constexpr int COLOR_BANDS = 3;  ///< with a fourth one the errors are the same

/// The standard error of coverage after one pass, as a mean over some pixels. Several layers of sheer cloth err by 0.1, a net by more. A
/// lone edge stays below NET_FROM, and its coverage is the mean's; from NET_TO on coverage is denoised.
constexpr float NET_FROM = 0.06f, NET_TO = 0.12f;

struct Box {
  int fromX, fromY, toX, toY;
  int width() const { return toX - fromX; }
  int height() const { return toY - fromY; }
};

glm::vec3 colorOf(const glm::vec4& pixel) { return pixel.a > 0 ? glm::vec3(pixel) / pixel.a : glm::vec3(0); }

/// What a pixel may have that is denoised. Where half of the guide is above white, as in light of physical units, that much more.
float brightestOf(const GuidedPicture& picture) {
  constexpr std::size_t MOST = 1 << 16;  // pixels that are looked at
  const std::size_t step = picture.guide.size() / MOST + 1;
  std::vector<float> light;
  for (std::size_t at = 0; at < picture.guide.size(); at += step) {
    const float one = luminance(colorOf(picture.guide[at]));
    if (picture.guide[at].a > 0 && std::isfinite(one)) light.push_back(one);
  }
  if (light.empty()) return BRIGHTEST;
  const auto middle = light.begin() + static_cast<std::ptrdiff_t>(light.size() / 2);
  std::nth_element(light.begin(), middle, light.end());
  return BRIGHTEST * std::max(*middle, 1.0f);
}

/// A tile of the picture with what it depends on.
class Tile {
 public:
  /// @param inner  what depends on nothing beyond the box
  /// @param mean  of the picture; it may be what is written, for coverage alone is read after colours are written
  Tile(const GuidedPicture& picture, std::span<const glm::vec4> mean, const Box& box, const Box& inner, float brightest)
      : picture_(picture), mean_(mean), box_(box), inner_(inner), brightest_(brightest) {}

  void joinColors(Denoised& out) const {
    NoisyField field(box_.width(), box_.height());
    forEach(box_, field, [&](std::size_t i, std::size_t at) {
      const glm::vec4 &mean = mean_[at], &guide = picture_.guide[at];
      const float weight = std::min(mean.a, guide.a);
      if (!(weight > 0)) return;
      const glm::vec3 shown = colorOf(mean), guess = colorOf(guide), apart(picture_.apart[at]);
      if (!isPlain(shown) || !isPlain(guess) || !isPlain(apart)) return;
      field.weight[i] = weight;
      field.excess[i] = glm::vec4(shown - guess, 1);
      field.noise[i] = glm::vec4(apart, 1);
    });
    const Shrunk shrunk = shrink(field, COLOR_BANDS);
    forEach(inner_, field, [&](std::size_t i, std::size_t at) {
      if (!(field.weight[i] > 0)) return;
      const float coverage = mean_[at].a;
      const glm::vec3 color = glm::max(colorOf(picture_.guide[at]) + shrunk.excess[i], 0.0f);
      out.picture[at] = glm::vec4(color * coverage, coverage);
      if (picture_.asksError) out.error[at].x = std::sqrt(shrunk.left[i]);
    });
  }

  /// Of nets.
  void joinCoverage(Denoised& out) const {
    NoisyField field(box_.width(), box_.height());
    forEach(box_, field, [&](std::size_t i, std::size_t at) {
      const float mean = mean_[at].a, guide = picture_.guide[at].a;
      if (!(std::max(mean, guide) > 0)) return;
      field.weight[i] = 1;
      field.excess[i] = glm::vec4(glm::vec3(mean - guide), 1);
      field.noise[i] = glm::vec4(glm::vec3(picture_.apart[at].a), 1);
    });
    const std::vector<float> energies = noiseEnergies(field);
    const Shrunk shrunk = shrink(field, MOST_BANDS);
    forEach(inner_, field, [&](std::size_t i, std::size_t at) {
      const float ofPass = std::sqrt(energies[i] * static_cast<float>(picture_.passes[at]));
      const float net = glm::smoothstep(NET_FROM, NET_TO, ofPass);
      if (!(net > 0)) return;
      const glm::vec4 before = out.picture[at], &guide = picture_.guide[at];
      const float coverage = glm::mix(before.a, std::clamp(guide.a + shrunk.excess[i].x, 0.0f, 1.0f), net);
      out.picture[at] = glm::vec4(colorOf(before.a > 0 ? before : guide) * coverage, coverage);
      if (picture_.asksError) out.error[at].y = glm::mix(out.error[at].y, std::sqrt(shrunk.left[i]), net);
    });
  }

 private:
  bool isPlain(const glm::vec3& color) const {
    return std::max({std::abs(color.r), std::abs(color.g), std::abs(color.b)}) <= brightest_;  // nor what is no number
  }

  /// Calls back with the index in the field and that in the picture.
  template <typename Visit>
  void forEach(const Box& part, const NoisyField& field, const Visit& visit) const {
    const auto width = static_cast<std::size_t>(picture_.width);
    for (int y = part.fromY; y < part.toY; ++y)
      for (int x = part.fromX; x < part.toX; ++x)
        visit(field.indexOf(x - box_.fromX, y - box_.fromY),
              static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x));
  }

  const GuidedPicture& picture_;
  std::span<const glm::vec4> mean_;
  Box box_, inner_;
  float brightest_;
};

/// Whether a square of the picture has many pixels that are covered in part, which an edge alone has not.
bool hasNets(const GuidedPicture& picture, const Box& all) {
  constexpr int SIDE = 16, MANY = SIDE * SIDE / 4;
  for (int y = all.fromY; y < all.toY; y += SIDE) {
    for (int x = all.fromX; x < all.toX; x += SIDE) {
      int count = 0;
      for (int row = y; row < std::min(y + SIDE, all.toY); ++row) {
        const glm::vec4* pixels =
            &picture.mean[static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.width)];
        for (int column = x; column < std::min(x + SIDE, all.toX); ++column)
          count += pixels[column].a > 0 && pixels[column].a < 1 ? 1 : 0;
      }
      if (count > MANY) return true;
    }
  }
  return false;
}

/// What the mean or the guide covers.
Box coveredOf(const GuidedPicture& picture) {
  Box box{picture.width, picture.height, 0, 0};
  for (int y = 0; y < picture.height; ++y) {
    const auto row = static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width);
    for (int x = 0; x < picture.width; ++x) {
      const std::size_t at = row + static_cast<std::size_t>(x);
      if (!(picture.mean[at].a > 0 || picture.guide[at].a > 0)) continue;
      box = {std::min(box.fromX, x), std::min(box.fromY, y), std::max(box.toX, x + 1), y + 1};
    }
  }
  box.fromX -= box.fromX % FIELD_GRID;
  box.fromY -= box.fromY % FIELD_GRID;
  return box;
}

}  // namespace

Denoised denoise(GuidedPicture picture) {
  const Box all = coveredOf(picture);
  const bool nets = hasNets(picture, all);
  const float brightest = brightestOf(picture);
  Denoised out;
  if (picture.asksError) {
    out.error.resize(picture.apart.size());
    for (std::size_t i = 0; i < out.error.size(); ++i) {
      const glm::vec3 color(picture.apart[i]);
      out.error[i] = {std::sqrt(luminance(color * color)), std::abs(picture.apart[i].a)};
    }
  }
  out.picture = std::move(picture.mean);
  // A tile reads beyond itself, where another one has written.
  const bool several = all.width() > TILE || all.height() > TILE;
  const std::vector<glm::vec4> kept = several ? out.picture : std::vector<glm::vec4>();
  const std::span<const glm::vec4> mean = several ? kept : out.picture;
  for (int y = all.fromY; y < all.toY; y += TILE) {
    for (int x = all.fromX; x < all.toX; x += TILE) {
      const Box inner{x, y, std::min(x + TILE, all.toX), std::min(y + TILE, all.toY)};
      const Box box{std::max(x - FIELD_REACH, all.fromX), std::max(y - FIELD_REACH, all.fromY),
                    std::min(inner.toX + FIELD_REACH, all.toX), std::min(inner.toY + FIELD_REACH, all.toY)};
      const Tile tile(picture, mean, box, inner, brightest);
      tile.joinColors(out);
      if (nets) tile.joinCoverage(out);
    }
  }
  return out;
}

}  // namespace telar::frame
