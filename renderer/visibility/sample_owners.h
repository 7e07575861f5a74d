#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "telar/cancel.h"
#include "visibility/drawn_mesh.h"
#include "visibility/memory.h"
#include "visibility/triangle_setup.h"
#include "visibility/window_vertices.h"

namespace telar::visibility {

/// A triangle of a view: of the meshes in their order, the triangles in theirs.
/// The top bit says that its corners run counter-clockwise in the window.
using Owner = std::uint32_t;
constexpr Owner NO_OWNER = 0xffffffffu, COUNTER_CLOCKWISE = 1u << 31;
inline std::uint32_t numberOf(Owner owner) { return owner & ~COUNTER_CLOCKWISE; }

/// Which triangle each sample of a view shows: what llvmpipe's rasterizer and depth test give, with a rasterizer of its
/// own. Places are rounded to 1/256 pixel and depths cut to 24 bits, so that a sample between two triangles has one
/// owner.
class SampleOwners {
 public:
  struct Part {
    glm::vec2 moved{0};  ///< px by which all is moved in the window
    /// Pixels that are not asked for, the upper row first; empty = none. Some of them have owners still.
    std::span<const std::uint8_t> settled;
  };
  /// Another view in place of this one.
  /// @param meshes  as they are drawn; what they point to outlives this
  /// @param part  of the view
  /// @return false = a triangle reaches behind the camera or beyond the depths, or there are too many: nothing is known
  /// @throws Error{X_CANCELLED, X_TIMEOUT}
  bool look(const SampleGrid& grid, std::span<const PlacedMesh> meshes, const Part& part, const CancelToken& cancel);

  /// Pixels that may be covered: from even ones to odd ones, beyond the window by one where its size is odd.
  const Pixels& covered() const { return covered_; }
  std::size_t width() const { return stride_ * static_cast<std::size_t>(grid_.cell); }  ///< px, of covered()
  std::size_t pixels() const { return samples_.size() * static_cast<std::size_t>(grid_.cell * grid_.cell); }
  /// Of the samples of the cell of a pixel in covered(), SAMPLES of them.
  const Owner* of(int x, int y) const { return samples_[indexOf(x / grid_.cell, y / grid_.cell)].owners; }
  const SampleGrid& grid() const { return grid_; }

  /// Whether no sample shows a triangle that is farther than a plane, but for rounding.
  /// @param depths  of the plane in the depth buffer, at places in the window in pixels
  bool inFrontOf(const Plane& depths) const;

  struct Triangle {
    std::uint32_t mesh, number;
  };
  Triangle triangle(Owner owner) const;
  std::span<const PlacedMesh> meshes() const { return meshes_; }
  const WindowVertices& vertices(std::size_t mesh) const { return vertices_[mesh]; }
  std::size_t triangles() const { return firsts_.empty() ? 0 : firsts_.back(); }

  std::size_t memory() const;

 private:
  struct alignas(16) CellSamples {
    std::int32_t depths[SAMPLES];
    Owner owners[SAMPLES];
  };
  struct Setup;

  /// @param x, y  cell
  std::size_t indexOf(int x, int y) const {
    return static_cast<std::size_t>(y - covered_.fromY / grid_.cell) * stride_ +
           static_cast<std::size_t>(x - covered_.fromX / grid_.cell);
  }
  void begin();
  void findTiles(std::span<const std::uint8_t> settled);
  bool isAskedFor(const Pixels& box) const;
  bool draw(std::size_t mesh, const CancelToken& cancel);
  void drawTriangle(const WindowVertices& vertices, const Corners& at, Faces faces, Owner owner, std::int64_t& steps);
  template <class Rounding, class Edges>
  void coverAs(const Setup& setup, const Edges& edges, std::int64_t& steps);
  template <class Edges>
  void coverFused(const Setup& setup, const Edges& edges, std::int64_t& steps);
  template <class Edges>
  void cover(const Setup& setup, const Edges& edges, std::int64_t& steps);

  bool fused_ = fusesProducts();
  SampleGrid grid_;
  float placesX_[SAMPLES] = {}, placesY_[SAMPLES] = {};  ///< of the samples in a cell
  glm::ivec2 firstPlace_{0}, lastPlace_{0};              ///< of them, in steps of the grid
  std::span<const PlacedMesh> meshes_;
  std::vector<std::uint32_t> firsts_;  ///< number of each mesh's first triangle, and the end
  std::vector<WindowVertices> vertices_;
  std::vector<glm::ivec2> steps_;  ///< of one mesh's vertices: places on the grid of the rasterizer
  Pixels covered_{0, -1, 0, -1};
  std::size_t stride_ = 0;  ///< cells
  std::vector<CellSamples> samples_;
  std::vector<std::uint8_t> tiles_;  ///< by square of pixels: whether one of them is asked for; empty = all
};

}  // namespace telar::visibility
