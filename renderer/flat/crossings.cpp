#include "flat/crossings.h"

#include <algorithm>

namespace telar::flat {
namespace {

using surface::Face;
using surface::Surface;

class Crossings {
 public:
  Crossings(const Surface& surface, const View& view) : surface_(surface), view_(view) {}

  std::vector<Crossing> all(const CancelToken& cancel) {
    const glm::ivec2 cells = view_.cells();
    for (int y = 0; y < cells.y; ++y) {
      cancel.check();
      for (int x = 0; x < cells.x; ++x) inCell({x, y});
    }
    return std::move(crossings_);
  }

 private:
  /// Pairs of faces by their depths: a sweep, as layers that do not touch are the rule.
  void inCell(const glm::ivec2& cell) {
    const auto faces = view_.facesIn(cell);
    if (std::all_of(faces.begin(), faces.end(), [&](std::uint32_t f) { return isOfOnePart(f, faces[0]); })) return;
    byDepth_.clear();
    for (const std::uint32_t f : faces) {
      const auto& [a, b, c] = surface_.faces[f].points;
      const auto [low, high] = std::minmax({view_.point(a).z, view_.point(b).z, view_.point(c).z});
      byDepth_.push_back({low, high, f});
    }
    std::sort(byDepth_.begin(), byDepth_.end(), [](const Span& p, const Span& q) { return p.low < q.low; });
    for (std::size_t i = 0; i < byDepth_.size(); ++i) {
      const Span& first = byDepth_[i];
      for (std::size_t k = i + 1; k < byDepth_.size() && byDepth_[k].low <= first.high; ++k) {
        const std::uint32_t f = first.face, g = byDepth_[k].face;
        // Both may lie in more cells: the first that they share is theirs.
        if (!isOfOnePart(f, g) && glm::max(view_.firstCell(f), view_.firstCell(g)) == cell) cross(f, g);
      }
    }
  }

  bool isOfOnePart(std::uint32_t f, std::uint32_t g) const {
    const surface::Source &p = surface_.sources[surface_.faces[f].source],
                          &q = surface_.sources[surface_.faces[g].source];
    return p.node == q.node && p.material == q.material;
  }

  void cross(std::uint32_t f, std::uint32_t g) {
    const Face &first = surface_.faces[f], &second = surface_.faces[g];
    for (const std::uint32_t p : first.points) {
      if (std::find(second.points.begin(), second.points.end(), p) != second.points.end()) return;
    }
    Crossing crossing;
    crossing.faces = {f, g};
    std::size_t count = 0;
    for (const auto& [edgesOf, into] : {std::pair(f, g), std::pair(g, f)}) {
      for (const std::uint32_t edge : surface_.faces[edgesOf].edges) {
        Crossing::End end{{}, edge, into};
        if (count < 2 && goesThrough(edge, into, end.at)) crossing.ends[count++] = end;
      }
    }
    if (count == 2) crossings_.push_back(crossing);
  }

  /// Where an edge goes through a face (Moeller and Trumbore 1997, with the edge as the ray).
  bool goesThrough(std::uint32_t edge, std::uint32_t face, glm::dvec3& at) const {
    const glm::dvec3 &from = view_.point(surface_.edges[edge].a), &to = view_.point(surface_.edges[edge].b);
    const auto& [i, k, m] = surface_.faces[face].points;
    const glm::dvec3 &a = view_.point(i), u = view_.point(k) - a, v = view_.point(m) - a, way = to - from;
    const glm::dvec3 p = glm::cross(way, v);
    const double volume = glm::dot(u, p);
    if (volume == 0) return false;
    const glm::dvec3 start = from - a, q = glm::cross(start, u);
    const double s = glm::dot(start, p) / volume, t = glm::dot(way, q) / volume, along = glm::dot(v, q) / volume;
    if (s < 0 || t < 0 || s + t > 1 || along < 0 || along > 1) return false;
    at = from + along * way;
    return true;
  }

  struct Span {
    double low, high;
    std::uint32_t face;
  };

  const Surface& surface_;
  const View& view_;
  std::vector<Span> byDepth_;
  std::vector<Crossing> crossings_;
};

}  // namespace

std::vector<Crossing> crossingsOf(const Surface& surface, const View& view, const CancelToken& cancel) {
  return Crossings(surface, view).all(cancel);
}

}  // namespace telar::flat
