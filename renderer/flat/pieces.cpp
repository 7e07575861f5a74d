#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

#include "flat/crossings.h"
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
/// Part of the extent that lies before an edge without hiding it: layers that are sewn together bend differently
/// between their corners. Half a millimetre on a garment of a metre.
constexpr double LAYER_OF_EXTENT = 5e-4;

/// Part of the extent within which sewn parts run into one another: there neither's border is seen, but the line where
/// one goes into the other. Two millimetres on a garment of a metre, and three across the surface.
constexpr double SEWN_OF_EXTENT = 2e-3, SEWN_ACROSS_OF_EXTENT = 3e-3;

/// Pixels by which pieces that go on into one another may lie apart.
constexpr double BEND = 3;

/// What is drawn at a place of an edge.
struct Mark {
  Kind kind;
  bool fold = false;
  double offset = 0;  ///< pixels across the edge
};

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
      : surface_(surface),
        view_(view),
        options_(options),
        creaseCosine_(std::cos(options.creaseAngle * std::numbers::pi / 180)) {
    const double extent = surface.bounds.diagonal();
    layer_ = LAYER_OF_EXTENT * extent, sewn_ = SEWN_OF_EXTENT * extent, across_ = SEWN_ACROSS_OF_EXTENT * extent;
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
    addCrossings(cancel);
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
    const auto own = surface_.facesOf(edge);
    addSegment(a, b, edge.a, edge.b, [&](const glm::dvec3& p, const glm::dvec2& normal) -> std::optional<Mark> {
      const double metres = view_.metres(p.z);
      if (!view_.isHidden(glm::dvec2(p), metres - layer_, own)) return markAt(p, normal, feature);
      if (feature.border && !view_.isHiddenBeyond(glm::dvec2(p), metres, sewn_, own)) return sewnAt(p, normal, metres);
      return std::nullopt;
    });
  }

  void addLine(const surface::Line& line) {
    for (std::size_t i = 1; i < line.points.size(); ++i) {
      const glm::dvec3 a = view_.project(line.points[i - 1]), b = view_.project(line.points[i]);
      const std::uint32_t from = i == 1 ? nextNode_++ : lastNode_;
      lastNode_ = nextNode_++;
      addSegment(a, b, from, lastNode_, [&](const glm::dvec3& p, const glm::dvec2&) -> std::optional<Mark> {
        if (view_.isHidden(glm::dvec2(p), view_.metres(p.z) - layer_, {})) return std::nullopt;
        return Mark{Kind::kStitch};
      });
    }
  }

  /// Where one part runs through another: a border of both.
  void addCrossings(const CancelToken& cancel) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> nodes;
    for (const Crossing& crossing : crossingsOf(surface_, view_, cancel)) {
      const auto nodeOf = [&](const Crossing::End& end) {
        const auto [node, isNew] = nodes.try_emplace({end.edge, end.face}, nextNode_);
        if (isNew) ++nextNode_;
        return node->second;
      };
      const auto& [from, to] = crossing.ends;
      addSegment(from.at, to.at, nodeOf(from), nodeOf(to),
                 [&](const glm::dvec3& p, const glm::dvec2& normal) -> std::optional<Mark> {
                   if (view_.isHidden(glm::dvec2(p), view_.metres(p.z) - layer_, crossing.faces)) return std::nullopt;
                   return markAt(p, normal, {false, true, false});
                 });
    }
  }

  Kind seamBetween(const View::Hit& left, const View::Hit& right) const {
    const auto isStitched = [this](const View::Hit& hit) {
      return hit.face != surface::NONE && !options_.stitched.empty() &&
             options_.stitched[surface_.faces[hit.face].source];
    };
    return isStitched(left) || isStitched(right) ? Kind::kStitch : Kind::kSeam;
  }

  /// What a visible edge is there, by what lies on its two sides; none = a fold that is not drawn.
  std::optional<Mark> markAt(const glm::dvec3& p, const glm::dvec2& normal, const Feature& feature) const {
    const View::Hit left = view_.nearest(glm::dvec2(p) + BESIDE * normal),
                    right = view_.nearest(glm::dvec2(p) - BESIDE * normal);
    const bool outside = left.face == surface::NONE || right.face == surface::NONE;
    if (feature.turns || feature.border) {
      if (outside) return Mark{Kind::kSilhouette};
      if (jump(left, right) > options_.foldDepth) return Mark{Kind::kContour, !differ(left, right)};
    }
    // A part that turns away before another ends there, however near they lie. A border on its own part, without a
    // step, is not seen.
    if ((feature.border || feature.turns) && differ(left, right)) return Mark{seamBetween(left, right)};
    if (feature.border && jump(left, right) > layer_) return Mark{seamBetween(left, right)};
    if (feature.crease) return Mark{Kind::kCrease, true};
    return std::nullopt;
  }

  double jump(const View::Hit& left, const View::Hit& right) const {
    return std::abs(view_.metres(left.depth) - view_.metres(right.depth));
  }

  /// Where, across a border just below another surface, one part goes into the other.
  std::optional<Mark> sewnAt(const glm::dvec3& p, const glm::dvec2& normal, double metres) const {
    const int reach = static_cast<int>(std::min(32.0, std::ceil(across_ * view_.pixelsPerMetre(metres) / BESIDE)));
    const auto hitAt = [&](int i) { return view_.nearest(glm::dvec2(p) + i * BESIDE * normal); };
    for (int i = 0; i < reach; ++i) {
      for (const int k : {i, -i - 1}) {
        const View::Hit left = hitAt(k), right = hitAt(k + 1);
        if (differ(left, right) && jump(left, right) <= options_.foldDepth)
          return Mark{seamBetween(left, right), false, (k + 0.5) * BESIDE};
      }
    }
    return std::nullopt;
  }

  bool differ(const View::Hit& left, const View::Hit& right) const {
    if (left.face == surface::NONE || right.face == surface::NONE) return false;
    const surface::Source &p = surface_.sources[surface_.faces[left.face].source],
                          &q = surface_.sources[surface_.faces[right.face].source];
    return p.node != q.node || p.material != q.material;
  }

  /// Looks along a segment, and draws what `markAt` sees: runs on the segment as they are, those beside it point by
  /// point.
  template <class MarkAt>
  void addSegment(const glm::dvec3& a, const glm::dvec3& b, std::uint32_t from, std::uint32_t to,
                  const MarkAt& markAt) {
    const glm::dvec2 along(b - a);
    const double length = glm::length(along);
    if (!(length > 0) || !(length < 1e7)) return;
    const glm::dvec2 normal = glm::dvec2(-along.y, along.x) / length;
    const auto steps = static_cast<int>(std::clamp(std::ceil(length / STEP), 1.0, STEPS_MAX));
    const auto place = [&](double at, const Mark& mark) {
      return glm::dvec2(glm::mix(a, b, at)) + mark.offset * normal;
    };
    std::optional<Mark> last;
    double begin = 0;
    std::uint32_t node = from;
    const auto end = [&](double at, std::uint32_t there) {
      if (last) pieces_.push_back({last->kind, last->fold, node, there, place(begin, *last), place(at, *last)});
      begin = at;
      node = there;
    };
    for (int i = 0; i < steps; ++i) {
      const std::optional<Mark> mark = markAt(glm::mix(a, b, (i + 0.5) / steps), normal);
      const bool same =
          mark.has_value() == last.has_value() &&
          (!mark || (mark->kind == last->kind && mark->fold == last->fold && mark->offset == last->offset));
      if (i > 0 && !same) {
        end(double{1} * i / steps, nextNode_++);
        if (mark && last && std::abs(mark->offset - last->offset) > BEND) node = nextNode_++;
      }
      if (i == 0 && mark && std::abs(mark->offset) > BEND) node = nextNode_++;
      last = mark;
    }
    end(1, last && std::abs(last->offset) > BEND ? nextNode_++ : to);
  }

  const Surface& surface_;
  const View& view_;
  const FlatOptions& options_;
  double creaseCosine_, layer_ = 0, sewn_ = 0, across_ = 0;
  std::uint32_t nextNode_, lastNode_ = 0;
  std::vector<Piece> pieces_;
};

}  // namespace

std::vector<Piece> visiblePieces(const Surface& surface, const View& view, const FlatOptions& options,
                                 const CancelToken& cancel) {
  return Pieces(surface, view, options).all(cancel);
}

}  // namespace telar::flat
