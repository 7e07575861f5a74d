#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "frame/camera.h"
#include "pass/plan/light_choice.h"
#include "shader/variant_key.h"
#include "telar/limits.h"
#include "telar/scene.h"
#include "telar/shot.h"

namespace telar::pass {

/// One shadow map as three.js makes it. Today that is a square depth texture of a directional or spot light, or a cube
/// of a point light. Before 0.182 it is packed: bytes in a colour texture, an atlas of six faces for a point light.
struct ShadowMap {
  Shot::Light::Type type;
  Shot::Light::Shadow settings;
  std::vector<frame::Camera> views;  ///< what the map sees: 1, or the faces +x -x +y -y +z -z
  glm::dmat4 matrix{1.0};  ///< world, counted from worldOrigin(), to map coordinates, 0..1 after / w; to the vector
                           ///< from the light for a point light
  bool lit = false;        ///< the light lights surfaces too; else only the ground shows its shadow
  bool packed = false;
};

/// The shadow maps of a frame. Those of lights that shine on surfaces come first in each list, spot before directional.
struct ShadowSet {
  std::vector<ShadowMap> flat;  ///< spot and directional lights
  std::vector<ShadowMap> cube;  ///< point lights
  std::size_t casting = 0;      ///< lights that cast a shadow, those included whose maps nothing reads
  std::size_t leftOut = 0;      ///< of them: without a map
  std::uint64_t leftOutTexels = 0;

  /// Writes the numbers of maps that surfaces read into a key.
  void describe(shader::VariantKey& key) const;
  bool empty() const { return flat.empty() && cube.empty(); }
};

/// "directional", "spot" or "point".
const char* nameOf(Shot::Light::Type type);

/// The shot's chosen lights with castShadow; lights of the model cast none, as in three.js's GLTFLoader. A light that
/// lights nothing has a map where the shot has a ground, which shows its shadow.
/// @param bounds  of the scene, world space
/// @throws Error{L_SHADOW_TEXELS}
ShadowSet collectShadows(const Shot& shot, const LightChoice& chosen, const Limits& limits, const Bounds& bounds);

}  // namespace telar::pass
