#include "surface/locate.h"

#include <algorithm>

namespace telar::surface {
namespace {

constexpr std::uint32_t FACES_PER_CANCEL_CHECK = 1 << 16;

/// Nearest point of a segment, as its part from a to b.
double nearestPart(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b) {
  const double length2 = glm::dot(b - a, b - a);
  return length2 > 0 ? std::clamp(glm::dot(p - a, b - a) / length2, 0.0, 1.0) : 0.0;
}

}  // namespace

glm::dvec3 nearestWeights(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 u = b - a, v = c - a, w = p - a;
  const double uu = glm::dot(u, u), uv = glm::dot(u, v), vv = glm::dot(v, v), wu = glm::dot(w, u), wv = glm::dot(w, v);
  const double area2 = uu * vv - uv * uv;
  if (area2 > 0) {
    const double s = (vv * wu - uv * wv) / area2, t = (uu * wv - uv * wu) / area2;
    if (s >= 0 && t >= 0 && s + t <= 1) return {1 - s - t, s, t};
  }
  // Outside, or flat: on one of the sides.
  const std::array<glm::dvec3, 3> corners{a, b, c};
  glm::dvec3 best(1, 0, 0);
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    const glm::dvec3 &from = corners[static_cast<std::size_t>(k)], &to = corners[static_cast<std::size_t>((k + 1) % 3)];
    const double part = nearestPart(p, from, to);
    const double distance = glm::distance(p, glm::mix(from, to, part));
    if (distance >= least) continue;
    least = distance;
    best = glm::dvec3(0);
    best[k] = 1 - part;
    best[(k + 1) % 3] = part;
  }
  return best;
}

Place placeAt(const Surface& surface, std::uint32_t face, const glm::dvec3& weights) {
  const Face& f = surface.faces[face];
  return {face, weights,
          weights[0] * surface.corner(f, 0) + weights[1] * surface.corner(f, 1) + weights[2] * surface.corner(f, 2), 0};
}

namespace {

/// The nearer of a place and the nearest of a face.
void approach(const Surface& surface, std::uint32_t f, const glm::dvec3& p, Place& best) {
  const Face& face = surface.faces[f];
  const glm::dvec3 &a = surface.corner(face, 0), &b = surface.corner(face, 1), &c = surface.corner(face, 2);
  // No point of the triangle is nearer than its box.
  const glm::dvec3 outside =
      glm::max(glm::max(glm::min(glm::min(a, b), c) - p, p - glm::max(glm::max(a, b), c)), glm::dvec3(0));
  if (glm::dot(outside, outside) >= best.distance * best.distance) return;
  Place place = placeAt(surface, f, nearestWeights(p, a, b, c));
  place.distance = glm::distance(place.position, p);
  if (place.distance < best.distance) best = place;
}

Place nowhere() {
  Place place;
  place.distance = std::numeric_limits<double>::infinity();
  return place;
}

}  // namespace

Place nearestPlace(const Surface& surface, const glm::dvec3& p, const CancelToken& cancel) {
  Place best = nowhere();
  for (std::uint32_t f = 0; f < surface.faces.size(); ++f) {
    if (f % FACES_PER_CANCEL_CHECK == 0) cancel.check();
    approach(surface, f, p, best);
  }
  return best;
}

Place nearestOf(const Surface& surface, const glm::dvec3& p, std::span<const std::uint32_t> faces) {
  Place best = nowhere();
  for (const std::uint32_t f : faces) approach(surface, f, p, best);
  return best;
}

}  // namespace telar::surface
