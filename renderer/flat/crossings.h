#pragma once
#include <array>
#include <vector>

#include "flat/view.h"

namespace telar::flat {

/// Twice the signed area of the triangle 0, a, b.
inline double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

/// Where two triangles of different parts run through one another: no edge of the mesh is there.
struct Crossing {
  /// What an end is the same as in a neighbour: an edge of the surface that goes through a face.
  struct End {
    glm::dvec3 at{0};  ///< of View::point
    std::uint32_t edge = 0, face = 0;
  };
  std::array<End, 2> ends;
  std::array<std::uint32_t, 2> faces{};
};

/// All that lie in the picture, hidden or not. Parts that share a corner are sewn there, and do not cross.
/// @throws Error{X_CANCELLED, X_TIMEOUT}
std::vector<Crossing> crossingsOf(const surface::Surface& surface, const View& view, const CancelToken& cancel);

}  // namespace telar::flat
