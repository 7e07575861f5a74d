#pragma once
#include "pass/model/gpu_scene.h"
#include "pass/plan/draw_list.h"
#include "pass/plan/made_texture.h"
#include "pass/plan/texture_slots.h"
#include "pass/texture/texture_bake.h"
#include "pass/visible/unread_levels.h"
#include "telar/limits.h"

namespace telar::pass {

/// The textures that surfaces sample: uploaded, or made of what was uploaded.
class SurfaceTextures {
 public:
  SurfaceTextures(const gl::Context& context, const Limits& limits)
      : memoryBytes_(limits.memoryBytes), baker_(context) {}

  /// Before the first upload, so that a model that takes too much is refused at once. @throws Error{L_MEMORY_BYTES}
  void checkMemory(const FramePlan& plan, const Scene& scene, const GpuScene& gpu) const;
  /// All that the plan's draws sample. @throws Error{X_GL, X_GL_MEMORY, X_CANCELLED}
  void upload(const FramePlan& plan, const Scene& scene, GpuScene& gpu, const CancelToken& cancel,
              const UnreadLevels* unread);

  /// The texture of a slot that the item's material fills; made now if it is not there yet.
  /// @param unread  null = all levels are read
  GLuint texture(const DrawItem& item, const TextureSlot& slot, const Scene& scene, GpuScene& gpu,
                 const CancelToken& cancel, const UnreadLevels* unread);

  /// What of the item's base colour is metal's, for programs with metalMeans; made now if it is not there yet.
  /// @param unread  as of texture()
  GLuint metal(const DrawItem& item, const Scene& scene, GpuScene& gpu, const CancelToken& cancel,
               const UnreadLevels* unread);

  /// How flat the item's warp and weft lie, for programs with yarnRelief; made now if it is not there yet.
  GLuint yarnRelief(const DrawItem& item, const Scene& scene, GpuScene& gpu, const CancelToken& cancel);

  /// The direction across the lines of the item's normal map (TextureBaker), where hasReliefAxis().
  glm::vec2 reliefAxis(const DrawItem& item, const Scene& scene, GpuScene& gpu, const CancelToken& cancel);

 private:
  std::uint64_t memoryBytes_;
  TextureBaker baker_;
};

}  // namespace telar::pass
