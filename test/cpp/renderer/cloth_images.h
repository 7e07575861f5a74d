#pragma once
#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>

#include "renderer/scenes.h"

/// Textures of cloth made in code, and a flat piece of it.
namespace telar::test {

/// @param texel stored values 0..1 at u, v of the texel's centre
inline Image8 imageOf(std::uint32_t width, std::uint32_t height,
                      const std::function<glm::vec4(double, double)>& texel) {
  Image8 image;
  image.width = width;
  image.height = height;
  for (std::uint32_t y = 0; y < height; ++y) {
    for (std::uint32_t x = 0; x < width; ++x) {
      const glm::vec4 value = glm::clamp(texel((x + 0.5) / width, (y + 0.5) / height), 0.0f, 1.0f);
      for (int c = 0; c < 4; ++c) image.pixels.push_back(static_cast<std::uint8_t>(std::lround(value[c] * 255)));
    }
  }
  return image;
}

/// A texel of a normal map. @param slope of the surface along u and v
inline glm::vec4 normalTexel(const glm::dvec2& slope) {
  return {glm::vec3(glm::normalize(glm::dvec3(slope, 1))) * 0.5f + 0.5f, 1};
}

/// Normals of yarns that cross: bumps with other slopes along u than along v.
inline Image8 weaveNormals(std::uint32_t width, std::uint32_t height, double threads, double depth) {
  return imageOf(width, height, [=](double u, double v) {
    const double x = glm::two_pi<double>() * threads * u, y = glm::two_pi<double>() * threads * v;
    return normalTexel(depth * glm::dvec2(std::sin(x), 0.5 * std::sin(y) * std::cos(x)));
  });
}

/// Normals of cloth whose yarns are uneven: slopes that spread about their mean as those of many facets do.
inline Image8 unevenNormals(std::uint32_t size, double threads, double depth) {
  return imageOf(size, size, [=](double u, double v) {
    const double x = glm::two_pi<double>() * threads * u, y = glm::two_pi<double>() * threads * v;
    const double across = std::sin(x) + std::sin(2 * x + y + 1) + std::sin(3 * x - 2 * y + 2);
    const double along = std::sin(y + 0.5) + std::sin(2 * y - x + 4) + std::sin(3 * y + 2 * x);
    return normalTexel(depth * glm::dvec2(across, along));
  });
}

/// A net: alpha 1 on threads of `width` of a mesh, white; 0 and black in its holes.
inline Image8 netImage(std::uint32_t size, double meshes, double width) {
  return imageOf(size, size, [=](double u, double v) {
    const double x = u * meshes - std::floor(u * meshes), y = v * meshes - std::floor(v * meshes);
    const bool thread = x < width || y < width;
    return thread ? glm::vec4(1) : glm::vec4(0);
  });
}

/// A square of 2 x 2 m that faces +Z, its texture repeated.
inline Primitive squareCloth(float repeats) {
  Primitive p;
  p.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  p.normals.assign(4, glm::vec3(0, 0, 1));
  p.tangents.assign(4, glm::vec4(1, 0, 0, 1));
  p.uvs[0] = {{0, repeats}, {repeats, repeats}, {repeats, 0}, {0, 0}};
  p.indices = {0, 1, 2, 0, 2, 3};
  for (const glm::vec3& v : p.positions) p.bounds.add(glm::dvec3(v));
  return p;
}

/// A square shot from +Z without perspective. @param height metres that the picture shows
inline Shot flatShot(int size, double height) {
  Shot shot = shotOf(size);
  shot.camera.projection = Projection::kOrthographic;
  shot.camera.height = height;
  shot.shading = ShadingModel::kFabric;
  return shot;
}

}  // namespace telar::test
