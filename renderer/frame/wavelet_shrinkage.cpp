#include "frame/wavelet_shrinkage.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "telar/luminance.h"

namespace telar::frame {
namespace {

constexpr int WIDEST = 1 << (MOST_BANDS - 1);  ///< between the taps of the last band
constexpr int TAPS = 2;                        ///< of the spline, on each side
constexpr int SIDE = 2;                        ///< of a square that energies are summed over, in taps
constexpr int LOOKS = 2;                       ///< blurs of them, by taps 1 and 2 squares apart
static_assert(FIELD_GRID == SIDE * WIDEST && FIELD_REACH % FIELD_GRID == 0);
static_assert(FIELD_REACH >= TAPS * (2 * WIDEST - 1) + (TAPS * ((1 << LOOKS) - 1) + 1) * SIDE * WIDEST);

/// Four floats a pixel.
using Plane = std::vector<glm::vec4>;

/// Blurs planes of one size by a cubic B-spline whose taps lie `step` apart. Beyond the border there is nothing.
class Blur {
 public:
  Blur(int width, int height)
      : width_(static_cast<std::size_t>(width)),
        height_(static_cast<std::size_t>(height)),
        across_(width_ * height_),
        none_(width_) {}

  void operator()(Plane& plane, int step) {
    const auto apart = static_cast<std::size_t>(step);
    line_.assign(width_ + 2 * TAPS * apart, glm::vec4(0));
    for (std::size_t y = 0; y < height_; ++y) {
      const glm::vec4* from = &plane[y * width_];
      std::copy(from, from + width_, line_.begin() + static_cast<std::ptrdiff_t>(TAPS * apart));
      const glm::vec4* line = line_.data();
      sum({line, line + apart, line + 2 * apart, line + 3 * apart, line + 4 * apart}, &across_[y * width_]);
    }
    const auto row = [&](std::size_t y, int tap) {
      const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(y) + tap * step;
      return at < 0 || at >= static_cast<std::ptrdiff_t>(height_) ? none_.data()
                                                                  : &across_[static_cast<std::size_t>(at) * width_];
    };
    for (std::size_t y = 0; y < height_; ++y)
      sum({row(y, -2), row(y, -1), row(y, 0), row(y, 1), row(y, 2)}, &plane[y * width_]);
  }

 private:
  struct Rows {
    const glm::vec4 *a, *b, *c, *d, *e;
  };
  void sum(const Rows& rows, glm::vec4* to) const {
    const float *a = &rows.a->x, *b = &rows.b->x, *c = &rows.c->x, *d = &rows.d->x, *e = &rows.e->x;
    float* __restrict out = &to->x;
    for (std::size_t i = 0; i < 4 * width_; ++i)
      out[i] = 0.375f * c[i] + 0.25f * (b[i] + d[i]) + 0.0625f * (a[i] + e[i]);
  }

  std::size_t width_, height_;
  Plane across_, none_, line_;
};

float energy(const glm::vec3& color) { return luminance(color * color); }

/// Sums over squares of a field, blurred, and what lies between their middles.
class Squares {
 public:
  /// @param side  of a square
  Squares(const NoisyField& field, int side)
      : side_(side),
        width_((field.width + side - 1) / side),
        height_((field.height + side - 1) / side),
        values_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_)),
        row_(static_cast<std::size_t>(width_)) {
    for (int x = 0; x < field.width; ++x) columns_.push_back(between(x, width_));
  }

  /// Sums energies of the excess, of the noise, and 1, all times the weights, and blurs the sums.
  void sumEnergies(const NoisyField& field) {
    for (int y = 0; y < field.height; ++y) {
      glm::vec4* sums = &values_[indexOf(0, y / side_)];
      for (int x = 0; x < field.width; ++x) {
        const std::size_t i = field.indexOf(x, y);
        sums[x / side_] +=
            field.weight[i] * glm::vec4(energy(glm::vec3(field.excess[i])), energy(glm::vec3(field.noise[i])), 1, 0);
      }
    }
    Blur blur(width_, height_);
    for (int look = 0; look < LOOKS; ++look) blur(values_, 1 << look);
  }
  std::vector<glm::vec4>& values() { return values_; }

