#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "flat/flat.h"

namespace telar::flat {
namespace {

using surface::Edge;
using surface::Face;
using surface::Surface;

constexpr std::size_t EDGES_PER_CANCEL_CHECK = 1 << 8;
/// Pixels between looks along an edge: an occluder that is narrower may be missed.
constexpr double STEP = 0.5;
/// Looks along one edge: beyond, it leaves the picture by far.
constexpr double STEPS_MAX = 32768;
/// Pixels beside a line where its two sides are looked at: within a pixel of it, and clear of its own rounding.
constexpr double BESIDE = 0.6;
/// Part of the extent that lies before an edge without hiding it: layers that are sewn together bend differently between
/// their corners. Half a millimetre on a garment of a metre.
constexpr double LAYER_OF_EXTENT = 5e-4;

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

/// What an edge is by itself, whatever lies around it.
struct Feature {
  bool turns = false;   ///< in the picture both faces lie on one side of it
  bool border = false;  ///< open, or between parts or materials
  bool crease = false;
  bool any() const { return turns || border || crease; }
};

class Pieces {
 public:
  Pieces(const Surface& surface, const View& view, const FlatOptions& options)
      : surface_(surface), view_(view), options_(options), creaseCosine_(std::cos(options.creaseAngle * std::numbers::pi / 180)) {
    layer_ = LAYER_OF_EXTENT * glm::distance(surface.bounds.min, surface.bounds.max);
    nextNode_ = static_cast<std::uint32_t>(surface.points.size());
  }

  std::vector<Piece> all(const CancelToken& cancel) {
    for (std::size_t e = 0; e < surface_.edges.size(); ++e) {
      if (e % EDGES_PER_CANCEL_CHECK == 0) cancel.check();
      const Edge& edge = surface_.edges[e];
      if (!view_.isSeen(edge.a) || !view_.isSeen(edge.b)) continue;
      const Feature feature = featureOf(edge);
      if (feature.any()) addEdge(edge, feature);
    }
    for (const surface::Line& line : surface_.lines) {
      cancel.check();
      addLine(line);
    }
    return std::move(pieces_);
  }

 private:
  Feature featureOf(const Edge& edge) const {
    const auto faces = surface_.facesOf(edge);
    if (faces.size() == 1) return {false, true, false};
    Feature feature;
    const Face& first = surface_.faces[faces[0]];
    for (const std::uint32_t f : faces.subspan(1)) {
      const Face& other = surface_.faces[f];
      const surface::Source &p = surface_.sources[first.source], &q = surface_.sources[other.source];
      feature.border |= p.node != q.node || p.material != q.material;
      const int sides = sideOf(edge, first) + sideOf(edge, other);
      feature.turns |= std::abs(sides) > 0;  // one side twice, or one and a face that is seen from its edge
      const glm::dvec3 n = normalOf(edge, first), m = normalOf(edge, other);
      feature.crease |= n != glm::dvec3(0) && m != glm::dvec3(0) && glm::dot(n, -m) < creaseCosine_;
    }
    return feature;
  }

  std::uint32_t apexOf(const Edge& edge, const Face& face) const {
    for (const std::uint32_t p : face.points) {
      if (p != edge.a && p != edge.b) return p;
    }
    return face.points[0];
  }

  /// 1 or -1 by the side of the edge that the face lies on in the picture, 0 where it is seen from its edge.
  int sideOf(const Edge& edge, const Face& face) const {
    const glm::dvec2 a(view_.point(edge.a)), along = glm::dvec2(view_.point(edge.b)) - a;
    const glm::dvec2 toApex = glm::dvec2(view_.point(apexOf(edge, face))) - a;
    const double side = cross(along, toApex);
    constexpr double FLAT = 1e-9;  // a sine
    if (std::abs(side) <= FLAT * glm::length(along) * glm::length(toApex)) return 0;
    return side > 0 ? 1 : -1;
  }

  /// Unit normal of a face whose first side is this edge from a to b: two faces that go on into one another have
  /// opposite ones, however they are wound. Zero for a needle, whose normal is rounding.
  glm::dvec3 normalOf(const Edge& edge, const Face& face) const {
    const glm::dvec3& a = surface_.points[edge.a];
    const glm::dvec3 along = surface_.points[edge.b] - a, toApex = surface_.points[apexOf(edge, face)] - a;
    const glm::dvec3 n = glm::cross(along, toApex);
    constexpr double NEEDLE = 1e-3;  // a sine
    const double length = glm::length(n);
    return length > NEEDLE * glm::length(along) * glm::length(toApex) ? n / length : glm::dvec3(0);
  }

