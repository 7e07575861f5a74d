#pragma once
#include <optional>

#include "visibility/window_vertices.h"

namespace telar::visibility {

/// Which faces a draw shows, by the winding of their corners in the window.
enum class Faces { kBoth, kCounterClockwise, kClockwise };

/// Pixels from..to, the last included; none where a `from` is above its `to`.
struct Pixels {
  int fromX, toX, fromY, toY;
};

/// @pre  they are some
inline double countOf(const Pixels& p) { return static_cast<double>(p.toX - p.fromX + 1) * (p.toY - p.fromY + 1); }

/// a x + b y + c, in pixels.
struct Plane {
  float a, b, c;
  float at(const glm::vec2& p) const { return a * p.x + b * p.y + c; }
};

/// A triangle in the window, and where the GL may see it.
struct WindowTriangle {
  Plane edges[3];    ///< twice the area of the corner p and an edge, positive inside
  float margins[3];  ///< by which the GL's value may differ, there and for what is inside
  float inset;       ///< what the margins are multiplied with for what is certainly inside
  bool counterClockwise;
  Plane depth;
  float depthSlack;  ///< by which the GL's depth may differ at what it covers
  Pixels pixels;     ///< with a sample that may be covered

  enum class Kind {
    kRegular,  ///< it has all that stands above
    kTurned,   ///< it shows a face that the draw leaves out
    kUnsure,   ///< so small, so thin or so far outside the window that nothing is known but that it may be seen
  };
};

/// Position of a triangle's corners, its least and its largest depth and the pixels with a sample that it may cover.
struct TriangleBox {
  Pixels pixels;
  float nearest, farthest;
};

/// @pre  no corner is UNPROJECTED
TriangleBox boxOf(const WindowVertex& a, const WindowVertex& b, const WindowVertex& c, float slack, glm::ivec2 size);

/// @param slack, depthSlack  of the vertices    @pre  no corner is UNPROJECTED or CLIPPED
WindowTriangle::Kind makeTriangle(const WindowVertex& a, const WindowVertex& b, const WindowVertex& c, float slack,
                                  float depthSlack, Faces faces, WindowTriangle& out);

}  // namespace telar::visibility
