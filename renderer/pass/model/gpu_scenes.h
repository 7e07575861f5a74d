#pragma once
#include <map>
#include <memory>
#include <vector>

#include "pass/model/gpu_scene.h"

namespace telar::pass {

/// The scenes that a context has data of, each made when it is first drawn.
class GpuScenes {
 public:
  explicit GpuScenes(const gl::Context& context) : context_(context), textures_(context) {}

  /// Of a scene that is drawn now. Cloths that it wears stay when it goes, for the next models: those that were worn
  /// last.
  GpuScene& of(const std::shared_ptr<const Scene>& scene);
  /// Frees what is of a scene and of those that were made of it.
  void release(const Scene& scene);
  /// Frees what is of scenes that nobody has any more.
  void forgetReleased();
  /// Textures without a model, which are there for the next one of their size.
  int keptTextures() const { return textures_.keptCount(); }

  /// Cloths whose textures stay without a model that wears them. A bundled one takes at most 4 MiB.
  static constexpr std::size_t CLOTHS_KEPT = 8;

 private:
  const std::shared_ptr<GpuScene>& shared(const std::shared_ptr<const Scene>& scene);

  const gl::Context& context_;
  TextureStore textures_;  ///< outlives the scenes, whose textures it keeps
  std::map<const Scene*, std::shared_ptr<GpuScene>> scenes_;
  std::vector<const Scene*> worn_;  ///< cloths of scenes_, the one that was worn last, last
};

}  // namespace telar::pass
