#include "measure/geodesic.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace telar::measure {
namespace {

using surface::Edge;
using surface::Face;
using surface::Surface;

constexpr double INF = std::numeric_limits<double>::infinity();
constexpr std::size_t EVENTS_PER_CANCEL_CHECK = 1 << 10;
/// Barycentric weight below which a place is on the side or the corner: a thousandth of a micrometre on a metre.
constexpr double ON_SIDE = 1e-9;
/// Part of an edge by which a line may miss a window: rounding of where windows meet.
constexpr double MISS = 1e-9;
/// A way that is shorter by less is not another way.
constexpr double SHORTER = 1 - 1e-13;
/// By how much more than its part a known way may be shorter than the sum that it was found by.
constexpr double ROUNDED = 1 + 1e-9;

double angleBetween(const glm::dvec3& u, const glm::dvec3& v) {
  return std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v));
}

}  // namespace

Geodesic::Geodesic(const Surface& surface, const CancelToken& cancel)
    : surface_(surface),
      cancel_(cancel),
      spreads_(surface.points.size()),
      corners_(surface.points.size(), {INF, INF, {}}) {
  for (std::uint32_t point = 0; point < spreads_.size(); ++point) {
    if (point % EVENTS_PER_CANCEL_CHECK == 0) cancel.check();
    spreads_[point] = spreadsFrom(point) ? 1 : 0;
  }
}

/// Shortest ways bend at corners of more than 2 pi, and at those of the border (Mitchell, Mount and Papadimitriou 1987,
/// lemma 3.3). Where an edge has many faces, or faces touch at the corner alone, they may bend too.
bool Geodesic::spreadsFrom(std::uint32_t point) const {
  const auto faces = surface_.facesAt(point);
  if (faces.empty()) return false;
  double angle = 0;
  for (const std::uint32_t f : faces) {
    const Face& face = surface_.faces[f];
    const int k = Surface::cornerOf(face, point);
    const glm::dvec3& p = surface_.points[point];
    angle += angleBetween(surface_.corner(face, k + 1) - p, surface_.corner(face, k + 2) - p);
    for (const std::uint32_t e : face.edges) {
      const Edge& edge = surface_.edges[e];
      if ((edge.a == point || edge.b == point) && edge.count != 2) return true;
    }
  }
  if (angle > 2 * std::numbers::pi + 1e-10) return true;
  // Around from the first face: what is not reached touches at the corner alone.
  std::size_t seen = 0;
  std::uint32_t face = faces[0], came = NONE;
  do {
    ++seen;
    for (const std::uint32_t e : surface_.faces[face].edges) {
      const Edge& edge = surface_.edges[e];
      if ((edge.a != point && edge.b != point) || e == came) continue;
      const auto both = surface_.facesOf(edge);
      face = both[0] == face ? both[1] : both[0];
      came = e;
      break;
    }
  } while (face != faces[0] && seen <= faces.size());
  return seen != faces.size();
}

EdgeFrame Geodesic::frameOf(std::uint32_t edge, std::uint32_t face) const {
  const Edge& e = surface_.edges[edge];
  const glm::dvec3 &a = surface_.points[e.a], &b = surface_.points[e.b];
  const glm::dvec3& c = surface_.points[oppositeOf(edge, face)];
  const double length = glm::distance(a, b);
  const glm::dvec3 along = (b - a) / length;
  return {length, {glm::dot(c - a, along), glm::length(glm::cross(along, c - a))}};
}

std::uint32_t Geodesic::oppositeOf(std::uint32_t edge, std::uint32_t face) const {
  const Face& f = surface_.faces[face];
  return f.points[f.edges[0] == edge ? 2 : f.edges[1] == edge ? 0 : 1];
}

glm::dvec3 Geodesic::onEdge(std::uint32_t edge, double at) const {
  const Edge& e = surface_.edges[edge];
  return glm::mix(surface_.points[e.a], surface_.points[e.b], at / lengthOf(e));
}

Geodesic::End Geodesic::endOf(const surface::Place& place) const {
  const Face& face = surface_.faces[place.face];
  End end{place.position, NONE, {place.face}};
  for (int k = 0; k < 3; ++k) {
    if (place.weights[k] >= 1 - ON_SIDE) end.point = face.points[static_cast<std::size_t>(k)];
  }
  if (end.point != NONE) {
    end.position = surface_.points[end.point];
    const auto faces = surface_.facesAt(end.point);
    end.faces.assign(faces.begin(), faces.end());
    return end;
  }
  for (int k = 0; k < 3; ++k) {
    if (place.weights[k] > ON_SIDE) continue;
    const auto faces = surface_.facesOf(surface_.edges[face.edges[static_cast<std::size_t>((k + 1) % 3)]]);
    end.faces.assign(faces.begin(), faces.end());
  }
  return end;
}

