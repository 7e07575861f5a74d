#pragma once
#include <cstdint>
#include <glm/glm.hpp>

#include "surface/surface.h"

namespace telar::measure {

/// An edge and the third corner of one of its faces, laid flat: the edge's a at (0, 0), its b at (length, 0), the
/// corner above.
struct EdgeFrame {
  double length = 0;
  glm::dvec2 apex{0};
};

/// Straight lines that cross an edge between two places, all from one point.
struct Window {
  std::uint32_t edge = 0;
  std::uint32_t from = 0;                ///< face that they come out of
  std::uint32_t parent = surface::NONE;  ///< window that they came through before
  std::uint32_t corner = surface::NONE;  ///< that they started at; NONE = where the whole way starts
  double begin = 0, end = 0;             ///< metres from the edge's a
  glm::dvec2 image{0};                   ///< of where they started, laid flat with the edge: y <= 0
  double before = 0;                     ///< metres to where they started

  double distanceTo(const glm::dvec2& p) const { return before + glm::distance(image, p); }
  /// Where the line to p crosses the edge.
  double crossing(const glm::dvec2& p) const {
    const double height = p.y - image.y;
    return height > 0 ? image.x - image.y * (p.x - image.x) / height : p.x;
  }
};

/// Cuts off what is nearer by way of an end of the edge. @return whether anything is left
bool cutByEnds(Window& window, double length, double distanceA, double distanceB);

/// The parts of a window on the two other sides of the face that it leads into: first on the side from the edge's a to
/// the apex, measured from a, then on the one from b, measured from b. Empty where begin >= end.
struct Children {
  Window fromA, fromB;
};
Children childrenOf(const Window& window, const EdgeFrame& frame);

/// The same window seen from the other end of its edge.
void turn(Window& window, double length);

}  // namespace telar::measure
