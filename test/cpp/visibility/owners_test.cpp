#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <random>

#include "visibility/hidden_triangles.h"
#include "visibility/meshes.h"

// No triangle that owns a sample is left out. Which do is told by a rasterizer of whole numbers, as those of GPUs and
// of llvmpipe are: corners on a grid of 1/256 px, edges in integers, what lies on an edge given to one side, depths of
// 24 bits. Each corner is rounded down, up or to the nearest, by chance.

namespace telar::visibility::owners_test {
namespace {

using test::gridOf;
using test::Triangles;

constexpr int SIZE = 48;
constexpr int UNIT = 256;

class Chance {
 public:
  explicit Chance(std::uint32_t seed) : engine_(seed) {}
  double number() { return static_cast<double>(engine_()) * 0x1p-32; }
  double between(double low, double high) { return low + (high - low) * number(); }
  int below(int end) { return static_cast<int>(number() * end); }

 private:
  std::mt19937 engine_;
};

struct Corner {
  std::int64_t x, y;  ///< in units
  double z;
  bool seen;
};

/// A mesh, and whether each of its fragments is there.
struct Layer {
  Triangles mesh;
  Faces faces = Faces::kBoth;
  bool opaque = true;
};

struct View {
  glm::mat4 modelView, projection;
};

class Rasterizer {
 public:
  Rasterizer(const std::vector<Layer>& layers, const View& view, Chance& chance)
      : depths_(SIZE * SIZE * SAMPLES, 1 << 24) {
    for (const Layer& layer : layers) corners_.push_back(placed(layer, view, chance));
    for (std::size_t i = 0; i < layers.size(); ++i) {
      if (layers[i].opaque)
        forEach(layers[i], corners_[i],
                [&](std::size_t, std::size_t at, std::int64_t z) { depths_[at] = std::min(depths_[at], z); });
    }
  }

  /// Whether each triangle of a layer is seen somewhere: as near as the nearest of what is opaque.
  std::vector<bool> owners(const Layer& layer, std::size_t index) const {
    std::vector<bool> owns(layer.mesh.indices.size() / 3);
    forEach(layer, corners_[index], [&](std::size_t triangle, std::size_t at, std::int64_t z) {
      if (z <= depths_[at]) owns[triangle] = true;
    });
    return owns;
  }

 private:
  static std::int64_t rounded(double v, Chance& chance) {
    switch (chance.below(3)) {
      case 0:
        return static_cast<std::int64_t>(std::floor(v));
      case 1:
        return static_cast<std::int64_t>(std::ceil(v));
      default:
        return std::llround(v);
    }
  }

  static std::vector<Corner> placed(const Layer& layer, const View& view, Chance& chance) {
    const glm::dmat4 toClip = glm::dmat4(view.projection) * glm::dmat4(view.modelView);
    std::vector<Corner> corners;
    for (const glm::vec3& p : layer.mesh.positions) {
      const glm::dvec4 clip = toClip * glm::dvec4(glm::dvec3(p), 1);
      const glm::dvec3 at = (glm::dvec3(clip) / clip.w) * 0.5 + 0.5;
      const bool seen = clip.w > 0 && std::abs(clip.z) <= clip.w;
      corners.push_back({rounded(at.x * SIZE * UNIT, chance), rounded(at.y * SIZE * UNIT, chance), at.z, seen});
    }
    return corners;
  }