  /// Makes what at() returns that of a row of the field.
  void setRow(int y) {
    const Between rows = between(y, height_);
    for (int x = 0; x < width_; ++x)
      row_[static_cast<std::size_t>(x)] =
          glm::mix(glm::vec2(values_[indexOf(x, rows.from)]), glm::vec2(values_[indexOf(x, rows.to)]), rows.part);
  }
  /// The first two of a place in the row.
  glm::vec2 at(int x) const {
    const Between& columns = columns_[static_cast<std::size_t>(x)];
    return glm::mix(row_[static_cast<std::size_t>(columns.from)], row_[static_cast<std::size_t>(columns.to)],
                    columns.part);
  }

 private:
  struct Between {
    int from, to;
    float part;
  };
  Between between(int place, int squares) const {
    const float middle = std::clamp((static_cast<float>(place) + 0.5f) / static_cast<float>(side_) - 0.5f, 0.0f,
                                    static_cast<float>(squares - 1));
    const int from = static_cast<int>(middle);
    return {from, std::min(from + 1, squares - 1), middle - static_cast<float>(from)};
  }
  std::size_t indexOf(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }

  int side_, width_, height_;
  Plane values_;
  std::vector<glm::vec2> row_;
  std::vector<Between> columns_;
};

/// Takes a field apart, from the finest band on.
class Bands {
 public:
  Bands(NoisyField& field, int count) : field_(field), count_(count), blur_(field.width, field.height) {
    const std::size_t values = field.weight.size();
    wideExcess_.resize(values);
    wideNoise_.resize(values);
    shrunk_ = {std::vector<glm::vec3>(values), std::vector<float>(values)};
  }

  Shrunk shrunk() {
    for (int band = 0; band < count_; ++band) {
      const int step = 1 << band;
      takeWider(field_.excess, wideExcess_, step);
      takeWider(field_.noise, wideNoise_, step);
      add(step);
      field_.excess.swap(wideExcess_);
      field_.noise.swap(wideNoise_);
    }
    add(1 << (count_ - 1));
    return std::move(shrunk_);
  }

 private:
  /// Takes what is wider out of a plane, so that its finest band is left.
  void takeWider(Plane& plane, Plane& wide, int step) {
    const std::vector<float>& weight = field_.weight;
    for (std::size_t i = 0; i < wide.size(); ++i) wide[i] = plane[i] * weight[i];
    blur_(wide, step);
    for (std::size_t i = 0; i < wide.size(); ++i) {
      wide[i] = weight[i] > 0 ? wide[i] / wide[i].a : glm::vec4(0);
      plane[i] -= wide[i];
    }
  }

  /// Adds the part of a band that stands out of its noise.
  void add(int step) {
    Squares squares(field_, SIDE * step);
    squares.sumEnergies(field_);
    for (glm::vec4& value : squares.values()) {
      const float all = value.z > 0 ? value.x / value.z : 0, noise = value.z > 0 ? value.y / value.z : 0;
      const float sure = std::max(all - noise, 0.0f), part = sure > 0 ? sure / all : 0;
      value.x = part;
      value.y = part * part * noise + (1 - part) * (1 - part) * sure;
    }
    for (int y = 0; y < field_.height; ++y) {
      squares.setRow(y);
      for (int x = 0; x < field_.width; ++x) {
        const std::size_t i = field_.indexOf(x, y);
        if (!(field_.weight[i] > 0)) continue;
        const glm::vec2 partAndLeft = squares.at(x);
        shrunk_.excess[i] += partAndLeft.x * glm::vec3(field_.excess[i]);
        shrunk_.left[i] += partAndLeft.y;
      }
    }
  }

  NoisyField& field_;
  int count_;
  Blur blur_;
  Plane wideExcess_, wideNoise_;
  Shrunk shrunk_;
};

}  // namespace

NoisyField::NoisyField(int columns, int rows) : width(columns), height(rows) {
  const std::size_t count = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  weight.resize(count);
  excess.resize(count);
  noise.resize(count);
}

Shrunk shrink(NoisyField& field, int bands) { return Bands(field, bands).shrunk(); }

std::vector<float> noiseEnergies(const NoisyField& field) {
  Squares squares(field, SIDE);
  squares.sumEnergies(field);
  for (glm::vec4& value : squares.values()) value.x = value.z > 0 ? value.y / value.z : 0;
  std::vector<float> means(field.weight.size());
  for (int y = 0; y < field.height; ++y) {
    squares.setRow(y);
    for (int x = 0; x < field.width; ++x) means[field.indexOf(x, y)] = squares.at(x).x;
  }
  return means;
}

}  // namespace telar::frame
