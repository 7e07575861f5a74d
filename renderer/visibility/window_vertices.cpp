#include "visibility/window_vertices.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "visibility/lanes.h"
#include "visibility/quad_varyings.h"

namespace telar::visibility {
namespace {

/// Pixels from which on a place is none.
constexpr float UNBOUNDED = 1e6f;
/// Largest relative error of one rounding.
constexpr double ROUNDING = 0x1p-24;

Lanes column(const glm::mat4& m, int i) { return Lanes{m[i].x, m[i].y, m[i].z, m[i].w}; }

struct Transform {
  Lanes columns[4];
  explicit Transform(const glm::mat4& m) : columns{column(m, 0), column(m, 1), column(m, 2), column(m, 3)} {}
  Lanes of(float x, float y, float z, float w) const {
    return columns[0] * lanesOf(x) + columns[1] * lanesOf(y) + columns[2] * lanesOf(z) + columns[3] * lanesOf(w);
  }
};

/// How far the GL may put a vertex elsewhere in the window.
class PlaceError {
 public:
  /// @param clip  by which its place in clip space may differ
  PlaceError(const glm::dvec4& clip, const SampleGrid& grid)
      : place_(std::max(clip.x, clip.y)), w_(clip.w), extent_(std::max(grid.width, grid.height)), step_(grid.step) {}
  /// @param beyond  largest |x / w| or |y / w|    @return px, in x and y each; not below 1e6 where nothing is known
  double at(double w, double beyond) const {
    const double least = w - w_;
    if (!(least > 0)) return UNBOUNDED;
    return step_ + 0.5 * extent_ * (place_ + beyond * w_) / least + 16 * ROUNDING * extent_ * std::max(1.0, beyond);
  }

 private:
  double place_, w_, extent_, step_;
};

/// |m| |v|, which bounds every sum within m v.
glm::dvec4 magnitude(const glm::mat4& m, const glm::dvec4& v) {
  glm::dvec4 sum(0);
  for (int i = 0; i < 4; ++i) sum += glm::abs(glm::dvec4(m[i])) * v[i];
  return sum;
}

}  // namespace

void WindowVertices::place(const float* clip, std::size_t stride, std::size_t count, const glm::vec2& size,
                           const glm::vec2& moved) {
  vertices.resize(count);
  overW.resize(count);
  const bool fused = fusesProducts();
  for (std::size_t i = 0; i < count; ++i, clip += stride) {
    WindowVertex& vertex = vertices[i];
    vertex = {0, 0, 0, UNPROJECTED};
    const float w = clip[3];
    overW[i] = 1 / w;
    // Negated: what is no number is not projected.
    if (!(w > 0 && clip[2] >= -w && clip[2] <= w)) continue;
    const glm::vec3 place = windowPlace(clip, overW[i], size, fused) + glm::vec3(moved, 0);
    if (!(std::abs(place.x) < MOST_PLACE && std::abs(place.y) < MOST_PLACE)) continue;
    vertex = {place.x, place.y, place.z,
              (place.x < 0 ? LEFT : 0u) | (place.x > size.x ? RIGHT : 0u) | (place.y < 0 ? BELOW : 0u) |
                  (place.y > size.y ? ABOVE : 0u)};
  }
}

void WindowVertices::project(std::span<const glm::vec3> positions, const glm::mat4& modelView,
                             const glm::mat4& projection, const SampleGrid& grid) {
  low[0] = low[1] = std::numeric_limits<float>::max();
  high[0] = high[1] = 0;
  glm::vec3 largest(0);
  for (const glm::vec3& p : positions) largest = glm::max(largest, glm::abs(p));
  // A sum of four products is off by at most four roundings of the sum of their magnitudes; so are the GL's and this
  // one, of two products in turn. src: Higham 2002, "Accuracy and Stability of Numerical Algorithms", section 3.1
  const glm::dvec4 error =
      16 * ROUNDING * magnitude(projection, magnitude(modelView, glm::dvec4(glm::dvec3(largest), 1)));
  const PlaceError placeError(error, grid);
  const auto nearMargin = static_cast<float>(error.z + error.w);
  const Transform toView(modelView), toClip(projection);
  const float width = static_cast<float>(grid.width), height = static_cast<float>(grid.height);
  float leastW = std::numeric_limits<float>::max();
  vertices.resize(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const glm::vec3& p = positions[i];
    const Lanes view = toView.of(p.x, p.y, p.z, 1);
    const Lanes clip = toClip.of(view[0], view[1], view[2], view[3]);
    WindowVertex& vertex = vertices[i];
    const float w = clip[3];
    // Negated: what is no number is not projected.
    if (!(w > 0 && clip[2] >= -w && clip[2] <= w)) {
      vertex = {0, 0, 0, UNPROJECTED};
      continue;
    }
    const Lanes place = clip / lanesOf(w) * lanesOf(0.5f) + lanesOf(0.5f);
    vertex = {place[0] * width, place[1] * height, place[2], 0};
    if (!(std::abs(vertex.x) < UNBOUNDED && std::abs(vertex.y) < UNBOUNDED)) {
      vertex = {0, 0, 0, UNPROJECTED};
      continue;
    }
    // What is almost on the near plane the GL may cut away. At the far plane that shows nothing: what would be hidden
    // is farther still.
    const bool behindNear = clip[2] >= -w + nearMargin;
    if (!(behindNear && vertex.x >= 0 && vertex.x <= width && vertex.y >= 0 && vertex.y <= height)) {
      const float beyond = std::max(std::abs(clip[0]), std::abs(clip[1])) / w;
      if (!(placeError.at(w, beyond) < CLIPPED_SLACK)) {
        vertex = {0, 0, 0, UNPROJECTED};
        continue;
      }
      vertex.outside = CLIPPED | (vertex.x < -1 ? LEFT : 0u) | (vertex.x > width + 1 ? RIGHT : 0u) |
                       (vertex.y < -1 ? BELOW : 0u) | (vertex.y > height + 1 ? ABOVE : 0u);
      continue;
    }
    leastW = std::min(leastW, w);
    low[0] = std::min(low[0], vertex.x);
    low[1] = std::min(low[1], vertex.y);
    high[0] = std::max(high[0], vertex.x);
    high[1] = std::max(high[1], vertex.y);
  }
  slack = static_cast<float>(placeError.at(leastW, 1));
  depthSlack = static_cast<float>(0.5 * (error.z + error.w) / leastW + 8 * ROUNDING);
}

}  // namespace telar::visibility