void Geodesic::reset() {
  for (const std::uint32_t point : touched_) corners_[point] = {INF, INF, {}};
  touched_.clear();
  windows_.clear();
  queue_.clear();
  best_ = INF;
  found_ = false;
  bestLabel_ = {};
}

std::optional<Path> Geodesic::between(const surface::Place& from, const surface::Place& to, double known) {
  reset();
  best_ = known * ROUNDED;
  from_ = endOf(from);
  to_ = endOf(to);
  start();
  for (std::size_t events = 0; !queue_.empty(); ++events) {
    if (events % EVENTS_PER_CANCEL_CHECK == 0) cancel_.check();
    std::pop_heap(queue_.begin(), queue_.end());
    const Event event = queue_.back();
    queue_.pop_back();
    if (event.key >= best_) break;
    event.isWindow ? propagate(event.index) : visitCorner(event.index);
  }
  if (!found_) return std::nullopt;
  return trace();
}

void Geodesic::start() {
  if (from_.point != NONE) {
    reach(from_.point, 0, {});
    return;
  }
  for (const std::uint32_t f : from_.faces) {
    for (const std::uint32_t point : surface_.faces[f].points) {
      reach(point, glm::distance(from_.position, surface_.points[point]), {});
    }
    if (std::find(to_.faces.begin(), to_.faces.end(), f) != to_.faces.end())
      reachEnd(glm::distance(from_.position, to_.position), {});
  }
  for (const std::uint32_t f : from_.faces) {
    for (const std::uint32_t e : surface_.faces[f].edges) {
      const EdgeFrame frame = frameOf(e, f);
      const glm::dvec2 image = flat(e, from_.position);
      push({e, f, NONE, NONE, 0, frame.length, {image.x, -image.y}, 0}, frame);
    }
  }
}

void Geodesic::reach(std::uint32_t point, double distance, const Label& label) {
  if (!isWithin(point)) return;
  Corner& corner = corners_[point];
  if (!(distance < corner.distance * SHORTER)) return;
  const double key = distance + glm::distance(surface_.points[point], to_.position);
  if (corner.distance == INF) touched_.push_back(point);
  corner.distance = distance;
  corner.label = label;
  if (point == to_.point) reachEnd(distance, label);
  if (key >= best_) return;
  queue_.push_back({key, point, false});
  std::push_heap(queue_.begin(), queue_.end());
}

void Geodesic::reachEnd(double distance, const Label& label) {
  if (!(distance < best_ * SHORTER)) return;
  best_ = distance;
  found_ = true;
  bestLabel_ = label;
}

void Geodesic::visitCorner(std::uint32_t point) {
  Corner& corner = corners_[point];
  if (corner.spread <= corner.distance) return;
  corner.spread = corner.distance;
  for (const std::uint32_t f : surface_.facesAt(point)) {
    for (const std::uint32_t other : surface_.faces[f].points) {
      if (other == point) continue;
      reach(other, corner.distance + glm::distance(surface_.points[point], surface_.points[other]),
            {NONE, NONE, point});
    }
    if (to_.point == NONE && std::find(to_.faces.begin(), to_.faces.end(), f) != to_.faces.end()) {
      reachEnd(corner.distance + glm::distance(surface_.points[point], to_.position), {NONE, NONE, point});
    }
  }
  if (spreads_[point] || point == from_.point) spread(point);
}

/// Windows of all faces around the corner, over their sides across from it.
void Geodesic::spread(std::uint32_t point) {
  for (const std::uint32_t f : surface_.facesAt(point)) {
    const Face& face = surface_.faces[f];
    const std::uint32_t e = face.edges[static_cast<std::size_t>((Surface::cornerOf(face, point) + 1) % 3)];
    const EdgeFrame frame = frameOf(e, f);
    push({e, f, NONE, point, 0, frame.length, {frame.apex.x, -frame.apex.y}, corners_[point].distance}, frame);
  }
}

