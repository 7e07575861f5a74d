#pragma once
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>

#include "visibility/shading_quads.h"
#include "visibility/triangle_setup.h"

namespace telar::visibility {

/// Where the texels of fragments lie. Those of four fragments that are shaded together come one layer after the other,
/// the fours of a block of 4 x 4 fragments too, and blocks row by row: each cache line is read once.
struct FragmentTexels {
  float* texels = nullptr;  ///< four floats each
  std::size_t width = 0;    ///< fragments of a row
  std::size_t layers = 0;   ///< texels of a fragment
  float* of(const glm::uvec2& at, std::size_t layer) const {
    const std::size_t block = (at.y / 4) * (width / 4) + at.x / 4;
    const std::size_t quad = block * 4 + (at.y & 2) + (at.x / 2 & 1);
    return texels + ((quad * layers + layer) * 4 + (at.y & 1) * 2 + (at.x & 1)) * 4;
  }
};

/// Place in the window of one in clip space, as llvmpipe (Mesa 22.3) computes it. @param size  px
glm::vec3 windowPlace(const float* clip, float overW, const glm::vec2& size, bool fused);

/// Mixes the varyings of triangles at the centres of pixels, in perspective, as llvmpipe does.
class VaryingMixer {
 public:
  static constexpr std::size_t MOST = 24;  ///< texels of a fragment

  /// Texels of a fragment, of which each has four varyings.
  struct Layers {
    std::size_t first = 0, count = MOST;
  };
  /// @param offset  of the grid
  /// @param layers  that are written, as many as there are
  VaryingMixer(const PlacedMesh& mesh, const WindowVertices& vertices, float offset, Layers layers)
      : mesh_(mesh),
        vertices_(vertices),
        offset_(offset),
        centre_(0.5f - offset),
        fused_(fusesProducts()),
        layers_(layers) {}
  VaryingMixer(const PlacedMesh& mesh, const WindowVertices& vertices, float offset)
      : VaryingMixer(mesh, vertices, offset, {0, MOST}) {}
  /// Four fragments. Of quads of one triangle one after the other, the triangle is set up once.
  /// @param at  texel of the first of them
  void mix(const ShadingQuad& quad, const FragmentTexels& out, const glm::uvec2& at);

 private:
  using Plane4 = LinearPlane<Lanes>;

  const PlacedMesh& mesh_;
  const WindowVertices& vertices_;
  float offset_, centre_;  ///< centre: of a pixel, less the offset
  bool fused_;
  Layers layers_;
  Owner setUp_ = NO_OWNER;  ///< triangle that the planes are of
  std::size_t count_ = 0;
  Plane4 overW_{};
  std::array<Plane4, MOST> planes_;

  void setUp(Owner owner);
  template <class Rounding>
  void mixPixels(const ShadingQuad& quad, unsigned from, unsigned to, const FragmentTexels& out,
                 const glm::uvec2& at) const;
  void mixFused(const ShadingQuad& quad, unsigned from, unsigned to, const FragmentTexels& out,
                const glm::uvec2& at) const;
};

/// How far apart fragments that are shaded together are in a varying of two components, as texture coordinates are.
class VaryingSteps {
 public:
  /// @param offset  of the grid
  /// @param component  first of the two
  VaryingSteps(const PlacedMesh& mesh, const WindowVertices& vertices, float offset, std::size_t component)
      : mixer_(mesh, vertices, offset, {component / 4, (component + 1) / 4 - component / 4 + 1}),
        first_(component % 4) {}
  /// The larger one of the steps across and up, of each component. A GL takes the steps from any two of the four.
  glm::vec2 of(const ShadingQuad& quad);

 private:
  static constexpr std::size_t WIDTH = 4, LAYERS = 2, PIXELS = 4;

  VaryingMixer mixer_;
  std::size_t first_;
  std::array<float, PIXELS * LAYERS * 4> texels_{};
};

}  // namespace telar::visibility
