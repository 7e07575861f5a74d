#include "visibility/window_triangle.h"

#include <algorithm>
#include <cmath>

namespace telar::visibility {

TriangleBox boxOf(const WindowVertex& a, const WindowVertex& b, const WindowVertex& c, float slack, glm::ivec2 size) {
  const float lowX = std::min({a.x, b.x, c.x}) - slack, highX = std::max({a.x, b.x, c.x}) + slack;
  const float lowY = std::min({a.y, b.y, c.y}) - slack, highY = std::max({a.y, b.y, c.y}) + slack;
  // A corner that is CLIPPED may stand anywhere. Conversion cuts off towards 0, so that -1 stays below.
  const auto whole = [](float v, int end) {
    return static_cast<int>(std::clamp(v, -1.0f, static_cast<float>(end)) + 1) - 1;
  };
  return {{std::max(whole(lowX, size.x), 0), std::min(whole(highX, size.x), size.x - 1),
           std::max(whole(lowY, size.y), 0), std::min(whole(highY, size.y), size.y - 1)},
          std::min({a.z, b.z, c.z}),
          std::max({a.z, b.z, c.z})};
}

// The GL's corners p' lie within the slack s of p in x and y each. Let e be the edge function of an edge (u, v), D the
// determinant of the triangle and L the longest side of its box.
// - The determinant of p' differs from D by at most 8 s L. Where |D| is above twice that, its sign is known, and that
//   of the GL is at least half of it.
// - e and e' are linear, so that their difference at a point of a triangle is the mean of those at its corners. At u'
//   and v', e' is 0 and |e| at most m = s (|v.x - u.x| + |v.y - u.y|) + 4 s^2. So a point of p' has e >= -m: the
//   outer bound. A point of p has e' >= -m (1 - l) + (D - 8 s L) l with l = e / D, which is at least 0 where
//   e >= m D / (D - 8 s L): the inner bound.
// - Of barycentric coordinates l = e / D, each differs from that of p' by at most (10 + 8) s L / D, so that a depth of
//   p' differs from that of p at the same point by at most 27 s L / D times the range of depths. The rounding of a
//   plane that is written as a x + b y + c with an origin far off is in the slack, which has 16 roundings of the
//   target's size.
WindowTriangle::Kind makeTriangle(const WindowVertex& a, const WindowVertex& b, const WindowVertex& c, float slack,
                                  float depthSlack, Faces faces, WindowTriangle& out) {
  using Kind = WindowTriangle::Kind;
  const float x1 = b.x - a.x, y1 = b.y - a.y, x2 = c.x - a.x, y2 = c.y - a.y;
  const float determinant = x1 * y2 - x2 * y1;
  const float wide = std::max({x1, x2, 0.0f}) - std::min({x1, x2, 0.0f});
  const float high = std::max({y1, y2, 0.0f}) - std::min({y1, y2, 0.0f});
  const float off = 8 * slack * std::max(wide, high);
  const float size = std::abs(determinant);
  if (!(size > 2 * off)) return Kind::kUnsure;
  const bool counterClockwise = determinant > 0;
  if (faces != Faces::kBoth && counterClockwise != (faces == Faces::kCounterClockwise)) return Kind::kTurned;
  const float sign = counterClockwise ? 1.0f : -1.0f;
  const WindowVertex* corners[3] = {&a, &b, &c};
  for (int i = 0; i < 3; ++i) {
    const WindowVertex &u = *corners[i], &v = *corners[i == 2 ? 0 : i + 1];
    const float dx = v.x - u.x, dy = v.y - u.y;
    out.edges[i] = {-dy * sign, dx * sign, (dy * u.x - dx * u.y) * sign};
    out.margins[i] = slack * (std::abs(dx) + std::abs(dy)) + 4 * slack * slack;
  }
  out.counterClockwise = counterClockwise;
  out.inset = size / (size - off);
  const float z1 = b.z - a.z, z2 = c.z - a.z, inverse = 1 / determinant;
  const float dzdx = (z1 * y2 - z2 * y1) * inverse, dzdy = (x1 * z2 - x2 * z1) * inverse;
  out.depth = {dzdx, dzdy, a.z - dzdx * a.x - dzdy * a.y};
  const float range = std::max({z1, z2, 0.0f}) - std::min({z1, z2, 0.0f});
  out.depthSlack = depthSlack + 27.0f / 8 * off / size * range;
  return Kind::kRegular;
}

}  // namespace telar::visibility
