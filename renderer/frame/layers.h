#pragma once
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "telar/image.h"
#include "telar/scene.h"
#include "telar/shot.h"

namespace telar::frame {

/// A surface that lets more light through than this share is not there for a layer: what lies behind it is.
constexpr float LAYER_ALPHA = 0.5f;

/// A material with nothing but what its normal and its base colour are made of: lit, no metal.
std::shared_ptr<const Material> plainMaterial(const Material& material);

/// Numbers of what a scene draws, from 1 on, for the layers partId and materialId.
class LayerIds {
 public:
  explicit LayerIds(const Scene& scene);
  /// @param node  of the scene's own list
  float part(const Node& node) const;
  /// @param index  into Scene::materials, of materialIndex(); -1 = glTF's default one
  float material(int index) const;
  /// [{id, node: index in the file, name}, ...], [{id, material: index in the file or null, name}, ...]: those that are
  /// drawn
  nlohmann::ordered_json parts() const;
  nlohmann::ordered_json materials(const std::string& variant) const;

 private:
  const Scene& scene_;
  std::vector<int> parts_;  ///< by node; 0 = draws nothing
};

/// Writes a layer's channels of one pixel. Coverage and lines are found otherwise.
/// @param seen  what is seen there: depth(), normal(), partId(), materialId(), open(), albedo(), shadow(), of which
///              only the one that is asked for is called
template <class Seen>
void writeLayer(Layer layer, const Seen& seen, float* to) {
  const auto triple = [&](const glm::vec3& v) {
    for (int c = 0; c < 3; ++c) to[c] = v[c];
  };
  switch (layer) {
    case Layer::kDepth:
      *to = seen.depth();
      break;
    case Layer::kNormal:
      triple(seen.normal());
      break;
    case Layer::kPartId:
      *to = seen.partId();
      break;
    case Layer::kMaterialId:
      *to = seen.materialId();
      break;
    case Layer::kAo:
      *to = seen.open();
      break;
    case Layer::kAlbedo:
      triple(seen.albedo());
      break;
    case Layer::kShadow:
      *to = seen.shadow();
      break;
    case Layer::kCoverage:
    case Layer::kLine:
      break;
  }
}

/// `layers` of a frame's info, by name: the range of depths, the legends of numbers.
nlohmann::ordered_json describeLayers(const Scene& scene, const Shot& shot, const std::vector<LayerImage>& layers);

/// Whether the alpha of the picture is the coverage.
bool alphaIsCoverage(const Shot& shot);
/// A shot whose alpha is the coverage of the same picture, without light.
Shot coverageShot(const Shot& shot);
/// @param frame  of such a shot
LayerImage coverageLayer(const Frame& frame);

}  // namespace telar::frame
