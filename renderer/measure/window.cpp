#include "measure/window.h"

#include <algorithm>
#include <cmath>

namespace telar::measure {
namespace {

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

/// How far from an end, the image at distance x along the edge and r away, the way over that end is the nearer one:
/// |image - t| >= t + lead has the solution t <= (r^2 - lead^2) / (2 (x + lead)).
/// @param lead  distance of the end, less that to where the lines start
double nearerBy(double x, double r, double lead, double length) {
  if (lead >= r) return 0;
  if (x + lead <= 0) return length;
  return std::max(0.0, (r * r - lead * lead) / (2 * (x + lead)));
}

/// Where the line from `image` through (at, 0) meets the side from `base` to `apex`: metres from base.
double meet(const glm::dvec2& image, double at, const glm::dvec2& base, const glm::dvec2& apex) {
  const glm::dvec2 direction = glm::dvec2(at, 0) - image, side = apex - base;
  const double length = glm::length(side), denominator = cross(direction, side);
  if (denominator == 0) return length;
  return std::clamp(cross(direction, image - base) / denominator, 0.0, 1.0) * length;
}

}  // namespace

bool cutByEnds(Window& window, double length, double distanceA, double distanceB) {
  const glm::dvec2 image = window.image;
  window.begin = std::max(window.begin, nearerBy(image.x, glm::length(image), distanceA - window.before, length));
  const double fromB =
      nearerBy(length - image.x, glm::distance(image, glm::dvec2(length, 0)), distanceB - window.before, length);
  window.end = std::min(window.end, length - fromB);
  return window.begin < window.end;
}

Children childrenOf(const Window& window, const EdgeFrame& frame) {
  const glm::dvec2 a(0), b(frame.length, 0), image = window.image;
  const double middle = window.crossing(frame.apex);
  const double sideA = glm::length(frame.apex), sideB = glm::distance(frame.apex, b);
  Children out{window, window};
  out.fromA.begin = out.fromA.end = out.fromB.begin = out.fromB.end = 0;
  if (sideA > 0 && window.begin < middle) {
    out.fromA.begin = window.begin <= 0 ? 0 : meet(image, window.begin, a, frame.apex);
    out.fromA.end = middle <= window.end ? sideA : meet(image, window.end, a, frame.apex);
    const glm::dvec2 u = frame.apex / sideA;
    out.fromA.image = {glm::dot(image, u), std::min(0.0, cross(u, image))};
  }
  if (sideB > 0 && window.end > middle) {
    out.fromB.begin = window.end >= frame.length ? 0 : meet(image, window.end, b, frame.apex);
    out.fromB.end = middle >= window.begin ? sideB : meet(image, window.begin, b, frame.apex);
    const glm::dvec2 u = (frame.apex - b) / sideB;
    out.fromB.image = {glm::dot(image - b, u), std::min(0.0, -cross(u, image - b))};
  }
  return out;
}

void turn(Window& window, double length) {
  const double begin = window.begin;
  window.begin = length - window.end;
  window.end = length - begin;
  window.image.x = length - window.image.x;
}

}  // namespace telar::measure
