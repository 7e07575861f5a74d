#include "measure/loops.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "measure/branches.h"
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
/// Half the width of the strip along a loop that most rounds keep to, as part of the loop.
constexpr double STRIP = 0.01;
/// Rounds that keep to one strip: a loop moves little in each.
constexpr int STRIP_ROUNDS = 4;
/// Metres from a face, by part of the loop, within which a point of a way lies on it.
constexpr double ON_FACE = 1e-9;
/// Metres from a plane, by part of the surface's extent, within which a corner lies in it: as far as corners that are one may lie apart.
constexpr double IN_PLANE = 1e-6;
/// Part of its length below which a loop is on its way to a point.
constexpr double VANISHED = 1e-2;

std::vector<Loop> loopsOf(const std::vector<std::array<std::uint32_t, 2>>& links, const std::vector<glm::dvec3>& points,
                          const CancelToken& cancel) {
  std::vector<Loop> loops;
  for (const surface::Chain& chain : surface::chainLinks(links, cancel)) {
    Loop& loop = loops.emplace_back();
    loop.closed = chain.closed;
    for (const std::uint32_t node : chain.nodes) loop.points.push_back(points[node]);
  }
  return loops;
}

/// The direction in which a plane goes on from a side of a face into it.
glm::dvec3 intoFace(const Surface& surface, const surface::Face& face, std::size_t side, const glm::dvec3& normal) {
  const auto at = [&](std::size_t k) { return surface.corner(face, static_cast<int>(side + k)); };
  const glm::dvec3 along = at(1) - at(0), toApex = at(2) - at(0);
  const glm::dvec3 way = glm::cross(glm::cross(along, toApex), normal);
  // Towards the apex, across the side.
  const double across = glm::dot(way, toApex * glm::dot(along, along) - along * glm::dot(along, toApex));
  return across < 0 ? -way : way;
}

/// Where a plane crosses edges, and the loops that this makes.
class Section {
 public:
  Section(const Surface& surface, const glm::dvec3& normal, const CancelToken& cancel)
      : surface_(surface), cancel_(cancel), normal_(normal), crossing_(surface.edges.size(), surface::NONE) {}

  void cross(std::size_t edge, const glm::dvec3& at) {
    crossing_[edge] = static_cast<std::uint32_t>(points_.size());
    points_.push_back(at);
  }

  std::vector<Loop> loops() {
    if (points_.empty()) return {};
    std::vector<Cut> cuts;
    for (std::uint32_t f = 0; f < surface_.faces.size(); ++f) {
      if (f % FACES_PER_CANCEL_CHECK == 0) cancel_.check();
      const surface::Face& face = surface_.faces[f];
      std::vector<std::size_t> cut;  // sides of the face
      for (std::size_t side = 0; side < 3; ++side) {
        if (crossing_[face.edges[side]] != surface::NONE) cut.push_back(side);
      }
      if (cut.size() != 2) continue;
      cuts.push_back({{crossing_[face.edges[cut[0]]], crossing_[face.edges[cut[1]]]},
                      {intoFace(surface_, face, cut[0], normal_), intoFace(surface_, face, cut[1], normal_)},
                      face.source});
    }
    partBranches(cuts, points_, surface_.sources, cancel_);
    std::vector<std::array<std::uint32_t, 2>> links;
    links.reserve(cuts.size());
    for (const Cut& cut : cuts) links.push_back(cut.crossings);
    return loopsOf(links, points_, cancel_);
  }

 private:
  const Surface& surface_;
  const CancelToken& cancel_;
  glm::dvec3 normal_;
  std::vector<std::uint32_t> crossing_;  ///< of each edge
  std::vector<glm::dvec3> points_;
};