  /// Calls `visit(triangle, sample, depth)` for each sample that a triangle covers.
  template <class Visit>
  static void forEach(const Layer& layer, const std::vector<Corner>& corners, const Visit& visit) {
    const SampleGrid grid = gridOf(SIZE);
    for (std::size_t t = 0; t < layer.mesh.indices.size() / 3; ++t) {
      const Corner* c[3];
      for (std::size_t i = 0; i < 3; ++i) c[i] = &corners[layer.mesh.indices[3 * t + i]];
      if (!c[0]->seen || !c[1]->seen || !c[2]->seen) continue;
      const std::int64_t turn = (c[1]->x - c[0]->x) * (c[2]->y - c[0]->y) - (c[2]->x - c[0]->x) * (c[1]->y - c[0]->y);
      if (turn == 0 || (layer.faces != Faces::kBoth && (turn > 0) != (layer.faces == Faces::kCounterClockwise)))
        continue;
      if (turn < 0) std::swap(c[1], c[2]);
      const auto pixel = [](std::int64_t v) { return static_cast<int>(std::clamp<std::int64_t>(v / UNIT, -1, SIZE)); };
      for (int y = std::max(pixel(std::min({c[0]->y, c[1]->y, c[2]->y})) - 1, 0);
           y <= std::min(pixel(std::max({c[0]->y, c[1]->y, c[2]->y})) + 1, SIZE - 1); ++y) {
        for (int x = std::max(pixel(std::min({c[0]->x, c[1]->x, c[2]->x})) - 1, 0);
             x <= std::min(pixel(std::max({c[0]->x, c[1]->x, c[2]->x})) + 1, SIZE - 1); ++x) {
          for (int s = 0; s < SAMPLES; ++s) {
            const glm::vec2& place = grid.places[static_cast<std::size_t>(s)];
            const std::int64_t px = x * UNIT + std::lround(place.x * UNIT), py = y * UNIT + std::lround(place.y * UNIT);
            std::int64_t weights[3];
            bool inside = true;
            for (int i = 0; i < 3; ++i) {
              const Corner &u = *c[i], &v = *c[(i + 1) % 3];
              const std::int64_t dx = v.x - u.x, dy = v.y - u.y;
              weights[i] = dx * (py - u.y) - dy * (px - u.x);
              // What lies on an edge belongs to the triangle of which it is a left or a top edge.
              inside = inside && (weights[i] > 0 || (weights[i] == 0 && (dy < 0 || (dy == 0 && dx < 0))));
            }
            if (!inside) continue;
            const double whole = static_cast<double>(weights[0] + weights[1] + weights[2]);
            const double z = (static_cast<double>(weights[1]) * c[0]->z + static_cast<double>(weights[2]) * c[1]->z +
                              static_cast<double>(weights[0]) * c[2]->z) /
                             whole;
            const int sample = (y * SIZE + x) * SAMPLES + s;
            visit(t, static_cast<std::size_t>(sample), std::llround(z * ((1 << 24) - 1)));
          }
        }
      }
    }
  }

