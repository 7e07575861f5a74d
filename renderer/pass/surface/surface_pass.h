#pragma once
#include <map>
#include <optional>

#include "frame/layers.h"
#include "gl/program.h"
#include "ibl/environment_cache.h"
#include "pass/plan/draw_list.h"
#include "pass/surface/ltc.h"
#include "pass/surface/surface_textures.h"
#include "pass/target/transmission_target.h"
#include "pass/visible/visibility_buffer.h"
#include "pass/visible/visible_draws.h"

namespace telar::pass {

/// What all draws of a frame share.
struct SurfaceInputs {
  const FramePlan& plan;
  const Shot& shot;
  const Scene& scene;
  GpuScene& gpu;
  const ibl::Environment* environment;  ///< that lights surfaces, null where the plan needs none
  const ibl::Environment* background;   ///< that is seen, likewise
  const CancelToken& cancel;
  int samples = 1;                                   ///< of a pixel of the target
  const TransmissionTarget* transmission = nullptr;  ///< the resolved transmission target
  const VisibleDraws* visible = nullptr;             ///< what is left of draws; null = all
  VisibilityBuffer* buffer = nullptr;                ///< of draws that read it
  bool captures = false;                             ///< runs the vertex stage of those draws
  int samplePass = 0;                                ///< index of the pass, where a picture takes several
  const frame::LayerIds* ids = nullptr;              ///< of a plan of planLayers()
  const UnreadLevels* unread = nullptr;              ///< of the textures; null = all are read
};

/// The forms of the environment that a frame reads.
struct EnvironmentForms {
  ibl::EnvironmentUses lit;                  ///< by surfaces and background
  std::optional<ibl::EnvironmentUses> seen;  ///< by the background, where it needs a map of its own
};
EnvironmentForms environmentForms(const FramePlan& plan, const Shot& shot);

/// Draws the model's primitives. Keeps its programs for as long as it lives.
class SurfacePass {
 public:
  SurfacePass(const gl::Context& context, Limits limits);

  /// Programs of earlier frames are kept while they are few: a service that sees many kinds of files drops them all at
  /// times. Called where no plan is prepared, for a frame may draw several.
  void forgetMany() {
    if (programs_.size() > 2 * limits_.programs) programs_.clear();
  }
  /// Compiles what the plan needs and does not have yet; returns how many programs that were. @throws Error{X_SHADER,
  /// L_PROGRAMS}
  int prepare(const FramePlan& plan, const CancelToken& cancel);
  /// Uploads the plan's primitives that are not on the GPU yet. @throws Error{L_MEMORY_BYTES, X_GL*}
  void upload(const FramePlan& plan, const Scene& scene, GpuScene& gpu, const CancelToken& cancel);
  /// The same of textures, before anything samples them. Each shaded frame comes by here, and so tells of an image that
  /// is damaged, also where it shows none of it.
  void uploadTextures(const SurfaceInputs& in) {
    waitForImages(in.scene, in.cancel);
    context_.gl().ActiveTexture(GL_TEXTURE0);  // making a texture binds it: not over a shadow map
    textures_.upload(in.plan, in.scene, in.gpu, in.cancel, in.unread);
  }
  /// Unit of the first shadow map, after the units that the pass itself uses.
  static GLuint firstShadowUnit();
  /// Draws lists of the plan, in order. The target is bound and cleared, the shadow maps are bound.
  void draw(std::initializer_list<const std::vector<DrawItem>*> lists, const SurfaceInputs& in);

 private:
  /// Stand-ins for textures that the material lacks. Only the all-features benchmark samples them.
  struct StandIns {
    gl::Texture white, flatNormal, blackCube;
  };
  const StandIns& standIns();
  void bindShared(const SurfaceInputs& in, bool transmission);
  void drawItem(const DrawItem& item, const SurfaceInputs& in);
  /// A program, and what its fragments cost.
  struct Surface {
    gl::Program program;
    gl::DrawCost cost;
  };
  Surface& useProgram(const shader::VariantKey& key, const SurfaceInputs& in);
  void bindMaterial(const gl::Program& program, const DrawItem& item, const SurfaceInputs& in);

  const gl::Context& context_;
  Limits limits_;
  gl::Texture dfg_;
  gl::Texture dfg32_;  ///< of three.js 0.181, from its first frame on
  LtcTextures ltc_;
  SurfaceTextures textures_;
  std::optional<StandIns> standIns_;
  std::map<shader::VariantKey, Surface> programs_;
  const Surface* current_ = nullptr;  // whose frame uniforms are set
};

}  // namespace telar::pass