/// Metres of each point above the plane; 0 of what lies in it but for rounding, which would cut a hem here and there.
std::vector<double> heightsOf(const Surface& surface, const glm::dvec3& point, const glm::dvec3& normal) {
  const double rounding = IN_PLANE * glm::distance(surface.bounds.min, surface.bounds.max);
  std::vector<double> heights;
  heights.reserve(surface.points.size());
  for (const glm::dvec3& p : surface.points) {
    const double height = glm::dot(p - point, normal);
    heights.push_back(std::abs(height) <= rounding ? 0 : height);
  }
  return heights;
}

/// Points in the plane that are not part of the cut of those below it, nor joined to it in the plane: where the surface ends in the
/// plane, or comes back from it, from above.
std::vector<bool> touchingPoints(const Surface& surface, const std::vector<double>& heights) {
  std::vector<bool> touching(heights.size());
  for (std::size_t p = 0; p < heights.size(); ++p) touching[p] = heights[p] == 0;
  std::vector<std::uint32_t> known;
  const auto know = [&](std::uint32_t p) {
    if (touching[p]) touching[p] = false, known.push_back(p);
  };
  for (const surface::Edge& edge : surface.edges) {
    if (heights[edge.a] < 0) know(edge.b);
    if (heights[edge.b] < 0) know(edge.a);
  }
  while (!known.empty()) {
    const std::uint32_t last = known.back();
    known.pop_back();
    for (const std::uint32_t f : surface.facesAt(last)) {
      for (const std::uint32_t p : surface.faces[f].points) know(p);
    }
  }
  return touching;
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

/// The points of the surface that are near to a loop.
std::vector<char> stripAlong(const Surface& surface, const Loop& loop, double reach) {
  Bounds bounds;
  for (const glm::dvec3& p : loop.points) bounds.add(p);
  std::vector<char> within(surface.points.size());
  for (std::size_t i = 0; i < within.size(); ++i) {
    const glm::dvec3& p = surface.points[i];
    const glm::dvec3 outside = glm::max(glm::max(bounds.min - p, p - bounds.max), glm::dvec3(0));
    within[i] = glm::dot(outside, outside) <= reach * reach && loop.distanceTo(p) <= reach ? 1 : 0;
  }
  return within;
}

/// A loop on its way to a tight one: places of it, of which every second moves at a time.
class Tightening {
 public:
  Tightening(const Surface& surface, const Loop& loop, const CancelToken& cancel)
      : surface_(surface), cancel_(cancel), geodesic_(surface, cancel), whole_(loop.length()), line_(loop) {
    std::vector<glm::dvec3> closed = loop.points;
    closed.push_back(loop.points.front());
    for (std::size_t i = 0; i < PLACES; ++i) {
      const double at = whole_ * static_cast<double>(i) / PLACES;
      places_.push_back(nearestPlace(surface, along(closed, at), cancel));
    }
    halves_.fill(whole_ / PLACES);
  }

  Loop settle() {
    // Rounds that keep to a strip along the loop cost a fraction of the others, one of which has the last word.
    bool confined = true;
    int age = STRIP_ROUNDS;
    double before = whole_;
    for (int i = 0; i < ROUNDS_MAX; ++i) {
      if (!confined || age >= STRIP_ROUNDS)
        keepTo(confined ? stripAlong(surface_, line_, STRIP * whole_) : std::vector<char>());
      age = confined ? age % STRIP_ROUNDS + 1 : STRIP_ROUNDS;
      const double length = round();
      if (length < VANISHED * whole_) {
        throw Error("E_MEASURE",
                    "the loop cannot be drawn tight: it slips off the part, or through where the option join closes it")
            .at("/girth");
      }
      const bool settled = length >= before * (1 - SETTLED);
      if (settled && !confined) break;
      confined = !settled;
      before = length;
    }
    return line_;
  }

 private:
  /// Ways keep to these points, and places are looked for around them; none = to all of the surface.
  void keepTo(std::vector<char> within) {
    faces_.clear();
    for (std::uint32_t f = 0; f < surface_.faces.size() && !within.empty(); ++f) {
      const auto& points = surface_.faces[f].points;
      if (std::any_of(points.begin(), points.end(), [&](std::uint32_t p) { return within[p] != 0; }))
        faces_.push_back(f);
    }
    geodesic_.confine(std::move(within));
  }

  /// The place of a point of a way.
  surface::Place placeOf(const glm::dvec3& p) const {
    const surface::Place near = nearestOf(surface_, p, faces_);
    return near.distance <= ON_FACE * whole_ ? near : nearestPlace(surface_, p, cancel_);
  }

  /// Moves each place once. @return metres
  double round() {
    line_ = {{}, true};
    double length = 0;
    for (std::size_t i = 0; i < PLACES; ++i) {
      const std::size_t middle = (2 * i + 1 + (i >= PLACES / 2 ? 1 : 0)) % PLACES;  // odd ones, then even ones
      const std::size_t last = (middle + PLACES - 1) % PLACES, next = (middle + 1) % PLACES;
      const Path path = way(last, next, halves_[last] + halves_[next]);
      halves_[middle] = path.length / 2;
      places_[middle] = placeOf(along(path.points, path.length / 2));
      if (i < PLACES / 2) continue;
      length += path.length;
      append(line_, path);
    }
    return length;
  }

  Path way(std::size_t from, std::size_t to, double known) {
    auto path = geodesic_.between(places_[from], places_[to], known);
    if (!path) {
      // The strip of a coarse mesh may hold no such way: never the way around the other side of the loop.
      geodesic_.confine({});
      path = geodesic_.between(places_[from], places_[to]);
    }
    if (!path) throw Error("E_MEASURE", "no way over the surface joins the loop");
    return *path;
  }

  static void append(Loop& loop, const Path& path) {
    loop.points.insert(loop.points.end(), path.points.begin(), path.points.end() - 1);
  }

  const Surface& surface_;
  const CancelToken& cancel_;
  Geodesic geodesic_;
  double whole_;  ///< metres, of the loop as it was given
  Loop line_;     ///< of the last round
  std::vector<surface::Place> places_;
  std::vector<std::uint32_t> faces_;     ///< that have a corner in the strip
  std::array<double, PLACES> halves_{};  ///< metres of a way from each place to one beside it
};

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
  const std::vector<double> heights = heightsOf(surface, point, normal);
  Section section(surface, normal, cancel);
  for (std::size_t e = 0; e < surface.edges.size(); ++e) {
    const surface::Edge& edge = surface.edges[e];
    const double a = heights[edge.a], b = heights[edge.b];
    if ((a >= 0) == (b >= 0)) continue;
    section.cross(e, glm::mix(surface.points[edge.a], surface.points[edge.b], a / (a - b)));
  }
  std::vector<Loop> loops = section.loops();
  const std::vector<bool> touching = touchingPoints(surface, heights);
  Section end(surface, normal, cancel);
  for (std::size_t e = 0; e < surface.edges.size(); ++e) {
    const surface::Edge& edge = surface.edges[e];
    if (touching[edge.a] && heights[edge.b] != 0) end.cross(e, surface.points[edge.a]);
    if (touching[edge.b] && heights[edge.a] != 0) end.cross(e, surface.points[edge.b]);
  }
  // What touches the plane in a corner alone has no length there.
  for (Loop& loop : end.loops()) {
    if (loop.length() > 0) loops.push_back(std::move(loop));
  }
  return loops;
}

std::vector<Loop> borderOf(const Surface& surface, const CancelToken& cancel) {
  std::vector<std::array<std::uint32_t, 2>> links;
  for (const surface::Edge& edge : surface.edges) {
    if (edge.count == 1) links.push_back({edge.a, edge.b});
  }
  return loopsOf(links, surface.points, cancel);
}

Loop tightened(const Surface& surface, const Loop& loop, const CancelToken& cancel) {
  return Tightening(surface, loop, cancel).settle();
}

}  // namespace telar::measure
