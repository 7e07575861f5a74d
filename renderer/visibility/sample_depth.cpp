#include "visibility/sample_depth.h"

#include <algorithm>
#include <cmath>

#include "visibility/lanes.h"

namespace telar::visibility {
namespace {

constexpr float OPEN = 2;  ///< behind all depths

/// A plane at the samples of the pixels of a row.
class PlaneRow {
 public:
  PlaneRow(const Plane& plane, float offset, Lanes placesX, Lanes y)
      : slope_(lanesOf(plane.a)),
        begin_(lanesOf(plane.a) * placesX + lanesOf(plane.b) * y + lanesOf(plane.c + offset)) {}
  /// @param x  of the pixel's left border, in each lane
  Lanes at(Lanes x) const { return slope_ * x + begin_; }

 private:
  Lanes slope_, begin_;
};

Lanes placesOf(const SampleGrid& grid, int axis) {
  return Lanes{grid.places[0][axis], grid.places[1][axis], grid.places[2][axis], grid.places[3][axis]};
}

/// Above this many pixels a box is looked at row by row, only where the edges let samples be. Below it that costs more
/// than it saves.
constexpr double LARGE = 256;

/// From where to where in a row there may be a sample at which each edge has a least value; with all for which a sum in
/// floats says so. A needle across the window has few pixels, and a box of as many as the window.
class Columns {
 public:
  Columns(const SampleGrid& grid, const WindowTriangle& triangle, const float (&insets)[3], float least)
      : box_(triangle.pixels), all_(!(countOf(box_) > LARGE)) {
    if (all_) return;
    for (int i = 0; i < 3; ++i) {
      const Plane& edge = triangle.edges[i];
      const double a = edge.a, b = edge.b, c = edge.c;
      double most = a * grid.places[0].x + b * grid.places[0].y;
      for (const glm::vec2& place : grid.places) most = std::max(most, a * place.x + b * place.y);
      // Six roundings of what is summed.
      const double size =
          std::abs(a) * (box_.toX + 1) + std::abs(b) * (box_.toY + 1) + std::abs(c) + std::abs(insets[i]);
      edges_[i] = {a, b, c - insets[i] - least + most + 8 * 0x1p-24 * size};
    }
  }
  /// @return false = none
  bool of(int y, int& from, int& to) const {
    from = box_.fromX;
    to = box_.toX;
    if (all_) return from <= to;
    for (const Edge& edge : edges_) {
      const double rest = edge.b * y + edge.c;
      if (edge.a == 0) {
        if (rest < 0) return false;
        continue;
      }
      const double at = std::clamp(-rest / edge.a, box_.fromX - 2.0, box_.toX + 2.0);
      if (edge.a > 0) {
        from = std::max(from, static_cast<int>(std::floor(at)));
      } else {
        to = std::min(to, static_cast<int>(std::ceil(at)));
      }
    }
    return from <= to;
  }