  std::vector<std::vector<Corner>> corners_;
  std::vector<std::int64_t> depths_;
};

/// A cloth of squares, folded and turned by chance.
Triangles cloth(Chance& chance, double z) {
  const int count = 3 + chance.below(24);
  const double wave = chance.between(0, 0.2), turns = chance.between(0, 12), size = chance.between(0.4, 1.6);
  Triangles mesh;
  for (int y = 0; y <= count; ++y) {
    for (int x = 0; x <= count; ++x) {
      const double u = 2.0 * x / count - 1, v = 2.0 * y / count - 1;
      mesh.positions.emplace_back(u * size, v * size, z + wave * std::sin(turns * u + v));
    }
  }
  for (int y = 0; y < count; ++y) {
    for (int x = 0; x < count; ++x) {
      const auto at = [&](int i, int j) { return static_cast<std::uint32_t>((y + j) * (count + 1) + x + i); };
      for (const auto i : {at(0, 0), at(1, 0), at(1, 1), at(0, 0), at(1, 1), at(0, 1)}) mesh.indices.push_back(i);
    }
  }
  return mesh;
}

/// Triangles of every size and shape anywhere: slivers, points, lines, corners on samples and on borders of pixels.
Triangles litter(Chance& chance, int count) {
  Triangles mesh;
  for (int i = 0; i < count; ++i) {
    const double size = std::pow(10.0, chance.between(-4, 0.5));
    glm::dvec3 corner(chance.between(-1, 1), chance.between(-1, 1), chance.between(-0.5, 0.5));
    if (chance.below(4) == 0) {
      for (int axis = 0; axis < 2; ++axis) corner[axis] = std::round(corner[axis] * SIZE * 4) / (SIZE * 4);
    }
    const int shape = chance.below(6);
    for (int k = 0; k < 3; ++k) {
      mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
      glm::dvec3 p =
          corner + size * glm::dvec3(chance.between(-1, 1), chance.between(-1, 1), chance.between(-0.3, 0.3));
      if (shape == 0) p.x = corner.x + 1e-3 * (p.x - corner.x);
      if (shape == 1) p = corner;
      mesh.positions.emplace_back(p);
    }
    if (shape == 2) mesh.indices.back() = mesh.indices.front();
  }
  return mesh;
}

View viewOf(Chance& chance) {
  if (chance.below(3) == 0) return {glm::mat4(1), glm::scale(glm::mat4(1), glm::vec3(0.9f, 0.8f, -0.5f))};
  const glm::dvec3 eye(chance.between(-2, 2), chance.between(-2, 2), chance.between(1, 4));
  const glm::dmat4 projection = glm::perspective(chance.between(0.3, 1.2), 1.0, chance.between(0.05, 0.6), 8.0);
  return {glm::mat4(glm::lookAt(eye, glm::dvec3(0), glm::dvec3(0, 1, 0))), glm::mat4(projection)};
}

std::vector<Layer> layersOf(Chance& chance) {
  std::vector<Layer> layers;
  const double gap = std::pow(10.0, chance.between(-6, -0.5));
  layers.reserve(6);
  const int cloths = 1 + chance.below(4);
  for (int i = 0; i < cloths; ++i) layers.push_back({cloth(chance, gap * i)});
  if (chance.below(3) == 0) layers.push_back(layers.front());  // in the same place
  layers.push_back({litter(chance, 60)});
  for (Layer& layer : layers) {
    layer.faces = std::array{Faces::kBoth, Faces::kBoth, Faces::kCounterClockwise, Faces::kClockwise}[chance.below(4)];
    layer.opaque = chance.below(5) > 0;
  }
  return layers;
}

struct Counts {
  std::size_t all = 0, owners = 0, kept = 0, lost = 0;
};

/// @param step  of the grid, as HiddenTriangles takes it
Counts countedOver(std::uint32_t scenes, float step) {
  Counts counts;
  for (std::uint32_t seed = 0; seed < scenes; ++seed) {
    Chance chance(seed);
    const std::vector<Layer> layers = layersOf(chance);
    const View view = viewOf(chance);
    std::vector<DrawnMesh> meshes;
    meshes.reserve(layers.size());
    for (const Layer& layer : layers) {
      meshes.push_back(
          {layer.mesh.positions, layer.mesh.indices, view.modelView, view.projection, layer.faces, layer.opaque});
    }
    SampleGrid grid = gridOf(SIZE);
    grid.step = step;
    HiddenTriangles hidden;
    hidden.look(grid, meshes, {});
    const Rasterizer truth(layers, view, chance);
    for (std::size_t i = 0; i < layers.size(); ++i) {
      std::vector<bool> kept(layers[i].mesh.indices.size() / 3);
      for (const std::uint32_t part : hidden.visible(i, {}).parts) kept[part] = true;
      const std::vector<bool> owners = truth.owners(layers[i], i);
      for (std::size_t t = 0; t < kept.size(); ++t) {
        ++counts.all;
        counts.owners += owners[t];
        counts.kept += kept[t];
        counts.lost += owners[t] && !kept[t];
      }
    }
  }
  return counts;
}

TEST(Owners, NoneIsLeftOut) {
  const Counts counts = countedOver(400, gridOf(SIZE).step);
  EXPECT_EQ(counts.lost, 0u);
  // Of what is not seen most is found. The rest lies in one place with what is in front, or is cut by the window.
  EXPECT_LT(counts.owners, counts.all / 2);
  EXPECT_GT(counts.all - counts.kept, (counts.all - counts.owners) * 3 / 4);
}

TEST(Owners, TheSameCheckSeesMarginsThatAreTooSmall) {
  EXPECT_GT(countedOver(400, 0).lost, 0u);
  EXPECT_GT(countedOver(100, -1.0f / 64).lost, 0u);
}

}  // namespace
}  // namespace telar::visibility::owners_test
