#pragma once
#include <vector>

#include "surface/surface.h"
#include "telar/shot.h"

namespace telar::flat {

/// A surface as one camera sees it: pixels, y down, and what is in front of any place. All lines of sight are parallel
/// in pixels, so a grid over the picture finds the triangles at a place, and no hierarchy is needed.
class View {
 public:
  /// @param surface  outlives it
  /// @throws Error{X_CANCELLED}
  View(const surface::Surface& surface, const Shot& shot, const CancelToken& cancel);

  /// Pixels from the top left corner, and the depth 0..1 that is linear in them.
  const glm::dvec3& point(std::uint32_t i) const { return points_[i]; }
  glm::dvec3 project(const glm::dvec3& world) const;
  /// Whether the camera sees it undistorted: beyond the near plane.
  bool isSeen(std::uint32_t i) const { return seen_[i] != 0; }
  /// Metres along the line of sight.
  double metres(double depth) const;

  /// Of what lies across the line of sight so far away.
  double pixelsPerMetre(double metres) const { return orthographic_ ? pixelsPerMetre_ : pixelsPerMetre_ / metres; }

  /// The grid: cells across and down, the triangles in one, and the first cell of one, by rows and columns apart.
  glm::ivec2 cells() const { return cells_; }
  std::span<const std::uint32_t> facesIn(const glm::ivec2& cell) const;
  glm::ivec2 firstCell(std::uint32_t face) const;

  struct Hit {
    double depth = 0;
    std::uint32_t face = surface::NONE;  ///< NONE = background
  };
  /// The nearest triangle at a place.
  Hit nearest(const glm::dvec2& place) const;
  /// Whether a triangle that is none of `own` lies in front of `depth` (metres) there.
  bool isHidden(const glm::dvec2& place, double metresThere, std::span<const std::uint32_t> own) const;
  /// The same of triangles that are more than `away` (metres) from the place, across them: one that is seen nearly from
  /// its edge is far before what it touches.
  bool isHiddenBeyond(const glm::dvec2& place, double metresThere, double away,
                      std::span<const std::uint32_t> own) const;

 private:
  template <class Visit>
  void visit(const glm::dvec2& place, const Visit& visit) const;
  double flatness(std::uint32_t face) const;
  bool cellsOf(std::uint32_t face, glm::ivec2& low, glm::ivec2& high) const;
  void buildGrid(const CancelToken& cancel);

  const surface::Surface& surface_;
  glm::dmat4 toPixel_{1};
  bool orthographic_;
  double near_, far_, pixelsPerMetre_;
  glm::ivec2 size_;
  std::vector<glm::dvec3> points_;
  std::vector<char> seen_;
  double cell_ = 4;  ///< pixels
  glm::ivec2 cells_{0};
  std::vector<std::uint32_t> first_, faces_;
};

}  // namespace telar::flat