void Geodesic::push(Window window, const EdgeFrame& frame) {
  if (window.image.y == 0 || surface_.edges[window.edge].count < 2) return;  // along the edge, or out of the surface
  const Edge& edge = surface_.edges[window.edge];
  if (!isWithin(edge.a) && !isWithin(edge.b)) return;
  if (!cutByEnds(window, frame.length, corners_[edge.a].distance, corners_[edge.b].distance)) return;
  // No way through the window is shorter than two straight lines that meet on it: those of the flattened target.
  const glm::dvec2 target = flat(window.edge, to_.position);
  const glm::dvec2 meets(std::clamp(window.crossing(target), window.begin, window.end), 0);
  const double key = window.distanceTo(meets) + glm::distance(meets, target);
  if (key >= best_) return;
  if (windows_.size() >= WINDOWS_MAX) {
    throw Error(
        "L_MEASURE",
        "the shortest way over the surface takes too much work: measure a part of the model, or in shorter steps")
        .withLimit("L_MEASURE", static_cast<double>(WINDOWS_MAX), static_cast<double>(WINDOWS_MAX));
  }
  windows_.push_back(window);
  queue_.push_back({key, static_cast<std::uint32_t>(windows_.size() - 1), true});
  std::push_heap(queue_.begin(), queue_.end());
}

void Geodesic::propagate(std::uint32_t window) {
  // Corners may have come nearer since it was pushed.
  const Edge& edge = surface_.edges[windows_[window].edge];
  if (!cutByEnds(windows_[window], lengthOf(edge), corners_[edge.a].distance, corners_[edge.b].distance)) return;
  for (const std::uint32_t face : surface_.facesOf(edge)) {
    if (face != windows_[window].from) propagateInto(window, face);
  }
}

void Geodesic::propagateInto(std::uint32_t index, std::uint32_t f) {
  const Window window = windows_[index];
  const Edge& edge = surface_.edges[window.edge];
  const EdgeFrame frame = frameOf(window.edge, f);
  const std::uint32_t apex = oppositeOf(window.edge, f);
  const double slack = MISS * frame.length;
  const auto sees = [&](const glm::dvec2& p) {
    const double at = window.crossing(p);
    return at >= window.begin - slack && at <= window.end + slack;
  };
  const Label label{index, f, NONE};
  if (sees(frame.apex)) reach(apex, window.distanceTo(frame.apex), label);
  if (to_.point == NONE && std::find(to_.faces.begin(), to_.faces.end(), f) != to_.faces.end()) {
    const glm::dvec2 end = flat(window.edge, to_.position);
    if (sees(end)) reachEnd(window.distanceTo(end), label);
  }
  Children children = childrenOf(window, frame);
  for (const bool onA : {true, false}) {
    Window& child = onA ? children.fromA : children.fromB;
    if (!(child.begin < child.end)) continue;
    const std::uint32_t base = onA ? edge.a : edge.b, across = onA ? edge.b : edge.a;
    for (const std::uint32_t e : surface_.faces[f].edges) {
      const Edge& side = surface_.edges[e];
      if (e == window.edge || (side.a != base && side.b != base)) continue;
      const EdgeFrame childFrame = frameOf(e, f);
      // Lines to the side pass between it and the corner across: a way over that corner to the far end beats them all.
      const glm::dvec2 far =
          glm::mix(glm::dvec2(onA ? 0 : frame.length, 0), frame.apex, child.begin / childFrame.length);
      const double over = corners_[across].distance + glm::distance(glm::dvec2(onA ? frame.length : 0, 0), far);
      if (over < window.distanceTo(far)) continue;
      child.edge = e;
      child.from = f;
      child.parent = index;
      if (side.a != base) turn(child, childFrame.length);
      push(child, childFrame);
    }
  }
}

glm::dvec2 Geodesic::flat(std::uint32_t edge, const glm::dvec3& p) const {
  const Edge& e = surface_.edges[edge];
  const glm::dvec3& a = surface_.points[e.a];
  const glm::dvec3 along = glm::normalize(surface_.points[e.b] - a);
  return {glm::dot(p - a, along), glm::length(glm::cross(along, p - a))};
}

Path Geodesic::trace() const {
  Path path;
  path.points.push_back(to_.position);
  const auto add = [&path](const glm::dvec3& p) {
    if (p != path.points.back()) path.points.push_back(p);
  };
  Label label = bestLabel_;
  while (true) {
    std::uint32_t from = label.point;
    for (std::uint32_t w = label.window; w != NONE; w = windows_[w].parent) {
      const Window& window = windows_[w];
      const double at = window.crossing(flat(window.edge, path.points.back()));
      add(onEdge(window.edge, std::clamp(at, window.begin, window.end)));
      from = window.corner;
    }
    if (from == NONE) break;
    add(surface_.points[from]);
    if (from == from_.point) break;
    label = corners_[from].label;
  }
  add(from_.position);
  std::reverse(path.points.begin(), path.points.end());
  for (std::size_t i = 1; i < path.points.size(); ++i) path.length += glm::distance(path.points[i - 1], path.points[i]);
  return path;
}

}  // namespace telar::measure
