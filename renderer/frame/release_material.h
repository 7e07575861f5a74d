#pragma once
#include <map>
#include <memory>
#include <utility>

#include "telar/scene.h"
#include "telar/shading.h"

namespace telar::frame {

/// The materials of a scene as a release of three.js reads them: without the extensions that its GLTFLoader does not
/// know, and with its coordinates of textures (js/docs/families.md). A copy may outlive this and the scene.
class ReleaseMaterials {
 public:
  /// @return null = as it stands, which is so of every material in 0.187
  std::shared_ptr<const Material> of(const Material& material, const Primitive& primitive, const ThreeTerms& three);

 private:
  /// By what the file has, and whether the mesh has second coordinates.
  std::map<std::pair<const Material*, bool>, std::shared_ptr<const Material>> read_;
};

}  // namespace telar::frame
