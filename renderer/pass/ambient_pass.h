#pragma once
#include "pass/shadow_pass.h"

namespace telar::pass {

/// What ambient occlusion is drawn with.
struct AmbientInputs {
  FramePlan& plan;  ///< of planLayers(); its shadow maps are replaced
  const Shot& shot;
  const Scene& scene;
  GpuScene& gpu;
  const CancelToken& cancel;
};

/// Ambient occlusion by depth maps from directions spread evenly over the sphere: at each pixel the mean of those whose
/// light arrives, weighted by the cosine to the geometric normal. Without noise, and the same for every pixel: what
/// is open on all sides is 1 to the last bit.
class AmbientPass {
 public:
  explicit AmbientPass(const gl::Context& context) : context_(context), maps_(context) {}

  /// @param place, number  as layers/layers.frag writes them
  /// @return a texture: x the sum of the weights whose light arrives, y of all; 0 where nothing is seen
  gl::Texture draw(const AmbientInputs& in, const gl::Texture& place, const gl::Texture& number);

 private:
  const gl::Context& context_;
  ShadowPass maps_;
  gl::Program program_;
  gl::VertexArray noVertices_;
  gl::DrawCost cost_{4};
};

}  // namespace telar::pass
