#pragma once
#include <limits>
#include <optional>
#include <vector>

#include "measure/window.h"
#include "surface/locate.h"

namespace telar::measure {

/// A way over the surface.
struct Path {
  double length = 0;  ///< metres
  std::vector<glm::dvec3>
      points;  ///< from the first point to the second; straight lines between them lie on the surface
};

/// Shortest ways over a surface of triangles, exact but for rounding. Windows of Chen and Han 1990, "Shortest paths on
/// a polyhedron", in the order of their distance and without those that a way over a corner beats, as Xin and Wang
/// 2009, "Improving Chen and Han's algorithm on the discrete geodesic problem", have it. Each window is cut where a
/// corner of its edge is nearer. So none is ever compared with another, which is what makes it stand bad triangles:
/// flat ones, edges with many faces, corners that faces merely touch at. Windows that lead away from the target are
/// left out: the order is that of the distance plus the straight line that remains (Hart, Nilsson and Raphael 1968).
class Geodesic {
 public:
  /// @param surface, cancel  outlive it
  Geodesic(const surface::Surface& surface, const CancelToken& cancel);

  /// @param known  metres of a way that there is, if it is known: longer ones are not looked at
  /// @return none where no way joins them, or none that is as short
  /// @throws Error{L_MEASURE, X_CANCELLED, X_TIMEOUT}
  std::optional<Path> between(const surface::Place& from, const surface::Place& to,
                              double known = std::numeric_limits<double>::infinity());

  /// Ways keep to these points from now on, and so may be longer than the shortest; empty = to none.
  void confine(std::vector<char> within) { within_ = std::move(within); }

  /// Work of one call: about 400 MB.
  static constexpr std::size_t WINDOWS_MAX = std::size_t{1} << 22;

 private:
  static constexpr std::uint32_t NONE = surface::NONE;

  /// How a place was reached on the way so far.
  struct Label {
    std::uint32_t window = NONE;  ///< through it, into `face`
    std::uint32_t face = NONE;
    std::uint32_t point = NONE;  ///< along a straight line from this corner; NONE without a window = from the start
  };
  struct Corner {
    double distance = 0;
    double spread = 0;  ///< distance when windows last left it
    Label label;
  };
  /// Where a way starts or ends: a corner, or inside of all these faces at once (two where it is on an edge).
  struct End {
    glm::dvec3 position{0};
    std::uint32_t point = NONE;
    std::vector<std::uint32_t> faces;
  };
  struct Event {
    double key;
    std::uint32_t index;
    bool isWindow;
    bool operator<(const Event& other) const { return key != other.key ? key > other.key : index > other.index; }
  };

  End endOf(const surface::Place& place) const;
  bool spreadsFrom(std::uint32_t point) const;
  void reset();
  void start();
  void reach(std::uint32_t point, double distance, const Label& label);
  void reachEnd(double distance, const Label& label);
  void visitCorner(std::uint32_t point);
  void spread(std::uint32_t point);
  void propagate(std::uint32_t window);
  void propagateInto(std::uint32_t window, std::uint32_t face);
  void push(Window window, const EdgeFrame& frame);
  Path trace() const;

  double lengthOf(const surface::Edge& edge) const {
    return glm::distance(surface_.points[edge.a], surface_.points[edge.b]);
  }
  bool isWithin(std::uint32_t point) const { return within_.empty() || within_[point]; }
  EdgeFrame frameOf(std::uint32_t edge, std::uint32_t face) const;
  /// A point of a face laid flat with one of its edges.
  glm::dvec2 flat(std::uint32_t edge, const glm::dvec3& p) const;
  glm::dvec3 onEdge(std::uint32_t edge, double at) const;
  std::uint32_t oppositeOf(std::uint32_t edge, std::uint32_t face) const;

  const surface::Surface& surface_;
  const CancelToken& cancel_;
  std::vector<char> within_;   ///< by point; empty = all
  std::vector<char> spreads_;  ///< by point: shortest ways may bend there
  std::vector<Corner> corners_;
  std::vector<std::uint32_t> touched_;
  std::vector<Window> windows_;
  std::vector<Event> queue_;
  End from_, to_;
  double best_ = 0;
  bool found_ = false;
  Label bestLabel_;
};

}  // namespace telar::measure
