#pragma once
#include "gl/context.h"
#include "pass/model/gpu_scene.h"
#include "pass/plan/fragment_estimate.h"
#include "pass/visible/visible_draws.h"

namespace telar::pass {

/// Draws a primitive whose program and state are set. It splits the draw so that each call takes at most one slice of
/// the context's pacer: by ranges of instances, ranges of triangles and parts of the target. The fragments of each
/// pixel keep their order, so the bytes of the picture stay the same.
class SlicedDraw {
 public:
  /// @param target  pixels of the bound target that the viewport shows
  /// @param visible  what is left of draws; null = all
  SlicedDraw(const gl::Context& context, gl::DrawCost& cost, const DrawItem& item, GpuScene& scene,
             const glm::dmat4& worldToClip, const gl::Pacer::Rectangle& target, const VisibleDraws* visible = nullptr);

  /// @throws Error{X_CANCELLED, X_TIMEOUT}
  void run();

 private:
  void runInstances(const Instances& instances);
  void runParts(GLsizei instance);
  void drawParts(std::size_t begin, std::size_t end, GLsizei instance) const;

  const gl::Context& context_;
  gl::Pacer& pacer_;
  gl::DrawCost& cost_;
  const DrawItem& item_;
  const GpuPrimitive& gpu_;
  const PartExtents& extents_;
  FragmentEstimate estimate_;
  PartLayout layout_;
  const VisibleParts* visible_;
  GLuint visibleIndices_;
  gl::Pacer::Rectangle target_;
};

}  // namespace telar::pass
