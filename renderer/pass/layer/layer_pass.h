#pragma once
#include <array>

#include "pass/shadow/ground_pass.h"
#include "pass/shadow/shadow_pass.h"
#include "pass/surface/surface_pass.h"

namespace telar::pass {

/// What layers are drawn with, of the renderer that draws the picture.
struct LayerInputs {
  const Scene& scene;
  const Shot& shot;
  GpuScene& gpu;
  SurfacePass& surfaces;
  ShadowPass& shadows;
  GroundPass& ground;
  const Limits& limits;
  const CancelToken& cancel;
};

/// Draws the layers beside a picture: one pass over the model, one sample at the centre of each pixel, into textures
/// of floats. Owns nothing between frames but programs.
class LayerPass {
 public:
  explicit LayerPass(const gl::Context& context) : context_(context) {}

  /// All layers of the shot but coverage, in its order.
  std::vector<LayerImage> draw(const LayerInputs& in);

 private:
  static constexpr std::size_t TEXTURES = 3;  ///< as layers/layers.frag writes them
  /// Textures with a depth buffer, as large as the picture.
  struct Target {
    gl::Framebuffer framebuffer;
    std::array<gl::Texture, TEXTURES> textures;
    gl::Renderbuffer depth;
  };
  Target makeTarget(const Shot& shot) const;
  /// Shadows on the ground where no surface is before it, 0..1 for each pixel, times its opacity.
  std::vector<glm::vec4> groundShadow(const Target& target, const FramePlan& plan, const LayerInputs& in) const;

  const gl::Context& context_;
};

}  // namespace telar::pass
