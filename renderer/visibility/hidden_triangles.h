#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "telar/cancel.h"
#include "visibility/drawn_mesh.h"
#include "visibility/sample_depth.h"
#include "visibility/triangle_fans.h"

namespace telar::visibility {

/// What is left of a mesh.
struct VisibleTriangles {
  std::vector<std::uint32_t> indices;  ///< of its vertices, three a triangle, in their order
  std::vector<std::uint32_t> parts;    ///< which of its triangles these are
  double pixels = 0;                   ///< in the boxes around each of them: touched ones, at most
  double hiddenPixels = 0;             ///< the same of its triangles that are hidden
  std::int64_t steps = 0;              ///< what the search for them cost, as look() says it
};

/// Finds the triangles of a view that own no sample: at each that they may cover, something opaque is in front. Errs
/// towards drawing: what the GL rounds is taken at its worst, so that the picture without the others is the same.
/// Greene, Kass & Miller 1993, "Hierarchical Z-buffer visibility", and Hasselgren, Andersson & Akenine-Moller 2016,
/// "Masked software occlusion culling", test against a depth buffer of the CPU likewise; theirs is coarser than a sample.
class HiddenTriangles {
 public:
  /// Another view in place of this one.
  /// @param meshes  all that it draws, in any order; what they point to outlives it
  /// @throws Error{X_CANCELLED, X_TIMEOUT}
  /// @return what it cost, in pixels that were looked at; the rest is said in what takes as long
  std::int64_t look(const SampleGrid& grid, std::span<const DrawnMesh> meshes, const CancelToken& cancel);

  /// The triangles of one of them that may be seen.
  VisibleTriangles visible(std::size_t mesh, const CancelToken& cancel) const;

  /// Bytes that are kept from view to view.
  std::size_t memory() const;
  /// Forgets the view, and gives back what is kept where that is more than KEPT.
  void release();
  /// Bytes: the depths of a megapixel take half of it, some 300,000 triangles the other.
  static constexpr std::size_t KEPT = 32u << 20;

 private:
  std::int64_t addOccluders(std::size_t mesh, const CancelToken& cancel);
  void addBetween(std::size_t mesh, const Corners& at, const WindowTriangle& triangle, const Sample& sample,
                  std::int64_t& steps);
  /// @return kUnsure where it is not whole in the window
  WindowTriangle::Kind make(std::size_t mesh, const Corners& at, WindowTriangle& out) const;

  SampleGrid grid_;
  std::span<const DrawnMesh> meshes_;
  // Kept from view to view for their memory, up to KEPT.
  std::vector<WindowVertices> vertices_;
  std::vector<Sample> edge_;
  TriangleFans fans_;
  SampleDepth depth_;
};

}  // namespace telar::visibility
