#pragma once
#include <map>
#include <vector>

#include "gl/program.h"
#include "pass/model/gpu_scene.h"
#include "pass/plan/draw_list.h"

namespace telar::pass {

/// Draws the shadow maps of a frame: the depth of the model as each light sees it. Maps and programs are kept for the
/// next frame. A frame that needs fewer maps frees them.
class ShadowPass {
 public:
  explicit ShadowPass(const gl::Context& context) : context_(context) {}

  /// Binds framebuffers of its own. @throws Error{L_OUTPUT_SIZE, X_GL_MEMORY, X_SHADER}
  void draw(const FramePlan& plan, const Scene& scene, GpuScene& gpu, const CancelToken& cancel);
  /// Binds every map of the frame to a unit of its own from `firstUnit` on: flat ones, then cubes.
  void bind(const ShadowSet& shadows, GLuint firstUnit) const;

 private:
  /// What a target is made for.
  struct Kind {
    bool cube = false, packed = false;
    int size = 0;  ///< texels on a side of a face
    auto operator<=>(const Kind&) const = default;
    GLenum texture() const { return cube && !packed ? GL_TEXTURE_CUBE_MAP : GL_TEXTURE_2D; }
  };
  struct Target {
    Kind kind;
    gl::Texture texture;
    gl::Renderbuffer depth;               ///< of packed maps
    std::vector<gl::Framebuffer> planes;  ///< one a face, or one for the atlas
  };
  /// What one caster program has compiled in.
  struct CasterKey {
    bool alphaMap = false, everyHole = false, uv1 = false, instancing = false, packedDepth = false,
         packedDistance = false;
    int packing = 0, samplerPrecision = 0;  ///< of ThreeTerms
    auto operator<=>(const CasterKey&) const = default;
  };

  void resize(const ShadowSet& shadows);
  Target makeTarget(const Kind& kind) const;
  void makeDepthPlanes(Target& target) const;
  void makePackedPlane(Target& target) const;
  /// A program, and what its fragments cost.
  struct Caster {
    gl::Program program;
    gl::DrawCost cost;
  };
  void drawView(const ShadowMap& map, std::size_t face, const FramePlan& plan, const Scene& scene, GpuScene& gpu,
                const CancelToken& cancel);
  Caster& caster(CasterKey key);

  const gl::Context& context_;
  std::vector<Target> targets_;  // flat ones, then cubes
  std::map<CasterKey, Caster> casters_;
};

/// Sets what shaders/shadow needs of the first `flat` and `cube` maps, which are bound from `firstUnit` on.
void uploadShadows(const gl::Program& program, const ShadowSet& shadows, std::size_t flat, std::size_t cube,
                   GLuint firstUnit);

}  // namespace telar::pass
