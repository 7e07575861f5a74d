#include "pass/layer/ambient_layer.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/octahedron.h"

namespace telar::pass {
namespace {

constexpr std::uint32_t SQUARE = 4;  ///< pixels on a side that have different sets of rays
/// Rays that are behind a value, its pixel's own and those of its neighbours. The error of an even covering falls as
/// rays ** -0.75.
constexpr std::uint32_t TOGETHER = 256;
/// Weights of neighbours at -2 .. 2: each set of a square counts as much as any other.
constexpr float WEIGHTS[] = {0.5f, 1, 1, 1, 0.5f};
constexpr int REACH = 2;
/// Pixels towards the viewer, where the way is free, at which rays start. Corners of triangles are drawn on a grid of
/// 1/256 of a pixel: a point in a crease may lie behind its other side by as much.
constexpr float LIFT = 1.0f / 64;
constexpr float APART = 1;      ///< pixels beside a pixel's plane at which a neighbour is of another surface
constexpr float TURNED = 0.9f;  ///< cosine between normals at which it is

/// What the pixels show, in view space.
struct Seen {
  std::vector<std::size_t> pixels;
  std::vector<int> at;  ///< by pixel: its place in the other lists, or -1
  std::vector<glm::dvec3> place;
  std::vector<glm::vec3> normal;
  std::vector<float> pixelWidth;  ///< metres
};

Seen seenOf(const SurfacePixels& pixels, const frame::Camera& camera) {
  const glm::dmat4& projection = camera.projection;
  const glm::dvec2 scale(projection[0][0], projection[1][1]), size(pixels.width, pixels.height);
  const auto width = static_cast<std::size_t>(pixels.width);
  Seen seen;
  seen.at.assign(pixels.place.size(), -1);
  for (std::size_t i = 0; i < pixels.place.size(); ++i) {
    if (pixels.number[i].x == 0) continue;
    const glm::dvec2 at = (glm::dvec2(i % width, i / width) + 0.5) / size * 2.0 - 1.0;
    const double z = -double{pixels.place[i].w}, w = projection[2][3] * z + projection[3][3];
    const glm::dvec2 offset = glm::dvec2(projection[2]) * z + glm::dvec2(projection[3]);
    seen.at[i] = static_cast<int>(seen.pixels.size());
    seen.pixels.push_back(i);
    seen.place.emplace_back((glm::dvec2(at.x, -at.y) * w - offset) / scale, z);
    seen.normal.push_back(octahedronDirection({pixels.number[i].z, pixels.number[i].w}));
    seen.pixelWidth.push_back(static_cast<float>(2 * w / (scale.y * size.y)));
  }
  return seen;
}

std::vector<SurfacePoint> pointsOf(const Seen& seen, const frame::Camera& camera) {
  const glm::dmat4 toWorld = glm::inverse(camera.view);
  const auto turned = [&](const glm::dvec3& v) { return glm::vec3(glm::dmat3(toWorld) * v); };
  std::vector<SurfacePoint> points;
  points.reserve(seen.pixels.size());
  for (std::size_t k = 0; k < seen.pixels.size(); ++k) {
    const glm::dvec3 toViewer = camera.orthographic ? glm::dvec3(0, 0, 1) : -glm::normalize(seen.place[k]);
    const glm::dvec3 start = seen.place[k] + toViewer * double{LIFT * seen.pixelWidth[k]};
    points.push_back(
        {glm::dvec3(toWorld * glm::dvec4(start, 1.0)), turned(glm::dvec3(seen.normal[k])), turned(toViewer)});
  }
  return points;
}

/// How much of one surface two pixels are, 0..1.
float sameSurface(const Seen& seen, std::size_t k, std::size_t other) {
  const glm::vec3 way(seen.place[other] - seen.place[k]);
  const float beside = std::abs(glm::dot(way, seen.normal[k])) / (APART * seen.pixelWidth[k]);
  const float turned = (1 - glm::dot(seen.normal[k], seen.normal[other])) / (1 - TURNED);
  return std::max(1 - beside, 0.0f) * std::max(1 - turned, 0.0f);
}

/// The pixels about one, by pairs that lie opposite each other: where one is of another surface neither counts, so that
/// what rises evenly across a surface stays as it is beside its borders.
/// @param take  called with both, by their place in the lists, and with the weight of each
template <class Take>
void forPairsAbout(const Seen& seen, std::size_t k, const glm::ivec2& size, const Take& take) {
  const int x = static_cast<int>(seen.pixels[k]) % size.x, y = static_cast<int>(seen.pixels[k]) / size.x;
  const auto at = [&](int dx, int dy) {
    const int column = x + dx, row = y + dy;
    if (column < 0 || column >= size.x || row < 0 || row >= size.y) return -1;
    return seen.at[static_cast<std::size_t>(row) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(column)];
  };
  for (int dy = 0; dy <= REACH; ++dy) {
    for (int dx = dy == 0 ? 1 : -REACH; dx <= REACH; ++dx) {
      const int one = at(dx, dy), opposite = at(-dx, -dy);
      if (one < 0 || opposite < 0) continue;
      const auto a = static_cast<std::size_t>(one), b = static_cast<std::size_t>(opposite);
      take(a, b,
           WEIGHTS[dx + REACH] * WEIGHTS[dy + REACH] * std::min(sameSurface(seen, k, a), sameSurface(seen, k, b)));
    }
  }
}

/// Rays of each pixel: the less its neighbours help it, the more it casts itself.
void chooseRays(const Seen& seen, const glm::ivec2& size, std::vector<SurfacePoint>& points) {
  for (std::size_t k = 0; k < points.size(); ++k) {
    float weights = 1;
    forPairsAbout(seen, k, size, [&](std::size_t, std::size_t, float weight) { weights += 2 * weight; });
    const std::size_t x = seen.pixels[k] % static_cast<std::size_t>(size.x),
                      y = seen.pixels[k] / static_cast<std::size_t>(size.x);
    const auto set = static_cast<std::uint32_t>(y % SQUARE * SQUARE + x % SQUARE);
    points[k].rays = std::bit_ceil(static_cast<std::uint32_t>(static_cast<float>(TOGETHER) / weights));
    // Sets of twice as many rays are two neighbouring sets.
    points[k].firstRay = set * (TOGETHER / (SQUARE * SQUARE)) / points[k].rays * points[k].rays;
  }
}

}  // namespace

std::vector<float> ambientLayer(const SurfacePixels& pixels, const frame::Camera& camera, const Scene& scene,
                                const Shot& shot, const CancelToken& cancel) {
  const glm::ivec2 size(pixels.width, pixels.height);
  const Seen seen = seenOf(pixels, camera);
  std::vector<SurfacePoint> points = pointsOf(seen, camera);
  chooseRays(seen, size, points);
  const std::vector<float> open = ambientOcclusion(scene, shot, points, cancel);
  std::vector<float> out(pixels.place.size());
  for (std::size_t k = 0; k < seen.pixels.size(); ++k) {
    float sum = open[k], weights = 1;
    forPairsAbout(seen, k, size, [&](std::size_t a, std::size_t b, float weight) {
      sum += weight * (open[a] + open[b]);
      weights += 2 * weight;
    });
    out[seen.pixels[k]] = sum / weights;
  }
  return out;
}

}  // namespace telar::pass
