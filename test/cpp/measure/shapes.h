#pragma once
#include <cmath>
#include <functional>
#include <glm/glm.hpp>
#include <numbers>
#include <random>

#include "telar/scene.h"

namespace telar::test {

/// A scene of one node with one primitive of triangles.
inline Scene sceneOf(std::vector<glm::vec3> positions, std::vector<std::uint32_t> indices,
                     const glm::dmat4& world = glm::dmat4(1)) {
  Primitive primitive;
  primitive.positions = std::move(positions);
  primitive.indices = std::move(indices);
  for (const glm::vec3& p : primitive.positions) primitive.bounds.add(glm::dvec3(p));
  Scene scene;
  scene.meshes.push_back({"mesh", {primitive}});
  Node node;
  node.name = "part";
  node.mesh = node.file.mesh = 0;
  node.file.node = 0;
  node.world = node.local = world;
  scene.nodes.push_back(node);
  return scene;
}

/// A sheet of `columns` x `rows` quads over the unit square, bent by `shape(u, v)`. Its inner corners are moved in u
/// and v by up to `disorder` of a quad, and diagonals go either way: triangles are bad, the sheet's border stays.
inline Scene sheet(int columns, int rows, double disorder, const std::function<glm::dvec3(double, double)>& shape) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> shift(-disorder, disorder);
  std::vector<glm::vec3> positions;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) {
      const bool inside = i > 0 && i < columns && j > 0 && j < rows;
      const double du = inside ? shift(random) : 0, dv = inside ? shift(random) : 0;
      positions.emplace_back(shape((i + du) / columns, (j + dv) / rows));
    }
  }
  std::vector<std::uint32_t> indices;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const auto a = static_cast<std::uint32_t>(j * (columns + 1) + i), b = a + 1,
                 c = a + static_cast<std::uint32_t>(columns) + 1, d = c + 1;
      const bool other = disorder > 0 && random() % 2 == 0;
      for (const std::uint32_t index : other ? std::array{a, b, c, b, d, c} : std::array{a, b, d, a, d, c})
        indices.push_back(index);
    }
  }
  return sceneOf(std::move(positions), std::move(indices));
}

/// A unit sphere of rings: triangles become slivers at the poles.
inline Scene sphere(int around, int rings) {
  return sheet(around, rings, 0, [](double u, double v) {
    const double phi = 2 * std::numbers::pi * u, theta = std::numbers::pi * v;
    return glm::dvec3(std::sin(theta) * std::cos(phi), std::cos(theta), -std::sin(theta) * std::sin(phi));
  });
}

}  // namespace telar::test
