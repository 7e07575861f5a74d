#include "measure/loops.h"

#include <algorithm>
#include <array>
#include <limits>

#include "surface/chain.h"

namespace telar::measure {
namespace {

using surface::Surface;

constexpr std::uint32_t FACES_PER_CANCEL_CHECK = 1 << 16;
/// Places of a loop that is drawn tight: the ways between every second are a quarter of it, so that each is the
/// shortest way between its ends on its own side of the part.
constexpr std::size_t PLACES = 8;
constexpr int ROUNDS_MAX = 200;
/// A round that shortens by less ends it. What is left is a few times that.
constexpr double SETTLED = 1e-6;
/// No way is known yet.
constexpr double UNKNOWN = std::numeric_limits<double>::infinity();
/// Part of its length below which a loop is on its way to a point.
constexpr double VANISHED = 1e-2;

std::vector<Loop> loopsOf(const std::vector<std::array<std::uint32_t, 2>>& links,
                          const std::vector<glm::dvec3>& points) {
  std::vector<Loop> loops;
  for (const surface::Chain& chain : surface::chainLinks(links)) {
    Loop& loop = loops.emplace_back();
    loop.closed = chain.closed;
    for (const std::uint32_t node : chain.nodes) loop.points.push_back(points[node]);
  }
  return loops;
}

/// The point so far along a line of points.
glm::dvec3 along(const std::vector<glm::dvec3>& points, double length) {
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double step = glm::distance(points[i - 1], points[i]);
    if (length <= step && step > 0) return glm::mix(points[i - 1], points[i], length / step);
    length -= step;
  }
  return points.back();
}

}  // namespace

double Loop::length() const {
  double sum = closed ? glm::distance(points.back(), points.front()) : 0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += glm::distance(points[i - 1], points[i]);
  return sum;
}

double Loop::distanceTo(const glm::dvec3& p) const {
  double least = glm::distance(p, points.front());
  for (std::size_t i = closed ? 0 : 1; i < points.size(); ++i) {
    const glm::dvec3 &a = points[i == 0 ? points.size() - 1 : i - 1], &b = points[i];
    const double length2 = glm::dot(b - a, b - a);
    const double part = length2 > 0 ? std::clamp(glm::dot(p - a, b - a) / length2, 0.0, 1.0) : 0.0;
    least = std::min(least, glm::distance(p, glm::mix(a, b, part)));
  }
  return least;
}

std::vector<Loop> sectionOf(const Surface& surface, const glm::dvec3& point, const glm::dvec3& normal,
                            const CancelToken& cancel) {
  const auto height = [&](std::uint32_t p) { return glm::dot(surface.points[p] - point, normal); };
  std::vector<std::uint32_t> crossing(surface.edges.size(), surface::NONE);
  std::vector<glm::dvec3> points;
  for (std::size_t e = 0; e < surface.edges.size(); ++e) {
    const double a = height(surface.edges[e].a), b = height(surface.edges[e].b);
    if ((a >= 0) == (b >= 0)) continue;
    crossing[e] = static_cast<std::uint32_t>(points.size());
    points.push_back(glm::mix(surface.points[surface.edges[e].a], surface.points[surface.edges[e].b], a / (a - b)));
  }
  std::vector<std::array<std::uint32_t, 2>> links;
  for (std::uint32_t f = 0; f < surface.faces.size(); ++f) {
    if (f % FACES_PER_CANCEL_CHECK == 0) cancel.check();
    std::vector<std::uint32_t> cut;
    for (const std::uint32_t e : surface.faces[f].edges) {
      if (crossing[e] != surface::NONE) cut.push_back(crossing[e]);
    }
    if (cut.size() == 2) links.push_back({cut[0], cut[1]});
  }
  return loopsOf(links, points);
}

std::vector<Loop> borderOf(const Surface& surface) {
  std::vector<std::array<std::uint32_t, 2>> links;
  for (const surface::Edge& edge : surface.edges) {
    if (edge.count == 1) links.push_back({edge.a, edge.b});
  }
  return loopsOf(links, surface.points);
}

Loop tightened(const Surface& surface, const Loop& loop, const CancelToken& cancel) {
  std::vector<glm::dvec3> closed = loop.points;
  closed.push_back(loop.points.front());
  const double whole = loop.length();
  std::vector<surface::Place> places;
  for (std::size_t i = 0; i < PLACES; ++i) {
    places.push_back(nearestPlace(surface, along(closed, whole * static_cast<double>(i) / PLACES), cancel));
  }
  Geodesic geodesic(surface, cancel);
  const auto way = [&](std::size_t from, std::size_t to, double known = UNKNOWN) {
    const auto path = geodesic.between(places[from % PLACES], places[to % PLACES], known);
    if (!path) throw Error("E_MEASURE", "no way over the surface joins the loop");
    return *path;
  };
  std::array<double, PLACES> halves;  // of the way that each place is the middle of
  halves.fill(UNKNOWN);
  double before = whole;
  for (int round = 0; round < ROUNDS_MAX; ++round) {
    double length = 0;
    for (std::size_t i = 0; i < PLACES; ++i) {
      const std::size_t middle = (2 * i + 1 + (i >= PLACES / 2 ? 1 : 0)) % PLACES;  // odd ones, then even ones
      const std::size_t last = (middle + PLACES - 1) % PLACES, next = (middle + 1) % PLACES;
      const Path path = way(last, next, halves[last] + halves[next]);
      halves[middle] = path.length / 2;
      places[middle] = nearestPlace(surface, along(path.points, path.length / 2), cancel);
      if (i >= PLACES / 2) length += path.length;
    }
    if (length < VANISHED * whole) {
      throw Error("E_MEASURE",
                  "the loop cannot be drawn tight: it slips off the part, or through where the option join closes it")
          .at("/girth");
    }
    if (length >= before * (1 - SETTLED)) break;
    before = length;
  }
  Loop out{{}, true};
  for (std::size_t i = 0; i < PLACES; ++i) {
    const Path path = way(i, i + 1);
    out.points.insert(out.points.end(), path.points.begin(), path.points.end() - 1);
  }
  return out;
}

}  // namespace telar::measure