  void addEdge(const Edge& edge, const Feature& feature) {
    const glm::dvec3 &a = view_.point(edge.a), &b = view_.point(edge.b);
    const bool stitched = isStitched(edge);
    addSegment(a, b, edge.a, edge.b, [&](const glm::dvec3& p, const glm::dvec2& normal) -> std::optional<Kind> {
      if (view_.isHidden(glm::dvec2(p), view_.metres(p.z) - layer_, surface_.facesOf(edge))) return std::nullopt;
      return kindAt(p, normal, feature, stitched);
    });
  }

  void addLine(const surface::Line& line) {
    for (std::size_t i = 1; i < line.points.size(); ++i) {
      const glm::dvec3 a = view_.project(line.points[i - 1]), b = view_.project(line.points[i]);
      const std::uint32_t from = i == 1 ? nextNode_++ : lastNode_;
      lastNode_ = nextNode_++;
      addSegment(a, b, from, lastNode_, [&](const glm::dvec3& p, const glm::dvec2&) -> std::optional<Kind> {
        if (view_.isHidden(glm::dvec2(p), view_.metres(p.z) - layer_, {})) return std::nullopt;
        return Kind::kStitch;
      });
    }
  }

  bool isStitched(const Edge& edge) const {
    if (options_.stitched.empty()) return false;
    for (const std::uint32_t f : surface_.facesOf(edge)) {
      if (options_.stitched[surface_.faces[f].source]) return true;
    }
    return false;
  }

  /// What a visible edge is there, by what lies on its two sides; none = a fold that is not drawn.
  std::optional<Kind> kindAt(const glm::dvec3& p, const glm::dvec2& normal, const Feature& feature, bool stitched) const {
    const View::Hit left = view_.nearest(glm::dvec2(p) + BESIDE * normal), right = view_.nearest(glm::dvec2(p) - BESIDE * normal);
    const bool outside = left.face == surface::NONE || right.face == surface::NONE;
    if (outside && (feature.turns || feature.border)) return Kind::kSilhouette;
    if (!outside && (feature.turns || feature.border)) {
      const double jump = std::abs(view_.metres(left.depth) - view_.metres(right.depth));
      if (jump > options_.foldDepth) return Kind::kContour;
    }
    if (feature.border) return stitched ? Kind::kStitch : Kind::kSeam;
    if (feature.crease) return Kind::kCrease;
    return std::nullopt;
  }

  template <class KindAt>
  void addSegment(const glm::dvec3& a, const glm::dvec3& b, std::uint32_t from, std::uint32_t to, const KindAt& kindAt) {
    const glm::dvec2 along(b - a);
    const double length = glm::length(along);
    if (!(length > 0) || !(length < 1e7)) return;
    const glm::dvec2 normal = glm::dvec2(-along.y, along.x) / length;
    const auto steps = static_cast<int>(std::clamp(std::ceil(length / STEP), 1.0, STEPS_MAX));
    const auto at = [&](int i) { return (i + 0.5) / steps; };
    std::optional<Kind> kind = kindAt(glm::mix(a, b, at(0)), normal);
    double begin = 0;
    std::uint32_t node = from;
    for (int i = 1; i <= steps; ++i) {
      const std::optional<Kind> next = i < steps ? kindAt(glm::mix(a, b, at(i)), normal) : std::nullopt;
      if (i < steps && next == kind) continue;
      const double end = i < steps ? double{1} * i / steps : 1;
      const std::uint32_t last = i < steps ? nextNode_++ : to;
      if (kind) pieces_.push_back({*kind, node, last, glm::dvec2(glm::mix(a, b, begin)), glm::dvec2(glm::mix(a, b, end))});
      kind = next;
      begin = end;
      node = last;
    }
  }

  const Surface& surface_;
  const View& view_;
  const FlatOptions& options_;
  double creaseCosine_, layer_;
  std::uint32_t nextNode_, lastNode_ = 0;
  std::vector<Piece> pieces_;
};

}  // namespace

std::vector<Piece> visiblePieces(const Surface& surface, const View& view, const FlatOptions& options, const CancelToken& cancel) {
  return Pieces(surface, view, options).all(cancel);
}

}  // namespace telar::flat
