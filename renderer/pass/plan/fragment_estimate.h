#pragma once
#include <functional>
#include <glm/glm.hpp>

#include "pass/model/part_extents.h"
#include "pass/plan/draw_list.h"
#include "telar/cancel.h"

namespace telar::pass {

/// An upper bound of the fragments that the parts of a primitive shade in a picture: the pixels that they touch, hidden
/// or not. Needs no GL.
class FragmentEstimate {
 public:
  /// @param primitive  outlives it    @param toClip  mesh space to clip space    @param width, height  pixels
  FragmentEstimate(const Primitive& primitive, const glm::dmat4& toClip, int width, int height);

  std::size_t parts() const { return layout_.parts; }
  /// Moves the primitive to one of its instances.
  void moveTo(const glm::mat4& instance);

  /// Of one part.
  double of(std::size_t part) const;
  /// Of all parts, or what was counted when it was more than `enough`.
  double all(double enough) const;
  /// A bound for parts of this extent anywhere in the primitive's bounds. It is quick, and not below the estimate. It
  /// is infinite where the bounds reach behind the camera.
  double atMost(const Extent& extent) const;

 private:
  void measure();

  const Primitive* primitive_;
  PartLayout layout_;
  glm::dmat4 base_;
  glm::mat4 toClip_;
  glm::vec2 size_;
  glm::dvec2 pixelsPerMetre_{0};  ///< at most, of what is seen; x and y
};

/// Gives the extents of a primitive's parts.
using ExtentsOf = std::function<const PartExtents&(const Primitive&)>;

/// Fragments of one pass over the picture and over its shadow maps, at most.
/// @param enough  counting stops there
double fragmentsOf(const FramePlan& plan, const Shot& shot, double enough, const CancelToken& cancel);

/// @throws Error{L_FRAGMENTS}
void checkFragments(const FramePlan& plan, const Shot& shot, const ExtentsOf& extents, const Limits& limits,
                    const CancelToken& cancel);

}  // namespace telar::pass