 private:
  struct Edge {
    double a, b, c;
  };
  Pixels box_;
  bool all_;
  Edge edges_[3] = {};
};

/// Calls `visit` with each pixel, where its depths are, and for its samples the least value of an edge less its inset,
/// and the depth. Ends where that returns false. @return whether it came to the end
/// @param least  pixels may be left out where that value is below it at every sample
/// @param[in,out] steps  increased by the pixels and the rows that it looked at
template <class Depth, class PixelOf, class Visit>
bool forSamples(const SampleGrid& grid, const WindowTriangle& triangle, const float (&insets)[3], float least,
                float depthOffset, std::int64_t& steps, const PixelOf& pixelOf, const Visit& visit) {
  const Lanes placesX = placesOf(grid, 0), placesY = placesOf(grid, 1);
  const Columns columns(grid, triangle, insets, least);
  for (int y = triangle.pixels.fromY; y <= triangle.pixels.toY; ++y) {
    ++steps;
    int from, to;
    if (!columns.of(y, from, to)) continue;
    steps += to - from + 1;
    const Lanes rowY = placesY + lanesOf(static_cast<float>(y));
    const PlaneRow first(triangle.edges[0], -insets[0], placesX, rowY);
    const PlaneRow second(triangle.edges[1], -insets[1], placesX, rowY);
    const PlaneRow third(triangle.edges[2], -insets[2], placesX, rowY);
    const PlaneRow depth(triangle.depth, depthOffset, placesX, rowY);
    Lanes left = lanesOf(static_cast<float>(from));
    Depth* at = pixelOf(from, y);
    for (int x = from; x <= to; ++x, left += lanesOf(1), at += SAMPLES) {
      const Lanes inside = smaller(first.at(left), smaller(second.at(left), third.at(left)));
      if (!visit(x, y, at, inside, depth.at(left))) return false;
    }
  }
  return true;
}

}  // namespace

void SampleDepth::begin(const SampleGrid& grid, const Pixels& part) {
  grid_ = grid;
  part_ = {part.fromX / BLOCK * BLOCK, part.toX, part.fromY / BLOCK * BLOCK, part.toY};
  const auto blocks = [](int from, int to) { return static_cast<std::size_t>(std::max(to - from + BLOCK, 0) / BLOCK); };
  columns_ = blocks(part_.fromX, part_.toX);
  const std::size_t rows = blocks(part_.fromY, part_.toY);
  stride_ = columns_ * BLOCK * SAMPLES;
  depths_.assign(stride_ * rows * BLOCK, OPEN);
  farthest_.assign(columns_ * rows, OPEN);
}

bool SampleDepth::contains(const Pixels& pixels) const {
  return pixels.fromX >= part_.fromX && pixels.toX <= part_.toX && pixels.fromY >= part_.fromY &&
         pixels.toY <= part_.toY;
}

glm::vec2 SampleDepth::placeOf(const Sample& sample) const {
  return glm::vec2(sample.x, sample.y) + grid_.places[static_cast<std::size_t>(sample.place)];
}

void SampleDepth::add(const Sample& sample, float depth) {
  float& known = pixelOf(sample.x, sample.y)[sample.place];
  known = std::min(known, depth);
}

void SampleDepth::add(const WindowTriangle& triangle, std::vector<Sample>& edge, std::int64_t& steps) {
  if (!contains(triangle.pixels)) return;
  const float insets[3] = {triangle.margins[0] * triangle.inset, triangle.margins[1] * triangle.inset,
                           triangle.margins[2] * triangle.inset};
  // Down to half an inset outside: rounding may put a sample on an edge there for both its triangles.
  const float least = -1.5f * std::max({insets[0], insets[1], insets[2]});
  const Lanes band = lanesOf(least);
  const auto placed = [this](int x, int y) { return pixelOf(x, y); };
  forSamples<float>(grid_, triangle, insets, least, triangle.depthSlack, steps, placed,
                    [&](int x, int y, float* at, Lanes value, Lanes depth) {
                      const Lanes known = load(at);
                      const Mask inside = value >= lanesOf(0), near = (value >= band) & (depth < known) & ~inside;
                      store(at, (inside & (depth < known)) ? depth : known);
                      if (any(near)) {
                        for (int place = 0; place < SAMPLES; ++place) {
                          if (near[place]) edge.push_back({x, y, place});
                        }
                      }
                      return true;
                    });
}

void SampleDepth::close() {
  const std::size_t rows = columns_ == 0 ? 0 : farthest_.size() / columns_;
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns_; ++column) {
      Lanes most = lanesOf(0);
      for (int y = 0; y < BLOCK; ++y) {
        const float* at =
            depths_.data() + (row * BLOCK + static_cast<std::size_t>(y)) * stride_ + column * BLOCK * SAMPLES;
        for (int x = 0; x < BLOCK; ++x, at += SAMPLES) most = larger(most, load(at));
      }
      farthest_[row * columns_ + column] = std::max({most[0], most[1], most[2], most[3]});
    }
  }
}

bool SampleDepth::covers(const Pixels& pixels, float depth, std::int64_t& steps) const {
  if (!contains(pixels)) return false;
  const auto block = [](int at, int from) { return static_cast<std::size_t>(at - from) / BLOCK; };
  const std::size_t toX = block(pixels.toX, part_.fromX), toY = block(pixels.toY, part_.fromY);
  for (std::size_t y = block(pixels.fromY, part_.fromY); y <= toY; ++y) {
    for (std::size_t x = block(pixels.fromX, part_.fromX); x <= toX; ++x) {
      ++steps;
      if (!(farthest_[y * columns_ + x] < depth)) return false;
    }
  }
  return true;
}

bool SampleDepth::hides(const WindowTriangle& triangle, std::int64_t& steps) const {
  if (!contains(triangle.pixels)) return false;
  const float insets[3] = {-triangle.margins[0], -triangle.margins[1], -triangle.margins[2]};
  const auto placed = [this](int x, int y) { return pixelOf(x, y); };
  const auto visit = [](int, int, const float* at, Lanes least, Lanes depth) {
    return !any((least >= lanesOf(0)) & (depth <= load(at)));
  };
  return forSamples<const float>(grid_, triangle, insets, 0, -triangle.depthSlack, steps, placed, visit);
}

}  // namespace telar::visibility
