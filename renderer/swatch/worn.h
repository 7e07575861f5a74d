#pragma once
#include <array>
#include <cmath>
#include <glm/glm.hpp>

#include "surface/surface.h"

namespace telar::swatch {

/// How a garment wears one of its materials.
struct Worn {
  struct Coordinates {
    double area = 0;       ///< square metres of the triangles that have such coordinates
    double turned = 0;     ///< the same, negative where the texture is mirrored
    glm::dvec2 metres{0};  ///< over which u and v grow by 1, times area
    /// What u and v grow by in a metre; 0 = there are none.
    glm::dvec2 density() const { return area > 0 ? area / metres : glm::dvec2(0); }
  };
  int material = -1;
  double area = 0;                         ///< square metres
  std::array<Coordinates, 2> coordinates;  ///< by set
  glm::dvec4 color{0};                     ///< of the vertices, times area
};

using Corners = std::array<std::uint32_t, 3>;

const Primitive& primitiveOf(const Scene& scene, const surface::Source& source);

/// Vertices of a face in its primitive.
Corners cornersOf(const Primitive& primitive, const surface::Face& face);

/// The material that covers most of a surface. @pre the surface has faces
Worn mostWorn(const Scene& scene, const surface::Surface& surface, const CancelToken& cancel);

}  // namespace telar::swatch
