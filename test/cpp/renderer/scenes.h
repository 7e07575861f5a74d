#pragma once
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <memory>

#include "telar/renderer.h"

/// Small scenes and shots made in code.
namespace telar::test {

inline Primitive spherePrimitive(float radius, int rings = 64) {
  Primitive p;
  const int columns = rings * 2;
  for (int y = 0; y <= rings; ++y) {
    for (int x = 0; x <= columns; ++x) {
      const float theta = glm::pi<float>() * static_cast<float>(y) / static_cast<float>(rings);
      const float phi = glm::two_pi<float>() * static_cast<float>(x) / static_cast<float>(columns);
      const glm::vec3 n(std::sin(theta) * std::sin(phi), std::cos(theta), std::sin(theta) * std::cos(phi));
      p.positions.push_back(n * radius);
      p.normals.push_back(n);
      p.uvs[0].push_back(
          {static_cast<float>(x) / static_cast<float>(columns), static_cast<float>(y) / static_cast<float>(rings)});
    }
  }
  const auto at = [&](int x, int y) { return static_cast<std::uint32_t>(y * (columns + 1) + x); };
  for (int y = 0; y < rings; ++y) {
    for (int x = 0; x < columns; ++x) {
      for (const std::uint32_t i : {at(x, y), at(x, y + 1), at(x + 1, y), at(x + 1, y), at(x, y + 1), at(x + 1, y + 1)})
        p.indices.push_back(i);
    }
  }
  for (const glm::vec3& v : p.positions) p.bounds.add(glm::dvec3(v));
  return p;
}

/// One mesh at the origin with one material.
/// A square of edge 4 m that faces the camera of shotOf(), `count` times in one place.
inline Primitive stackedSquares(std::uint32_t count) {
  Primitive p;
  for (const auto& [x, y] : {std::pair(-2.f, -2.f), {2.f, -2.f}, {2.f, 2.f}, {-2.f, 2.f}}) {
    p.positions.push_back({x, y, 0});
    p.normals.push_back({0, 0, 1});
    p.bounds.add(glm::dvec3(p.positions.back()));
  }
  for (std::uint32_t i = 0; i < count; ++i) p.indices.insert(p.indices.end(), {0, 1, 2, 0, 2, 3});
  return p;
}

inline std::shared_ptr<Scene> sceneOf(Primitive primitive, Material material = {}) {
  auto scene = std::make_shared<Scene>();
  primitive.material = 0;
  scene->bounds = primitive.bounds;
  scene->materials.push_back(std::move(material));
  scene->meshes.push_back({"mesh", {std::move(primitive)}});
  Node node;
  node.mesh = 0;
  scene->nodes.push_back(node);
  return scene;
}

/// A square shot that looks at a unit sphere from +Z.
inline Shot shotOf(int size) {
  Shot shot;
  shot.width = shot.height = size;
  shot.camera.position = {0, 0, 5};
  shot.camera.fovY = 30;
  shot.camera.near = 3;
  shot.camera.far = 7;
  shot.toneMapping = ToneMapping::kNone;
  shot.output.format = OutputOptions::Format::kRaw;
  return shot;
}

/// A light that casts a shadow of everything within 3 m of the origin.
inline Shot::Light casting(Shot::Light::Type type, const glm::dvec3& position, int mapSize = 256) {
  Shot::Light light{type};
  light.position = position;
  light.intensity = type == Shot::Light::Type::kDirectional ? 2 : 20;
  light.angle = 0.7;
  light.castShadow = true;
  light.shadow = {mapSize, 1, 1, -0.002, 0.02, 0.5, 10, -3, 3, -3, 3, 1};
  return light;
}

inline const float* pixelF(const Frame& frame, std::uint32_t x, std::uint32_t y) {
  return reinterpret_cast<const float*>(frame.pixels.data()) + (static_cast<std::size_t>(y) * frame.width + x) * 4;
}

inline const std::uint8_t* pixel8(const Frame& frame, std::uint32_t x, std::uint32_t y) {
  return reinterpret_cast<const std::uint8_t*>(frame.pixels.data()) +
         (static_cast<std::size_t>(y) * frame.width + x) * 4;
}

}  // namespace telar::test
