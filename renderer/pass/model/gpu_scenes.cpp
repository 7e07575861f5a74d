#include "pass/model/gpu_scenes.h"

#include <utility>

namespace telar::pass {

GpuScene& GpuScenes::of(const std::shared_ptr<const Scene>& scene) {
  GpuScene& gpu = *shared(scene);
  for (const WornCloth& cloth : scene->cloths) {
    std::erase(worn_, cloth.scene.get());
    worn_.push_back(cloth.scene.get());
  }
  while (worn_.size() > CLOTHS_KEPT) {
    scenes_.erase(worn_.front());  // Who wears it has it still.
    worn_.erase(worn_.begin());
  }
  return gpu;
}

const std::shared_ptr<GpuScene>& GpuScenes::shared(const std::shared_ptr<const Scene>& scene) {
  const auto found = scenes_.find(scene.get());
  if (found != scenes_.end()) return found->second;
  GpuScene* model = scene->model ? shared(scene->model).get() : nullptr;
  std::vector<std::shared_ptr<GpuScene>> cloths;
  for (const WornCloth& cloth : scene->cloths) cloths.push_back(shared(cloth.scene));
  auto made = std::make_shared<GpuScene>(context_, textures_, scene, model, std::move(cloths));
  return scenes_.emplace(scene.get(), std::move(made)).first->second;
}

void GpuScenes::release(const Scene& scene) {
  // Scenes that were made of this one (posed, dressed) share its data: they go too.
  std::erase_if(scenes_, [&](const auto& entry) { return entry.second->isMadeOf(scene); });
  scenes_.erase(&scene);
  // A posed scene may be the last owner of the model that it was made of: then nothing draws the model again.
  if (scene.model && scene.model.use_count() == 1) scenes_.erase(scene.model.get());
}

void GpuScenes::forgetReleased() {
  // Poses keep their models alive, so that a model is never forgotten before them.
  std::erase_if(scenes_, [](const auto& entry) { return entry.second->expired(); });
  std::erase_if(worn_, [&](const Scene* cloth) { return !scenes_.contains(cloth); });
}

}  // namespace telar::pass
